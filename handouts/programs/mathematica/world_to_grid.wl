grid = OccupancyGrid[
  GridSpec[220, 180, 0.1, -11., -9.], 0.5, 0.75, 0.3, -8., 8.];
points = {{-11., -9.}, {0., 0.}, {0.05, -0.05}, {-12., 0.}};
Do[
  {gx, gy} = WorldToGrid[grid, First[point], Last[point]];
  Print[point, " m lies in cell ", {gx, gy}, ", inside: ",
    InBounds[grid, gx, gy]],
  {point, points}];
