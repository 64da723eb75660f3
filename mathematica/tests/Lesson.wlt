VerificationTest[
  Map[LessonSettings[], {"width", "height", "resolution", "originX",
    "originY", "maxRange", "minRange", "p0", "pOcc", "pFree", "lMin", "lMax",
    "noReturn", "fov", "beams", "noiseStd"}],
  {220, 180, 0.1, -11., -9., 10., 0., 0.5, 0.75, 0.3, -8., 8., "free",
    3.141592653589793, 181, 0.02},
  TestID -> "settings"]
VerificationTest[
  LessonWorld[],
  {Segment[-10., -8., 10., -8.], Segment[10., -8., 10., 8.],
    Segment[10., 8., -10., 8.], Segment[-10., 8., -10., -8.],
    Segment[0., -6., 0., 6.], Segment[-8., 2., -2., 2.]},
  TestID -> "walls"]
VerificationTest[
  {Length[LessonPoses[]], First[LessonPoses[]],
    bits[Apply[List, LessonPoses[][[37]]]]},
  {120, Pose[0., 0., 1.5707963267948966],
    StringSplit["c01f6a99b4b1f77d 400e6f0e13445500 400ba5614317cb34"]},
  TestID -> "poses"]

(* the lesson as a file says the same, to the last bit *)
VerificationTest[
  With[{
      file = ReadScenario[
        FileNameJoin[{here, "..", "..", "scenarios", "lesson.log"}]],
      built = LessonScenario[]},
    {file["name"] === built["name"], file["walls"] === built["walls"],
      Map[bits[Apply[List, #]] &, file["scans"]]
        === Map[bits[Apply[List, #]] &, built["scans"]],
      Select[Keys[built["settings"]],
        file["settings"][#] =!= built["settings"][#] &]}],
  {True, True, True, {}},
  TestID -> "lesson.log"]
