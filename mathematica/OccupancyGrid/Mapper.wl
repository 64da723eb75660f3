(* The mapping loop: scan after scan into the grid (the lesson's first flow
   chart). *)

Begin["OccupancyGrid`Private`"];

scenarioQ[scenario_] := AssociationQ[scenario] &&
  AssociationQ[scenario["settings"]] && ListQ[scenario["scans"]];
seedQ[seed_] := seed === None || IntegerQ[seed] && 0 <= seed < 2^32;

(* [snippet: map-scenario] *)
MapScenario[scenario_?scenarioQ, seed_?seedQ] := Module[
  {grid = NewGrid[scenario["settings"]]},
  Scan[
    UpdateGridFromScan[grid, #,
      scenario["settings"]["maxRange"], scenario["settings"]["noReturn"]] &,
    SimulatedScans[scenario, seed]];
  grid];

SimulatedScans[scenario_?scenarioQ, seed_?seedQ] := With[{
    settings = scenario["settings"],
    walls = scenario["walls"],
    angles = BeamAngles[
      scenario["settings"]["fov"], scenario["settings"]["beams"]]},
  MapIndexed[
    If[MatchQ[#1, _RangeScan],
      #1,
      simulatedScan[#1, walls, angles, settings, seed, First[#2] - 1]] &,
    scenario["scans"]]];

(* what the sensor sees from a bare pose, scan s of the scenario *)
simulatedScan[pose_, walls_, angles_, settings_, seed_, s_] := With[
  {zMax = settings["maxRange"]},
  With[{ranges = SimulateLidarScan[pose, walls, angles, zMax]},
    RangeScan[pose, angles, If[seed === None,
      ranges,
      AddRangeNoise[ranges, settings["noiseStd"], seed, s, zMax]]]]];
(* [/snippet] *)
MapScenario[___] := wrongArguments[MapScenario];
SimulatedScans[___] := wrongArguments[SimulatedScans];

End[];
