(* The lesson's picture: P(occupied) from white to black, axes in metres
   (lesson section 6.5).

   Which way is up? ArrayPlot draws rows as a table does, the first at the
   top; the first row of the map is the one with the smallest y. DataReversed
   turns that round, and DataRange gives the axes metres: it is the range of
   the cells' centres. Raster has its first row at the bottom anyway. *)

Begin["OccupancyGrid`Private`"];

mapTitle = "Occupancy Grid Map (P(occupied))";

MapPlot[grid_?gridValueQ] := ArrayPlot[ProbabilityGrid[grid],
  DataReversed -> True,
  DataRange -> Transpose[{
    GridToWorldCenter[grid, 0, 0],
    GridToWorldCenter[
      grid, First[grid]["width"] - 1, First[grid]["height"] - 1]}],
  ColorFunction -> (GrayLevel[1. - #] &),
  ColorFunctionScaling -> False,
  Frame -> True,
  FrameTicks -> Automatic,
  FrameLabel -> {{"y [m]", None}, {"x [m]", None}},
  PlotLabel -> mapTitle];
MapPlot[___] := wrongArguments[MapPlot];

DrawMap[grid_?gridValueQ] := With[{
    corner = Map[First[grid], {"originX", "originY"}],
    size = Map[First[grid], {"width", "height"}]*First[grid]["resolution"]},
  Graphics[
    {Raster[1. - ProbabilityGrid[grid], {corner, corner + size}, {0, 1}]},
    Frame -> True,
    FrameLabel -> {"x [m]", "y [m]"},
    PlotLabel -> mapTitle,
    ImageSize -> 800]];
DrawMap[___] := wrongArguments[DrawMap];

End[];
