grid = MapScenario[ReadScenario["scenarios/one-beam.log"], None];
(* the row with the largest y first *)
Do[Print[row], {row, Reverse[LogOdds[grid]]}];
