grid = MapScenarioFast[LessonScenario[], None];
ArrayPlot[Reverse[ProbabilityGrid[grid]], ColorFunction -> "GrayTones"]
