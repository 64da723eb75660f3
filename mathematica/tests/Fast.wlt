(* The fast path gives the bits of the printed one, and clips lines as a walk
   over their cells would. *)

clipLines = Table[Table[randomBelow[80] - 30, {4}], {150}];

(* clipping finds exactly the steps inside *)
stepsOfCells[{gx0_, gy0_, gx1_, gy1_}, width_, height_] := Module[
  {inside},
  inside = Flatten[Position[
    Map[0 <= First[#] < width && 0 <= Last[#] < height &,
      Transpose[Bresenham[gx0, gy0, gx1, gy1]]], True]] - 1;
  If[inside === {}, None, {First[inside], Last[inside]}]];
clipped[{gx0_, gy0_, gx1_, gy1_}, width_, height_] := With[
  {steps = ClipRay[gx0, gy0, gx1, gy1, width, height]},
  If[First[steps] > Last[steps], None, steps]];
VerificationTest[
  Select[clipLines,
    clipped[#, 20, 13] =!= stepsOfCells[#, 20, 13] &],
  {},
  TestID -> "clipping random lines"]
VerificationTest[
  Length[Select[clipLines, clipped[#, 20, 13] === None &]] > 10
    && Length[Select[clipLines, ListQ[clipped[#, 20, 13]] &]] > 10,
  True,
  TestID -> "some of them miss the grid, some do not"]
VerificationTest[
  Select[Flatten[Table[{gx, gy, 5 - gx, 3 - gy}, {gx, -3, 8}, {gy, -3, 6}],
      1],
    clipped[#, 4, 1] =!= stepsOfCells[#, 4, 1] &],
  {},
  TestID -> "clipping to a grid of one row"]
VerificationTest[
  ClipRay[0, 0, 1000000000, 3, 10, 10], {0, 9},
  TestID -> "a long line is not walked"]
VerificationTest[
  ClipRay[5, 5, 9, 5, 3, 3], {0, -1}, TestID -> "a line that misses"]

(* --- Scans --- *)

(* Robots in and outside the grid, hits at the robot's own cell and on edges
   of cells, ranges one bit around zMax, no return, no reading. *)
wildRange[zMax_] := With[{horizon = zMax - 1.*^-12}, Switch[randomBelow[9],
  0, Infinity,
  1, Indeterminate,
  2, zMax,
  3, horizon,
  4, horizon - 1.7763568394002505*^-15,
  5, horizon + 1.7763568394002505*^-15,
  6, 0.,
  7, 0.5*randomBelow[12],
  _, randomBelow[700]*0.01]];
wildScan[zMax_] := RangeScan[
  Pose[randomBelow[56]*0.25 - 3., randomBelow[44]*0.25 - 3.,
    randomBelow[628]*0.01],
  Table[randomBelow[314]*0.02 - 3.14, {10}],
  Table[wildRange[zMax], {10}]];
wildScans = Table[wildScan[6.], {12}];

(* {equal, something was drawn} for p0, pOcc, pFree, lMin, lMax *)
pathsAgree[{p0_, pOcc_, pFree_, lMin_, lMax_}, noReturn_] := Module[
  {start, plain, fast},
  start[] := OccupancyGrid[GridSpec[8, 5, 1., 0., 0.],
    p0, pOcc, pFree, lMin, lMax];
  plain = start[];
  fast = start[];
  Scan[UpdateGridFromScan[plain, #, 6., noReturn] &, wildScans];
  UpdateGridFromScans[fast, wildScans, 6., noReturn];
  {gridBits[plain] === gridBits[fast],
    Length[Union[Flatten[LogOdds[plain]]]] > 2}];
models = {
  {0.5, 0.75, 0.3, -2., 2.}, {0.4, 0.9, 0.399, -1.5, 1.2},
  {0.4, 0.45, 0.4, -1.5, 1.2}, {0.5, 0.2, 0.6, -1.5, 1.2},
  {0.3, 0.35, 0.7, -0.9, 3.}, {0.6, 0.9, 0.8, -8., 8.}};
VerificationTest[
  Map[pathsAgree[#, "free"] &, models],
  Map[{True, True} &, models],
  TestID -> "plain and fast, no return is free"]
VerificationTest[
  Map[pathsAgree[#, "ignore"] &, models],
  Map[{True, True} &, models],
  TestID -> "plain and fast, no return is ignored"]
VerificationTest[
  Module[{start, one, all},
    start[] := OccupancyGrid[GridSpec[8, 5, 1., 0., 0.],
      0.5, 0.75, 0.3, -2., 2.];
    one = start[];
    all = start[];
    Scan[UpdateGridFromScans[one, {#}, 6., "free"] &, wildScans];
    UpdateGridFromScans[all, wildScans, 6., "free"];
    gridBits[one] === gridBits[all]],
  True,
  TestID -> "scans one by one and all at once"]

(* far away: cells of a millimetre at ten million metres, long beams *)
VerificationTest[
  Module[{start, plain, fast},
    start[] := OccupancyGrid[
      GridSpec[5, 4, 0.001, 9999999.997, -9999999.998],
      0.5, 0.75, 0.3, -8., 8.];
    plain = start[];
    fast = start[];
    With[{scan = RangeScan[Pose[9999990., -9999999.996, 0.],
        {0., 1.*^-4, -1.*^-4}, {9.9992, 12., 20.}]},
      UpdateGridFromScan[plain, scan, 20., "free"];
      UpdateGridFromScans[fast, {scan}, 20., "free"]];
    {gridBits[plain] === gridBits[fast],
      Length[Union[Flatten[LogOdds[plain]]]]}],
  {True, 3},
  TestID -> "plain and fast, ten million metres away"]

(* --- Scenarios --- *)

VerificationTest[
  Map[
    gridBits[MapScenarioFast[smallWorld, #]]
      === gridBits[MapScenario[smallWorld, #]] &,
    {None, 0, 77}],
  {True, True, True},
  TestID -> "plain and fast, a scenario"]

VerificationTest[
  (* 5000 beams a scan: two batches of one scan, each of which is announced *)
  Module[{calls = {}, scan, scenario},
    scan = RangeScan[Pose[0., 0., 0.], ConstantArray[0., 5000],
      ConstantArray[1., 5000]];
    scenario = Append[smallWorld, "scans" -> {scan, scan}];
    MapScenarioFast[scenario, None, AppendTo[calls, #] &];
    calls],
  {0, 1, 2},
  TestID -> "progress after each batch"]
