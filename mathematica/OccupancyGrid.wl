(* Occupancy grid mapping in the Wolfram Language, the same bits in every
   language. SPEC.md is the contract behind it.

   OccupancyGrid/Usage.wl declares every public name before any code is read:
   a name that is first read in the private context stays there, and nobody
   defines it. The modules follow; each keeps its other names in
   OccupancyGrid`Private`.

   Get (or Needs) reads this file. Where it lies is known from
   $InputFileName; on woxi that is the script that runs, so the package is
   looked for around the script and the working directory too. A script that
   lies elsewhere sets $OccupancyGridFolder first. *)

BeginPackage["OccupancyGrid`"];

(* read here first, and so in this context *)
$OccupancyGridFolder;
OccupancyGrid::folder = "woxi does not say where OccupancyGrid.wl lies. Run \
the script from the folder mathematica or the one above it, or set \
$OccupancyGridFolder to the folder mathematica before Get.";

Begin["OccupancyGrid`Private`"];

packageFolders = Select[
  Join[
    If[StringQ[$OccupancyGridFolder], {$OccupancyGridFolder}, {}],
    Flatten[Outer[
      FileNameJoin[{#1, #2}] &,
      {DirectoryName[$InputFileName], Directory[]},
      {".", "mathematica", "..", FileNameJoin[{"..", "mathematica"}],
        FileNameJoin[{"..", "..", "mathematica"}]}]]],
  FileExistsQ[FileNameJoin[{#, "OccupancyGrid", "Usage.wl"}]] &];

(* Nothing that uses the package can go on without it, and on woxi a script
   would: it ends here with a status other than 0. *)
If[packageFolders === {},
  Message[OccupancyGrid::folder];
  Exit[1]];

moduleFolder = FileNameJoin[{First[packageFolders], "OccupancyGrid"}];
Scan[
  Get[FileNameJoin[{moduleFolder, # <> ".wl"}]] &,
  {"Usage", "Arguments", "PortableMath", "Noise", "Grid", "Ray", "World",
    "Sensor", "Scenario", "Lesson", "Mapper", "Fast", "MapWriter", "MapFiles",
    "Picture", "Main"}];

End[];
EndPackage[];
