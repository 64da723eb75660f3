(* Speed, and nothing else: the same bits as the plain path, in a third of its
   time on woxi.

   The log-odds are taken out of the grid once for many scans, and put back at
   the end: one flat list in a variable is the fastest that a cell can be
   reached. The cells of a line are remembered, and the clamp of free cells
   waits. *)

Begin["OccupancyGrid`Private`"];

SetAttributes[{UpdateGridFromScans, beamCells, updateFromBeams}, HoldFirst];

(* Which steps of a line lie in the grid, without walking the others. The line
   from (-3, 1) to (5, 3) has a = 8 steps and goes b = 2 cells up; a grid of 4
   by 3 cells holds x = 0 .. 3, so steps 3 .. 6. Step k is at
   y = 1 + floor((2 k b + a - 1)/(2 a)), which is above y = 2 from the first k
   with 4 k >= 16*2 - 8 + 1 on, k = 7: no bound there. *)

(* [snippet: clip-ray] *)
ClipRay[gx0_Integer, gy0_Integer, gx1_Integer, gy1_Integer,
    width_Integer, height_Integer] := Module[
  {dx, dy, a, b, major, minor, first, last},
  dx = Abs[gx1 - gx0];
  dy = Abs[gy1 - gy0];
  a = Max[dx, dy];
  b = Min[dx, dy];
  (* how far each axis may go: {fewest, most} cells *)
  {major, minor} = {
    stepsInside[gx0, gx1, width], stepsInside[gy0, gy1, height]};
  If[dx < dy, {major, minor} = {minor, major}];
  first = Max[0, First[major], firstStep[First[minor], a, b]];
  last = Min[a, Last[major], firstStep[Last[minor] + 1, a, b] - 1];
  If[first <= last, {first, last}, {0, -1}]];

(* fewest and most cells to go from g0 towards g1 to be in 0 .. size - 1 *)
stepsInside[g0_, g1_, size_] := If[g0 < g1,
  {-g0, (size - 1) - g0},
  {g0 - (size - 1), g0}];

(* the first step that has gone m cells along the shorter axis: step k has
   exactly when 2 k b >= 2 a m - a + 1 *)
firstStep[m_, a_, b_] := Which[
  m <= 0, 0,
  b == 0, a + 1,
  True, -Quotient[(a - 1) - (2*(a*m)), 2*b]];
(* [/snippet] *)
ClipRay[___] := wrongArguments[ClipRay];

