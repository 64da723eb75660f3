(* What several tests share. *)

(* the same random numbers everywhere: a small linear congruence *)
randomState = 1;
randomBelow[n_] := (
  randomState = Mod[randomState*1103515245 + 12345, 2^31];
  Mod[Quotient[randomState, 256], n]);

bits[x_List] := Map[bits, x];
bits[x_] := DoubleToBits[x];
(* all that a grid holds, to the last bit *)
gridBits[grid_] := {First[grid], bits[Last[grid]]};

temporaryFile[name_] := FileNameJoin[
  {$TemporaryDirectory, StringJoin["occgrid-", ToString[$ProcessID], name]}];

(* simulated and recorded scans in a box *)
smallWorld = <|
  "name" -> "small",
  "settings" -> Join[LessonSettings[], <|"width" -> 12, "height" -> 9,
    "resolution" -> 0.5, "originX" -> -3., "originY" -> -2.,
    "maxRange" -> 6., "beams" -> 7, "noiseStd" -> 0.4|>],
  "walls" -> BuildBoxWorld[-2.3, -1.6, 2.7, 1.9],
  "scans" -> {
    Pose[0., 0., 0.3],
    RangeScan[Pose[1., 0.5, 2.], {-0.4, 0.6}, {1.2, Infinity}],
    Pose[-1., 0.2, 4.]}|>;
