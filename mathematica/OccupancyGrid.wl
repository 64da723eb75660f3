(* Occupancy grid mapping in the Wolfram Language, the same bits in every
   language. SPEC.md is the contract behind it.

   The package's rooms are the files in OccupancyGrid/: PortableMath, Noise,
   Grid, Ray, World, Sensor, Scenario, Lesson, Mapper, MapWriter, Picture and
   Main. Each adds its public names to the context OccupancyGrid` and keeps the
   rest in OccupancyGrid`Private`. Names are written without their context
   everywhere: woxi, which runs the package where no Wolfram kernel is, reads
   BeginPackage and Begin but keeps all symbols in one context. For the same
   reason the rooms are looked for beside this file and beside the script that
   runs, since $InputFileName is the script there. *)

With[{folder = SelectFirst[
    Map[FileNameJoin[{DirectoryName[$InputFileName], #, "OccupancyGrid"}] &,
      {".", ".."}],
    FileExistsQ[FileNameJoin[{#, "PortableMath.wl"}]] &]},
  Scan[
    Get[FileNameJoin[{folder, # <> ".wl"}]] &,
    {"PortableMath", "Noise", "Grid", "Ray", "World", "Sensor", "Scenario",
      "Lesson", "Mapper", "MapWriter", "Picture", "Main"}]];
