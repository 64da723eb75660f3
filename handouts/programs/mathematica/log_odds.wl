grid = OccupancyGrid[GridSpec[1, 1, 1., 0., 0.], 0.5, 0.75, 0.3, -8., 8.];
{hit, free} = {First[grid]["lOcc"], First[grid]["lFree"]};
Do[
  UpdateCell[grid, 0, 0, update];
  Print["log-odds ", LogOdds[grid][[1, 1]],
    ", p = ", ProbabilityGrid[grid][[1, 1]]],
  {update, {hit, free, free, hit}}];
