grid = NewGrid[GridSpec[1, 1, 1., 0., 0.], 0.5, 0.75, 0.3, -8., 8.];
Do[
  UpdateCell[grid, 0, 0, update];
  Print["log-odds ", LogOdds[grid][[1, 1]],
    ", p = ", ProbabilityGrid[grid][[1, 1]]],
  {update, {grid["lOcc"], grid["lFree"], grid["lFree"], grid["lOcc"]}}];
