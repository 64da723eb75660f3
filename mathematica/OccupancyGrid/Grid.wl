(* The grid of log-odds (lesson sections 1 and 3).

   One map is made at a time. Its log-odds are a list of the package and no
   value of a function: lists are values in Wolfram, and a function that were
   given one and gave one back would copy the whole map for each cell. *)

BeginPackage["OccupancyGrid`"];

GridSpec::usage = "GridSpec[width, height, resolution, originX, originY] \
says where the cells lie in the world: numbers of columns and rows, side of \
a cell (m), world coordinates of the lower left corner (m).";
Logit::usage = "Logit[p] is the log-odds of a probability, which is kept \
within [1e-9, 1 - 1e-9].";
Sigmoid::usage = "Sigmoid[l] is the probability of log-odds, a number or a \
list; no overflow at either end.";
NewGrid::usage = "NewGrid[spec, p0, pOcc, pFree, lMin, lMax] starts a new \
map, in which every cell is l0 = Logit[p0], and gives its grid: the spec with \
the steps of an update (lesson section 3) and the limits of a cell.";
LogOdds::usage = "LogOdds[grid] is the map at hand, height lists of width \
log-odds; the first list is the row with the smallest y.";
WorldToGrid::usage = "WorldToGrid[grid, x, y] gives the cell {gx, gy} of a \
point (m), or {list, list} of points; it may lie outside.";
GridToWorldCenter::usage = "GridToWorldCenter[grid, gx, gy] gives the centre \
{x, y} of a cell in metres.";
InBounds::usage = "InBounds[grid, gx, gy] is 1 where a cell lies in the \
grid, else 0; gx and gy are numbers or lists.";
UpdateCell::usage = "UpdateCell[grid, gx, gy, lUpdate] adds the evidence \
lUpdate - l0 to one cell and clamps it. A cell outside the grid is skipped.";
UpdateCells::usage = "UpdateCells[grid, beams] is UpdateCell for the cells of \
beams in order, each {free cells, occupied cells}: lists of cells in the grid, \
given as gy*width + gx + 1.";
ProbabilityGrid::usage = "ProbabilityGrid[grid] is P(occupied) of every \
cell, height lists of width numbers.";
Clamp::usage = "Clamp[x, low, high] is x, or the limit that it passes.";

Begin["`Private`"];

(* The built-in Clip and Max compare with forgiveness on the Wolfram kernel,
   and Max takes lists apart. *)
Clamp[x_, low_, high_] := Which[
  x - high > 0, high,
  x - low < 0, low,
  True, x];

(* [snippet: grid-spec] *)
GridSpec[width_, height_, resolution_, originX_, originY_] := <|
  "width" -> width,           (* number of columns *)
  "height" -> height,         (* number of rows *)
  "resolution" -> resolution, (* side of a cell, metres *)
  "originX" -> originX,       (* world x of the lower left corner, metres *)
  "originY" -> originY        (* world y of the lower left corner, metres *)
  |>;
(* [/snippet] *)

(* [snippet: logit] *)
Logit[p_] := With[{q = Clamp[p, 1.*^-9, 1. - 1.*^-9]},
  PortableLog[Divide[q, 1. - q]]];
(* [/snippet] *)

(* [snippet: sigmoid] *)
Sigmoid[logOdds_List] := Module[{z, inside},
  z = PortableExp[-Abs[logOdds]];
  inside = UnitStep[logOdds];
  DivideEach[inside + ((1 - inside)*z), 1. + z]];
Sigmoid[logOdds_] := First[Sigmoid[{logOdds}]];
(* [/snippet] *)

NewGrid[spec_, p0_, pOcc_, pFree_, lMin_, lMax_] := Module[{l0 = Logit[p0]},
  logOdds = ConstantArray[l0, spec["width"]*spec["height"]];
  Join[spec, <|
    "l0" -> l0,
    "lOcc" -> Logit[pOcc],
    "lFree" -> Logit[pFree],
    "lMin" -> lMin,
    "lMax" -> lMax|>]];

LogOdds[grid_] := With[{low = grid["lMin"], high = grid["lMax"]},
  Partition[Map[Clamp[#, low, high] &, logOdds], grid["width"]]];

(* [snippet: world-to-grid] *)
WorldToGrid[grid_, x_, y_] := {
  Floor[DivideEach[x - grid["originX"], grid["resolution"]]],
  Floor[DivideEach[y - grid["originY"], grid["resolution"]]]};

GridToWorldCenter[grid_, gx_, gy_] := {
  grid["originX"] + ((gx + 0.5)*grid["resolution"]),
  grid["originY"] + ((gy + 0.5)*grid["resolution"])};

InBounds[grid_, gx_, gy_] :=
  (UnitStep[gx]*UnitStep[(grid["width"] - 1) - gx])*
    (UnitStep[gy]*UnitStep[(grid["height"] - 1) - gy]);
(* [/snippet] *)

(* [snippet: update-cell] *)
UpdateCell[grid_, gx_, gy_, lUpdate_] := If[InBounds[grid, gx, gy] == 1,
  With[{
      cell = ((gy*grid["width"]) + gx) + 1,
      delta = lUpdate - grid["l0"]},
    (* the first clamp is for UpdateCells, which leaves it to others *)
    logOdds[[cell]] = Clamp[
      Clamp[logOdds[[cell]], grid["lMin"], grid["lMax"]] + delta,
      grid["lMin"], grid["lMax"]]]];
(* [/snippet] *)

(* The clamp of a free cell waits until the cell is hit or looked at: free
   steps have one sign, so that a cell that has passed its limit stays beyond
   it, and one that has not is the same either way. *)
UpdateCells[grid_, beams_List] := With[{
    free = grid["lFree"] - grid["l0"], occupied = grid["lOcc"] - grid["l0"],
    low = grid["lMin"], high = grid["lMax"]},
  Scan[
    Function[beam,
      Do[logOdds[[cell]] = logOdds[[cell]] + free, {cell, First[beam]}];
      Do[
        logOdds[[cell]] = Clamp[
          Clamp[logOdds[[cell]], low, high] + occupied, low, high],
        {cell, Last[beam]}]],
    beams]];

(* [snippet: probability-grid] *)
ProbabilityGrid[grid_] := Map[Sigmoid, LogOdds[grid]];
(* [/snippet] *)

End[];
EndPackage[];
