(* the same by hand, scan by scan *)
byHand[seed_] := Module[{grid, ranges, angles},
  grid = OccupancyGrid[
    GridSpec[12, 9, 0.5, -3., -2.], 0.5, 0.75, 0.3, -8., 8.];
  angles = BeamAngles[PortablePi, 7];
  MapIndexed[
    If[Head[#1] === RangeScan,
      UpdateGridFromScan[grid, #1, 6., "free"],
      ranges = SimulateLidarScan[#1, smallWorld["walls"], angles, 6.];
      If[seed =!= None,
        ranges = AddRangeNoise[ranges, 0.4, seed, First[#2] - 1, 6.]];
      UpdateGridFromScan[grid, RangeScan[#1, angles, ranges], 6., "free"]] &,
    smallWorld["scans"]];
  gridBits[grid]];

VerificationTest[
  Map[
    gridBits[MapScenario[smallWorld, #]] === byHand[#] &,
    {None, 0, 77}],
  {True, True, True},
  TestID -> "a scenario is mapped scan after scan"]
VerificationTest[
  Length[Union[Map[gridBits[MapScenario[smallWorld, #]] &, {None, 0, 77}]]],
  3,
  TestID -> "noise makes a difference"]

(* mapped again, in another order: nothing is left of the map before *)
VerificationTest[
  Module[{first, second, third},
    first = MapScenario[smallWorld, None];
    second = MapScenario[smallWorld, 7];
    third = MapScenario[smallWorld, None];
    {gridBits[first] === gridBits[third],
      gridBits[first] === gridBits[second],
      Dimensions[LogOdds[first]],
      Count[Flatten[LogOdds[second] - LogOdds[first]], 0.] < 108}],
  {True, False, {9, 12}, True},
  TestID -> "a scenario is mapped again"]

VerificationTest[
  {Map[Head, SimulatedScans[smallWorld, 3]],
    SimulatedScans[smallWorld, 3][[2]] === smallWorld["scans"][[2]],
    First[SimulatedScans[smallWorld, 3]][[1]]},
  {{RangeScan, RangeScan, RangeScan}, True, Pose[0., 0., 0.3]},
  TestID -> "simulated and recorded scans"]

(* scenarios/one-beam.log, without a file to read *)
oneBeam = <|
  "name" -> "one-beam",
  "settings" -> Join[LessonSettings[], <|"width" -> 8, "height" -> 5,
    "resolution" -> 1., "originX" -> 0., "originY" -> 0.|>],
  "walls" -> {},
  "scans" -> {RangeScan[
    Pose[1.5, 1.5, 0.], {0.4636476090008061}, {4.47213595499958}]}|>;
oneBeamMap = {
  {0., 0., 0., 0., 0., 0., 0., 0.},
  {0., Logit[0.3], Logit[0.3], 0., 0., 0., 0., 0.},
  {0., 0., 0., Logit[0.3], Logit[0.3], 0., 0., 0.},
  {0., 0., 0., 0., 0., Logit[0.75], 0., 0.},
  {0., 0., 0., 0., 0., 0., 0., 0.}};
VerificationTest[
  bits[LogOdds[MapScenario[oneBeam, 0]]] === bits[oneBeamMap],
  True,
  TestID -> "one beam"]
VerificationTest[
  bits[LogOdds[MapScenarioFast[oneBeam, None]]] === bits[oneBeamMap],
  True,
  TestID -> "one beam, fast"]
