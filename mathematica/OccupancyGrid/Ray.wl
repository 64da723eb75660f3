(* Which cells a beam crosses: Bresenham's line (lesson section 4, line
   traversal). All numbers here are exact integers. *)

BeginPackage["OccupancyGrid`"];

Bresenham::usage = "Bresenham[gx0, gy0, gx1, gy1] gives the cells of the line \
from (gx0, gy0) to (gx1, gy1) in order, as {list of gx, list of gy}. \
Bresenham[gx0, gy0, gx1, gy1, {first, last}] gives those of some steps only. \
Step k goes k cells along the longer axis and \
floor((2 k b + a - 1)/(2 a)) along the shorter one, where a and b are the \
line's extents along the two (Bresenham 1965).";
ClipRay::usage = "ClipRay[gx0, gy0, gx1, gy1, width, height] gives {first, \
last}, the steps of a line that lie in a grid; last < first where none does.";

Begin["`Private`"];

(* [snippet: bresenham] *)
Bresenham[gx0_, gy0_, gx1_, gy1_] := Bresenham[gx0, gy0, gx1, gy1,
  {0, Max[Abs[gx1 - gx0], Abs[gy1 - gy0]]}];

Bresenham[gx0_, gy0_, gx1_, gy1_, {first_, last_}] := With[{
    dx = Abs[gx1 - gx0],
    dy = Abs[gy1 - gy0],
    sx = If[gx0 < gx1, 1, -1],
    sy = If[gy0 < gy1, 1, -1],
    k = Range[first, last]},
  With[{minor = minorSteps[k, Max[dx, dy, 1], Min[dx, dy]]},
    If[dx >= dy,
      {gx0 + (sx*k), gy0 + (sy*minor)},
      {gx0 + (sx*minor), gy0 + (sy*k)}]]];

(* a line of one cell has step 0 only, and a = 1 here *)
minorSteps[k_, a_, b_] := Quotient[((2*b)*k) + (a - 1), 2*a];
(* [/snippet] *)

(* [snippet: clip-ray] *)
ClipRay[gx0_, gy0_, gx1_, gy1_, width_, height_] := Module[
  {dx, dy, a, b, major, minor},
  dx = Abs[gx1 - gx0];
  dy = Abs[gy1 - gy0];
  a = Max[dx, dy];
  b = Min[dx, dy];
  (* how far each axis may go: {fewest, most} cells *)
  {major, minor} = {
    stepsInside[gx0, gx1, width], stepsInside[gy0, gy1, height]};
  If[dx < dy, {major, minor} = {minor, major}];
  {Max[0, First[major], firstStep[First[minor], a, b]],
    Min[a, Last[major], firstStep[Last[minor] + 1, a, b] - 1]}];

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

End[];
EndPackage[];
