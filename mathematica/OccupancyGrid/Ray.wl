(* Which cells a beam crosses: Bresenham's line (lesson section 4, line
   traversal). All numbers here are exact integers. *)

Begin["OccupancyGrid`Private`"];

(* [snippet: bresenham] *)
Bresenham[gx0_Integer, gy0_Integer, gx1_Integer, gy1_Integer] := With[{
    dx = Abs[gx1 - gx0],
    dy = Abs[gy1 - gy0],
    sx = If[gx0 < gx1, 1, -1],
    sy = If[gy0 < gy1, 1, -1]},
  With[{
      k = stepsUpTo[Max[dx, dy]],
      a = Max[dx, dy, 1],  (* a line of one cell has step 0 only *)
      b = Min[dx, dy]},
    With[{minor = Quotient[((2*b)*k) + (a - 1), 2*a]},
      If[dx >= dy,
        {gx0 + (sx*k), gy0 + (sy*minor)},
        {gx0 + (sx*minor), gy0 + (sy*k)}]]]] /;
  Max[Abs[gx1 - gx0], Abs[gy1 - gy0]] <= 2^20;

(* 0 .. n; woxi's Range holds a million numbers at most *)
stepsUpTo[n_] := If[n < 1000000, Range[0, n], Table[k, {k, 0, n}]];
(* [/snippet] *)
Bresenham[___] := wrongArguments[Bresenham];

End[];
