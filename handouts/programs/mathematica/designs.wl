Do[
  scenario = LessonScenario[];
  scenario["settings"] = Join[scenario["settings"],
    <|"pOcc" -> First[design], "pFree" -> Last[design]|>];
  p = Flatten[ProbabilityGrid[MapScenarioFast[scenario, None]]];
  unsure = Count[p, x_ /; 0.05 < x < 0.95 && x != 0.5];
  Print[design, ": ", unsure, " cells are unsure"],
  {design, {{0.6, 0.4}, {0.75, 0.3}, {0.9, 0.1}}}];
