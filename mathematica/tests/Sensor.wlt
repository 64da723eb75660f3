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
    {True, True, True, False, False, False, False, False, True},
    {True, True, True, True, True, True, True, False, True}},
  TestID -> "what ranges mean, no return is free"]
VerificationTest[
  Rest[ReadRanges[readings, 10., "ignore"]],
  {{True, True, True, False, False, False, False, False, True},
    {True, True, True, False, False, False, False, False, True}},
  TestID -> "what ranges mean, no return is ignored"]

VerificationTest[
  BeamEndpoints[Pose[1., 2., 0.], {0., 0.}, {3., 0.5}],
  {{4., 1.5}, {2., 2.}},
  TestID -> "where beams end"]

newTestGrid[] := OccupancyGrid[GridSpec[8, 5, 1., 0., 0.],
  0.5, 0.75, 0.3, -2., 2.];
signsOf[grid_] := Map[Sign, LogOdds[grid]];
VerificationTest[
  Module[{grid = newTestGrid[]},
    UpdateGridFromScan[grid,
      RangeScan[Pose[1.5, 2.5, 0.], {0., 1.5707963267948966}, {4., 10.}],
      10., "free"];
    signsOf[grid]],
  {{0, 0, 0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0, 0, 0},
    {0, -1, -1, -1, -1, 1, 0, 0}, {0, -1, 0, 0, 0, 0, 0, 0},
    {0, -1, 0, 0, 0, 0, 0, 0}},
  TestID -> "free along a beam, occupied at its hit, free without return"]
VerificationTest[
  Module[{grid = newTestGrid[]},
    UpdateGridFromScan[grid,
      RangeScan[Pose[1.5, 2.5, 0.], {0., 0.}, {0.1, Indeterminate}],
      10., "free"];
    {signsOf[grid][[3]], Total[Flatten[Abs[signsOf[grid]]]]}],
  {{0, 1, 0, 0, 0, 0, 0, 0}, 1},
  TestID -> "a hit in the robot's own cell"]
VerificationTest[
  Module[{grid = newTestGrid[]},
    UpdateGridFromScan[grid,
      RangeScan[Pose[-3.5, 2.5, 0.], {0., 0.5, 3.}, {7., 2., 3.}],
      10., "free"];
    signsOf[grid]],
  {{0, 0, 0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0, 0, 0},
    {-1, -1, -1, 1, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0, 0, 0},
    {0, 0, 0, 0, 0, 0, 0, 0}},
  TestID -> "a robot outside the grid"]

(* recorded by hand: with what is no number nothing is drawn *)
VerificationTest[
  Module[{grid = newTestGrid[]},
    {Quiet[UpdateGridFromScan[grid,
        RangeScan[Pose[1., 1., 0.], {0., 1.}, {1., unknown}], 10., "free"]],
      Quiet[UpdateGridFromScan[grid,
        RangeScan[Pose[1., 1., 0.], {0., 1.}, {1.}], 10., "free"]],
      Quiet[ReadRanges[{1., unknown}, 10., "free"]],
      Quiet[ReadRanges[{1.}, 10., "maybe"]],
      Quiet[ReadRanges[{"1"}, 10., "free"]],
      Quiet[ReadRanges[{-Infinity}, 10., "free"]],
      gridBits[grid] === gridBits[newTestGrid[]]}],
  {$Failed, $Failed, $Failed, $Failed, $Failed, $Failed, True},
  TestID -> "what is no number"]
