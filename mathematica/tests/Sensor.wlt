VerificationTest[
  {BeamAngles[3., 1], BeamAngles[3., 2], BeamAngles[2., 5]},
  {{0.}, {-1.5, 1.5}, {-1., -0.5, 0., 0.5, 1.}},
  TestID -> "simulated bearings"]
VerificationTest[
  bits[BeamAngles[3.141592653589793, 181]],
  bits[Table[-Divide[3.141592653589793, 2.]
    + Divide[3.141592653589793*N[i], 180.], {i, 0, 180}]],
  TestID -> "the lesson's bearings"]
VerificationTest[
  Map[Length[FlaserAngles[#]] &, {1, 2, 180, 181, 360, 361, 400, 401, 541}],
  {1, 2, 180, 181, 360, 361, 400, 401, 541},
  TestID -> "as many bearings as beams"]
VerificationTest[
  bits[Map[FlaserAngles[#][[2]] - FlaserAngles[#][[1]] &,
    {2, 180, 181, 360, 361, 400, 401, 541}]],
  bits[Map[(-1.5707963267948966 + #) + 1.5707963267948966 &,
    MapThread[Divide, {ConstantArray[3.141592653589793, 8],
      {1., 180., 180., 360., 360., 720., 720., 540.}}]]],
  TestID -> "steps of FLASER by beam count"]
VerificationTest[
  FlaserAngles[1], {-1.5707963267948966}, TestID -> "FLASER with one beam"]

(* Problem 3: at the maximum range nothing was hit *)
readings = {3., 9.99, 10. - 2.*^-12, 10. - 1.*^-13, 10., 12., Infinity,
  Indeterminate, 0.};
VerificationTest[
  ReadRanges[readings, 10., "free"],
  {{3., 9.99, 9.999999999998, 10., 10., 10., 10., 10., 0.},
    {1, 1, 1, 0, 0, 0, 0, 0, 1}, {1, 1, 1, 1, 1, 1, 1, 0, 1}},
  TestID -> "what ranges mean, no return is free"]
VerificationTest[
  Rest[ReadRanges[readings, 10., "ignore"]],
  {{1, 1, 1, 0, 0, 0, 0, 0, 1}, {1, 1, 1, 0, 0, 0, 0, 0, 1}},
  TestID -> "what ranges mean, no return is ignored"]

VerificationTest[
  BeamEndpoints[{1., 2., 0.}, {0., 0.}, {3., 0.5}], {{4., 1.5}, {2., 2.}},
  TestID -> "where beams end"]

newTestGrid[] := NewGrid[GridSpec[8, 5, 1., 0., 0.],
  0.5, 0.75, 0.3, -2., 2.];
signsOf[grid_] := Map[Sign, LogOdds[grid]];
VerificationTest[
  With[{grid = newTestGrid[]},
    UpdateGridFromScan[grid,
      {{1.5, 2.5, 0.}, {0., 1.5707963267948966}, {4., 10.}}, 10., "free"];
    signsOf[grid]],
  {{0, 0, 0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0, 0, 0},
    {0, -1, -1, -1, -1, 1, 0, 0}, {0, -1, 0, 0, 0, 0, 0, 0},
    {0, -1, 0, 0, 0, 0, 0, 0}},
  TestID -> "free along a beam, occupied at its hit, free without return"]
VerificationTest[
  With[{grid = newTestGrid[]},
    UpdateGridFromScan[grid,
      {{1.5, 2.5, 0.}, {0., 0.}, {0.1, Indeterminate}}, 10., "free"];
    {signsOf[grid][[3]], Total[Flatten[Abs[signsOf[grid]]]]}],
  {{0, 1, 0, 0, 0, 0, 0, 0}, 1},
  TestID -> "a hit in the robot's own cell"]
VerificationTest[
  With[{grid = newTestGrid[]},
    UpdateGridFromScan[grid,
      {{-3.5, 2.5, 0.}, {0., 0.5, 3.}, {7., 2., 3.}}, 10., "free"];
    signsOf[grid]],
  {{0, 0, 0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0, 0, 0},
    {-1, -1, -1, 1, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0, 0, 0},
    {0, 0, 0, 0, 0, 0, 0, 0}},
  TestID -> "a robot outside the grid"]

(* whole scans against the definition, cell by cell *)
randomScan[] := {
  {randomBelow[1400]*0.01 - 3., randomBelow[1100]*0.01 - 3.,
    randomBelow[628]*0.01},
  Table[randomBelow[314]*0.02 - 3.14, {12}],
  Table[
    Switch[randomBelow[8], 0, Infinity, 1, Indeterminate, 2, 6.,
      _, randomBelow[700]*0.01],
    {12}]};
randomScans = Table[randomScan[], {25}];
VerificationTest[
  Map[
    Function[noReturn, Module[{grid = newTestGrid[], expected},
      Scan[plainUpdate[grid, #, 6., noReturn] &, randomScans];
      expected = bits[LogOdds[grid]];
      newTestGrid[];
      Scan[UpdateGridFromScan[grid, #, 6., noReturn] &, randomScans];
      {bits[LogOdds[grid]] === expected,
        Length[Union[Flatten[expected]]] > 5}]],
    {"free", "ignore"}],
  {{True, True}, {True, True}},
  TestID -> "random scans against the definition"]
