grid = MapScenario[LessonScenario[], None];
ArrayPlot[Reverse[ProbabilityGrid[grid]], ColorFunction -> "GrayTones"]
