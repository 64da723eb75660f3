(* The mapping loop: scan after scan into the grid (the lesson's first flow
   chart). *)

BeginPackage["OccupancyGrid`"];

MapScenario::usage = "MapScenario[scenario, seed] maps all scans of a \
scenario and gives the grid, whose log-odds LogOdds tells; without noise \
where seed is None. MapScenario[scenario, seed, afterScan] calls \
afterScan[number, grid] after each scan.";

Begin["`Private`"];

(* [snippet: map-scenario] *)
MapScenario[scenario_, seed_, afterScan_: Null] := Module[
  {settings, grid, angles, number = -1},
  settings = scenario["settings"];
  grid = newGrid[settings];
  angles = BeamAngles[settings["fov"], settings["beams"]];
  Do[
    number = number + 1;
    UpdateGridFromScan[grid,
      simulatedScan[scan, scenario["walls"], angles, settings, seed, number],
      settings["max_range"], settings["no_return"]];
    If[afterScan =!= Null, afterScan[number, grid]],
    {scan, scenario["scans"]}];
  grid];

(* a scan {pose, angles, ranges}; a bare pose is simulated, with noise *)
simulatedScan[scan_, walls_, angles_, settings_, seed_, number_] :=
  If[ListQ[First[scan]],
    scan,
    With[{
        zMax = settings["max_range"]},
      With[{ranges = SimulateLidarScan[scan, walls, angles, zMax]},
        {scan, angles, If[seed === None,
          ranges,
          AddRangeNoise[
            ranges, settings["noise_std"], seed, number, zMax]]}]]];
(* [/snippet] *)

newGrid[settings_] := NewGrid[
  GridSpec[settings["width"], settings["height"], settings["resolution"],
    settings["origin_x"], settings["origin_y"]],
  settings["p0"], settings["p_occ"], settings["p_free"],
  settings["l_min"], settings["l_max"]];

End[];
EndPackage[];
