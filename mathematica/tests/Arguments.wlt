(* Arguments that a function does not take: a message, and $Failed. *)

argumentGrid = OccupancyGrid[GridSpec[3, 2, 1., 0., 0.],
  0.5, 0.75, 0.3, -8., 8.];
valueOf[grid_] := Quiet[UpdateCell[grid, 0, 0, 1.]];
SetAttributes[refusedQ, HoldAll];
refusedQ[call_] := Quiet[call] === $Failed;

VerificationTest[
  Check[BeamAngles[1., "2"], "message"], "message",
  TestID -> "there is a message"]
VerificationTest[
  {refusedQ[PortableSin[symbol]], refusedQ[PortableCos[{1., symbol}]],
    refusedQ[PortableExp["1"]], refusedQ[PortableLog[{1., -1.}]],
    refusedQ[PortableSin[]], refusedQ[DoubleFromBits["3ff"]],
    refusedQ[DoubleToBits[symbol]]},
  {True, True, True, True, True, True, True},
  TestID -> "portable_math"]
VerificationTest[
  {refusedQ[Philox4x32[{1, 2, 3}, {4, 5}]],
    refusedQ[Philox4x32[{1, 2, 3, -1}, {4, 5}]],
    refusedQ[NormalDeviate[0, 0, 1]],
    refusedQ[AddRangeNoise[{1., symbol}, 0.1, 0, 0, 10.]]},
  {True, True, True, True},
  TestID -> "noise"]
VerificationTest[
  {refusedQ[Logit[symbol]], refusedQ[Sigmoid[{symbol}]],
    refusedQ[GridSpec[1., 2, 1., 0., 0.]],
    refusedQ[OccupancyGrid[GridSpec[1, 1, 1., 0., 0.],
      0.5, 0.75, 0.3, 1., 8.]],
    refusedQ[LogOdds[symbol]], refusedQ[ProbabilityGrid[{1., 2.}]],
    refusedQ[WorldToGrid[argumentGrid, symbol, 1.]],
    refusedQ[WorldToGrid[symbol, 1., 1.]],
    refusedQ[GridToWorldCenter[argumentGrid, 1., 1]],
    refusedQ[InBounds[argumentGrid, 1]]},
  {True, True, True, True, True, True, True, True, True, True},
  TestID -> "grid"]
VerificationTest[
  {refusedQ[UpdateCell[symbol, 0, 0, 1.]],
    refusedQ[UpdateCell[argumentGrid, 0.5, 0, 1.]],
    refusedQ[UpdateCell[argumentGrid, 0, 0, symbol]],
    refusedQ[UpdateCells[argumentGrid, {0}, {0}, symbol]],
    valueOf[argumentGrid],
    argumentGrid === OccupancyGrid[GridSpec[3, 2, 1., 0., 0.],
      0.5, 0.75, 0.3, -8., 8.]},
  {True, True, True, True, $Failed, True},
  TestID -> "a grid is updated in a variable"]
VerificationTest[
  {refusedQ[Bresenham[0, 0, 1.5, 2]], refusedQ[ClipRay[0, 0, 1, 1, 2]],
    refusedQ[RaySegmentIntersection[0., 0., {1.}, {0.}, symbol]],
    refusedQ[SimulateLidarScan[{0., 0., 0.}, {}, {0.}, 1.]],
    refusedQ[SimulateLidarScan[Pose[0., 0., 0.], {symbol}, {0.}, 1.]],
    refusedQ[BeamEndpoints[Pose[0., 0., symbol], {0.}, {1.}]],
    refusedQ[FlaserAngles[1.5]],
    refusedQ[UpdateGridFromScans[argumentGrid, {symbol}, 1., "free"]]},
  {True, True, True, True, True, True, True, True},
  TestID -> "lines, worlds, scans"]
VerificationTest[
  {refusedQ[MapScenario[symbol, 0]], refusedQ[MapScenarioFast["a.log", 0]],
    refusedQ[MapScenario[smallWorld, -1]], refusedQ[NewGrid[symbol]],
    refusedQ[ReadScenario[symbol]], refusedQ[ScenarioName[symbol]],
    refusedQ[MapPgm[symbol]], refusedQ[WriteMap["a", "b", symbol]],
    refusedQ[OccgridMain[{1}]]},
  {True, True, True, True, True, True, True, True, True},
  TestID -> "scenarios and maps"]
