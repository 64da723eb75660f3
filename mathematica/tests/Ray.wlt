cellsOf[line_] := Transpose[line];

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

(* the closed form is the definition: all octants, ties, far from the origin *)
VerificationTest[
  Select[
    Flatten[Table[{gx, gy}, {gx, -7, 7}, {gy, -7, 7}], 1],
    cellsOf[Bresenham[0, 0, First[#], Last[#]]]
      =!= plainLine[0, 0, First[#], Last[#]] &],
  {},
  TestID -> "all lines up to 7 cells"]
randomLines = Table[
  Table[randomBelow[80] - 30, {4}], {150}];
VerificationTest[
  Select[randomLines,
    cellsOf[Apply[Bresenham, #]] =!= Apply[plainLine, #] &],
  {},
  TestID -> "random lines"]
VerificationTest[
  cellsOf[Bresenham[100, 200, 160, 170, {10, 13}]],
  plainLine[100, 200, 160, 170][[11 ;; 14]],
  TestID -> "some steps of a line"]

(* clipping finds exactly the steps inside *)
stepsInPlainLine[{gx0_, gy0_, gx1_, gy1_}, width_, height_] := Module[
  {inside},
  inside = Flatten[Position[
    Map[0 <= First[#] < width && 0 <= Last[#] < height &,
      plainLine[gx0, gy0, gx1, gy1]], True]] - 1;
  If[inside === {}, None, {First[inside], Last[inside]}]];
clipped[{gx0_, gy0_, gx1_, gy1_}, width_, height_] := With[
  {steps = ClipRay[gx0, gy0, gx1, gy1, width, height]},
  If[First[steps] > Last[steps], None, steps]];
VerificationTest[
  Select[randomLines,
    clipped[#, 20, 13] =!= stepsInPlainLine[#, 20, 13] &],
  {},
  TestID -> "clipping random lines"]
VerificationTest[
  Length[Select[randomLines, clipped[#, 20, 13] === None &]] > 10
    && Length[Select[randomLines, ListQ[clipped[#, 20, 13]] &]] > 10,
  True,
  TestID -> "some of them miss the grid, some do not"]
VerificationTest[
  Select[Flatten[Table[{gx, gy, 5 - gx, 3 - gy}, {gx, -3, 8}, {gy, -3, 6}],
      1],
    clipped[#, 4, 1] =!= stepsInPlainLine[#, 4, 1] &],
  {},
  TestID -> "clipping to a grid of one row"]
VerificationTest[
  ClipRay[0, 0, 1000000000, 3, 10, 10], {0, 9},
  TestID -> "a long line is not walked"]