(* [snippet: update-grid-from-scans] *)
UpdateGridFromScans[grid_, scans_List, zMax_, noReturn_] := Module[
  {logOdds = grid[[2]], low = grid[[1]]["lMin"], high = grid[[1]]["lMax"]},
  Scan[
    updateFromBeams[logOdds, grid[[1]],
      beamCells[grid, Apply[List, #], zMax, noReturn]] &,
    scans];
  (* the clamps that still wait *)
  grid[[2]] = clamp[logOdds, low, high];] /;
  gridVariableQ[grid] && VectorQ[scans, scanQ] && NumberQ[zMax] &&
    noReturnQ[noReturn];

(* the beams of a scan as {free cells, occupied cells}, lists of positions in
   the flat list of cells, without those outside the grid *)
beamCells[grid_, {pose_, angles_, ranges_}, zMax_, noReturn_] := Module[
  {width = grid[[1]]["width"], height = grid[[1]]["height"],
    z, hit, used, ex, ey, gx0, gy0, gx1, gy1, startInside, inside, cells},
  {z, hit, used} = ReadRanges[ranges, zMax, noReturn];
  {ex, ey} = BeamEndpoints[pose, angles, z];
  {gx0, gy0} = WorldToGrid[grid, pose[[1]], pose[[2]]];
  {gx1, gy1} = WorldToGrid[grid, ex, ey];
  startInside = InBounds[grid, gx0, gy0];
  inside = (UnitStep[gx1]*UnitStep[(width - 1) - gx1])*
    (UnitStep[gy1]*UnitStep[(height - 1) - gy1]);
  Table[
    cells = If[startInside && inside[[i]] == 1,
      wholeLine[gx0, gy0, gx1[[i]], gy1[[i]], width],
      clippedLine[gx0, gy0, gx1[[i]], gy1[[i]], width, height]];
    (* every cell is free, but a hit's last is occupied *)
    If[hit[[i]] && inside[[i]] == 1,
      {Most[cells], {Last[cells]}},
      {cells, {}}],
    {i, Pick[Range[Length[ranges]], used]}]];
(* [/snippet] *)
UpdateGridFromScans[___] := wrongArguments[UpdateGridFromScans];

(* The clamp of a free cell waits until the cell is hit or the scans end. With
   lMin = -8, a cell at -7.9 that is free twice goes to -8.75 and -9.6, and the
   clamp then makes -8. of it, as two clamps had done: free steps have one
   sign, so that a cell that has passed its limit stays beyond it, and one
   that has not is the same either way. It saves two comparisons a cell. *)
updateFromBeams[logOdds_, model_, beams_] := With[{
    free = model["lFree"] - model["l0"],
    occupied = model["lOcc"] - model["l0"],
    low = model["lMin"],
    high = model["lMax"]},
  Scan[
    Function[beam,
      Do[logOdds[[cell]] = logOdds[[cell]] + free, {cell, First[beam]}];
      Do[
        logOdds[[cell]] = clamp[
          clamp[logOdds[[cell]], low, high] + occupied, low, high],
        {cell, Last[beam]}]],
    beams]];

(* Lines with the same extents come again and again. In a grid of width 10,
   the line from (2, 1) to (4, 2) is at 13 + {0, 1, 12}, and the one from
   (5, 7) to (7, 8) at 76 + {0, 1, 12}: the last list is remembered for the
   extents (2, 1), up to a number of cells that any memory holds. *)
wholeLine[gx0_, gy0_, gx1_, gy1_, width_] :=
  (((width*gy0) + gx0) + 1) + lineFromOrigin[gx1 - gx0, gy1 - gy0, width];

clippedLine[gx0_, gy0_, gx1_, gy1_, width_, height_] := With[
  {steps = ClipRay[gx0, gy0, gx1, gy1, width, height]},
  Which[
    First[steps] > Last[steps],
      {},
    Max[Abs[gx1 - gx0], Abs[gy1 - gy0]] <= 10000,
      Take[wholeLine[gx0, gy0, gx1, gy1, width], steps + 1],
    True,
      someSteps[gx0, gy0, gx1, gy1, steps, width]]];

(* the cells of some steps: Bresenham's closed form, from first to last *)
someSteps[gx0_, gy0_, gx1_, gy1_, {first_, last_}, width_] := With[{
    dx = Abs[gx1 - gx0], dy = Abs[gy1 - gy0],
    sx = If[gx0 < gx1, 1, -1], sy = If[gy0 < gy1, 1, -1],
    k = Range[first, last]},
  With[{minor = Quotient[
      ((2*Min[dx, dy])*k) + (Max[dx, dy] - 1), 2*Max[dx, dy]]},
    (((width*gy0) + gx0) + 1) + If[dx >= dy,
      (sx*k) + ((width*sy)*minor),
      (sx*minor) + ((width*sy)*k)]]];

rememberLine[dx_, dy_, width_] := With[{
    line = Apply[(width*#2) + #1 &, Bresenham[0, 0, dx, dy]]},
  rememberedCells = rememberedCells + Length[line];
  If[rememberedCells > 2000000, forgetLines[]];
  lineFromOrigin[dx, dy, width] = line];

forgetLines[] := (
  rememberedCells = 0;
  Clear[lineFromOrigin];
  lineFromOrigin[dx_, dy_, width_] := rememberLine[dx, dy, width]);
forgetLines[];

MapScenarioFast[scenario_?scenarioQ, seed_?seedQ] :=
  MapScenarioFast[scenario, seed, Null &];
MapScenarioFast[scenario_?scenarioQ, seed_?seedQ, progress_] := Module[
  {grid = NewGrid[scenario["settings"]], done = 0},
  progress[0];
  Scan[
    Function[batch,
      UpdateGridFromScans[grid, batch,
        scenario["settings"]["maxRange"], scenario["settings"]["noReturn"]];
      done = done + Length[batch];
      progress[done]],
    batches[SimulatedScans[scenario, seed]]];
  grid];
MapScenarioFast[___] := wrongArguments[MapScenarioFast];

(* Scans in order, about 8192 beams at a time: between two batches there is
   time to say how far the map is. *)
batches[{}] := {};
batches[scans_] := With[
  {size = Max[1, Quotient[8192, Max[1, Length[scans[[1, 2]]]]]]},
  Table[
    Take[scans, {first, Min[(first + size) - 1, Length[scans]]}],
    {first, 1, Length[scans], size}]];

End[];
