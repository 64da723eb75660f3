(* The lesson's picture: P(occupied) from white to black, axes in metres
   (lesson section 6.5).

   Which way is up? ArrayPlot draws rows as a table does, the first at the
   top; the first row of the map is the one with the smallest y. DataReversed
   turns that round, and DataRange gives the axes metres: it is the range of
   the cells' centres. Raster has its first row at the bottom anyway. *)

BeginPackage["OccupancyGrid`"];

MapPlot::usage = "MapPlot[grid] is the map at hand as the lesson's ArrayPlot, \
for a notebook. (woxi does not know DataReversed and draws no ticks.)";
DrawMap::usage = "DrawMap[grid] is the same picture made of a Raster, which \
comes out alike everywhere.";

Begin["`Private`"];

mapTitle = "Occupancy Grid Map (P(occupied))";

MapPlot[grid_] := ArrayPlot[ProbabilityGrid[grid],
  DataReversed -> True,
  DataRange -> Transpose[{
    GridToWorldCenter[grid, 0, 0],
    GridToWorldCenter[grid, grid["width"] - 1, grid["height"] - 1]}],
  ColorFunction -> (GrayLevel[1. - #] &),
  ColorFunctionScaling -> False,
  Frame -> True,
  FrameTicks -> Automatic,
  FrameLabel -> {{"y [m]", None}, {"x [m]", None}},
  PlotLabel -> mapTitle];

DrawMap[grid_] := With[{
    corner = {grid["originX"], grid["originY"]},
    size = {grid["width"], grid["height"]}*grid["resolution"]},
  Graphics[
    {Raster[1. - ProbabilityGrid[grid], {corner, corner + size}, {0, 1}]},
    Frame -> True,
    FrameLabel -> {"x [m]", "y [m]"},
    PlotLabel -> mapTitle,
    ImageSize -> 800]];

End[];
EndPackage[];
