(* The grid of log-odds (lesson sections 1 and 3).

   A grid is a value, the list {model, logOdds}: the model says where the
   cells lie and what one update adds; the log-odds are one flat list, in
   which cell (gx, gy) is number gy*width + gx + 1. Whoever copies a grid has
   another one.

   UpdateCell and UpdateCells change the grid that a variable holds, as
   AppendTo changes a list (HoldFirst). A function that took a grid and gave
   another one would copy all cells for each beam. The other functions of a
   cell hold their grid as well, so that woxi, which copies whatever it reads,
   reads the parts that they need. *)

Begin["OccupancyGrid`Private`"];

SetAttributes[
  {WorldToGrid, GridToWorldCenter, InBounds, UpdateCell, UpdateCells},
  HoldFirst];

(* [snippet: grid-spec] *)
GridSpec[width_Integer, height_Integer, resolution_, originX_, originY_] := <|
  "width" -> width,           (* number of columns *)
  "height" -> height,         (* number of rows *)
  "resolution" -> resolution, (* side of a cell, metres *)
  "originX" -> originX,       (* world x of the lower left corner, metres *)
  "originY" -> originY        (* world y of the lower left corner, metres *)
  |>;
(* [/snippet] *)
GridSpec[___] := wrongArguments[GridSpec];

(* [snippet: logit] *)
(* x, or the limit that it passes; of a list, each. The built-in Clip compares
   with forgiveness on the Wolfram kernel. What comes out of a list is a sum
   with exact zeros: nothing is rounded. *)
clamp[x_List, low_, high_] := With[
  {above = UnitStep[x - high], below = UnitStep[low - x]},
  (((1 - above)*(1 - below))*x) + ((above*high) + (below*low))];
clamp[x_, low_, high_] := Which[
  x - high > 0, high,
  x - low < 0, low,
  True, x];

Logit[p_?NumberQ] := With[{q = clamp[p, 1.*^-9, 1. - 1.*^-9]},
  PortableLog[Divide[q, 1. - q]]];
(* [/snippet] *)
Logit[___] := wrongArguments[Logit];

(* [snippet: sigmoid] *)
Sigmoid[logOdds_List?numbersQ] := Module[{z, inside},
  z = PortableExp[-Abs[logOdds]];
  inside = UnitStep[logOdds];
  divideEach[inside + ((1 - inside)*z), 1. + z]];
Sigmoid[logOdds_?NumberQ] := First[Sigmoid[{logOdds}]];
(* [/snippet] *)
Sigmoid[___] := wrongArguments[Sigmoid];

OccupancyGrid[spec_Association, p0_?NumberQ, pOcc_?NumberQ, pFree_?NumberQ,
    lMin_?NumberQ, lMax_?NumberQ] := With[{l0 = Logit[p0]},
  {
    Join[spec, <|
      "l0" -> l0,
      "lOcc" -> Logit[pOcc],
      "lFree" -> Logit[pFree],
      "lMin" -> lMin,
      "lMax" -> lMax|>],
    ConstantArray[l0, spec["width"]*spec["height"]]
  }] /; clamp[Logit[p0], lMin, lMax] - Logit[p0] == 0;
OccupancyGrid[___] := wrongArguments[OccupancyGrid];

LogOdds[grid : {model_Association, _List}] := Partition[
  Last[grid], model["width"]];
LogOdds[___] := wrongArguments[LogOdds];

(* [snippet: world-to-grid] *)
WorldToGrid[grid_, x_?numbersQ, y_?numbersQ] /; gridQ[grid] := With[{
    originX = grid[[1]]["originX"],
    originY = grid[[1]]["originY"],
    resolution = grid[[1]]["resolution"]},
  {Floor[divideEach[x - originX, resolution]],
    Floor[divideEach[y - originY, resolution]]}];

GridToWorldCenter[grid_, gx_Integer, gy_Integer] /; gridQ[grid] := With[{
    originX = grid[[1]]["originX"],
    originY = grid[[1]]["originY"],
    resolution = grid[[1]]["resolution"]},
  {originX + ((gx + 0.5)*resolution), originY + ((gy + 0.5)*resolution)}];

InBounds[grid_, gx_Integer, gy_Integer] /; gridQ[grid] :=
  gx >= 0 && gx - grid[[1]]["width"] < 0 &&
    gy >= 0 && gy - grid[[1]]["height"] < 0;
(* [/snippet] *)
WorldToGrid[___] := wrongArguments[WorldToGrid];
GridToWorldCenter[___] := wrongArguments[GridToWorldCenter];
InBounds[___] := wrongArguments[InBounds];

(* [snippet: update-cell] *)
UpdateCell[grid_, gx_Integer, gy_Integer, lUpdate_?NumberQ] :=
  UpdateCells[grid, {gx}, {gy}, lUpdate];

UpdateCells[grid_, gx_List, gy_List, lUpdate_?NumberQ] /;
    gridVariableQ[grid] := With[{
    width = grid[[1]]["width"],
    height = grid[[1]]["height"],
    low = grid[[1]]["lMin"],
    high = grid[[1]]["lMax"],
    delta = lUpdate - grid[[1]]["l0"]},
  With[{inside = (UnitStep[gx]*UnitStep[(width - 1) - gx])*
      (UnitStep[gy]*UnitStep[(height - 1) - gy])},
    With[{cells = Pick[((gy*width) + gx) + 1, inside, 1]},
      MapThread[
        (grid[[2, #1]] = #2) &,
        {cells, clamp[
          Table[grid[[2, cell]], {cell, cells}] + delta, low, high]}];]]];
(* [/snippet] *)
UpdateCell[___] := wrongArguments[UpdateCell];
UpdateCells[___] := wrongArguments[UpdateCells];

(* [snippet: probability-grid] *)
ProbabilityGrid[grid_] := Map[Sigmoid, LogOdds[grid]];
(* [/snippet] *)

End[];
