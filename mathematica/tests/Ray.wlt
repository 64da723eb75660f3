cellsOf[line_] := Transpose[line];

(* the lesson's loop, which the closed form stands for *)
loopLine[gx0_, gy0_, gx1_, gy1_] := Module[
  {dx, dy, sx, sy, err, e2, gx = gx0, gy = gy0, cells = {}},
  dx = Abs[gx1 - gx0];
  dy = Abs[gy1 - gy0];
  sx = If[gx0 < gx1, 1, -1];
  sy = If[gy0 < gy1, 1, -1];
  err = dx - dy;
  While[True,
    cells = Append[cells, {gx, gy}];
    If[gx == gx1 && gy == gy1, Break[]];
    e2 = 2*err;
    If[e2 > -dy, err = err - dy; gx = gx + sx];
    If[e2 < dx, err = err + dx; gy = gy + sy]];
  cells];

VerificationTest[
  Bresenham[3, 4, 3, 4], {{3}, {4}}, TestID -> "a line of one cell"]
VerificationTest[
  cellsOf[Bresenham[0, 0, 4, 2]],
  {{0, 0}, {1, 0}, {2, 1}, {3, 1}, {4, 2}},
  TestID -> "a line with ties"]
VerificationTest[
  cellsOf[Bresenham[4, 2, 0, 0]],
  {{4, 2}, {3, 2}, {2, 1}, {1, 1}, {0, 0}},
  TestID -> "the same line back takes other cells"]
VerificationTest[
  cellsOf[Bresenham[0, 0, 2, 5]],
  {{0, 0}, {0, 1}, {1, 2}, {1, 3}, {2, 4}, {2, 5}},
  TestID -> "a steep line"]
VerificationTest[
  {cellsOf[Bresenham[1, 1, -2, 1]], cellsOf[Bresenham[1, 1, 1, -1]],
    cellsOf[Bresenham[1, 1, -1, 3]]},
  {{{1, 1}, {0, 1}, {-1, 1}, {-2, 1}}, {{1, 1}, {1, 0}, {1, -1}},
    {{1, 1}, {0, 2}, {-1, 3}}},
  TestID -> "along the axes and the diagonal"]

(* the closed form is the loop: all octants, ties, far from the origin *)
VerificationTest[
  Select[
    Flatten[Table[{gx, gy}, {gx, -5, 5}, {gy, -5, 5}], 1],
    cellsOf[Bresenham[0, 0, First[#], Last[#]]]
      =!= loopLine[0, 0, First[#], Last[#]] &],
  {},
  TestID -> "all lines up to 5 cells"]
randomLines = Table[
  Table[randomBelow[80] - 30, {4}], {40}];
VerificationTest[
  Select[randomLines,
    cellsOf[Apply[Bresenham, #]] =!= Apply[loopLine, #] &],
  {},
  TestID -> "random lines"]
VerificationTest[
  {Quiet[Bresenham[0, 0, 2^20 + 1, 1]], Quiet[Bresenham[0, 0, 3, -2^20 - 1]]},
  {$Failed, $Failed},
  TestID -> "more than 2^20 steps are refused"]
VerificationTest[
  Length[First[Bresenham[0, 0, 2^20, 1]]], 2^20 + 1,
  TestID -> "the longest line"]
