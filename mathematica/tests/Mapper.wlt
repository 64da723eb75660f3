room = <|
  "name" -> "room",
  "settings" -> Join[LessonSettings[], <|"width" -> 12, "height" -> 9,
    "resolution" -> 0.5, "origin_x" -> -3., "origin_y" -> -2.,
    "max_range" -> 6., "beams" -> 7|>],
  "walls" -> BuildBoxWorld[-2.3, -1.6, 2.7, 1.9],
  "scans" -> {{0., 0., 0.3}, {{1., 0.5, 2.}, {-0.4, 0.6}, {1.2, Infinity}},
    {-1., 0.2, 4.}}|>;

(* the same by hand, scan by scan *)
byHand[seed_] := Module[{grid, ranges, angles, scan},
  grid = NewGrid[GridSpec[12, 9, 0.5, -3., -2.], 0.5, 0.75, 0.3, -8., 8.];
  angles = BeamAngles[3.141592653589793, 7];
  Do[
    scan = room["scans"][[i + 1]];
    If[i != 1,
      ranges = SimulateLidarScan[scan, room["walls"], angles, 6.];
      If[seed =!= None,
        ranges = AddRangeNoise[ranges, 0.02, seed, i, 6.]];
      scan = {scan, angles, ranges}];
    plainUpdate[grid, scan, 6., "free"],
    {i, 0, 2}];
  bits[LogOdds[grid]]];

VerificationTest[
  Map[
    Function[seed, With[{expected = byHand[seed]},
      bits[LogOdds[MapScenario[room, seed]]] === expected]],
    {None, 0, 77}],
  {True, True, True},
  TestID -> "a scenario is mapped scan after scan"]
VerificationTest[
  Length[Union[Map[bits[LogOdds[MapScenario[room, #]]] &, {None, 0, 77}]]]
    > 1,
  True,
  TestID -> "noise makes a difference"]
VerificationTest[
  Module[{seen = {}},
    MapScenario[room, None,
      Function[{number, grid}, seen = Append[seen, {number,
        Length[Select[Flatten[LogOdds[grid]], # != 0 &]] > 0}]]];
    seen],
  {{0, True}, {1, True}, {2, True}},
  TestID -> "a call after each scan"]
