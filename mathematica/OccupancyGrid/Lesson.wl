(* The lesson, built in (lesson section 6): a robot drives an ellipse in a box
   with two inner walls. *)

Begin["OccupancyGrid`Private`"];

(* [snippet: lesson-settings] *)
LessonSettings[] := <|
  "width" -> 220,
  "height" -> 180,
  "resolution" -> 0.1,
  "originX" -> -11.,
  "originY" -> -9.,
  "maxRange" -> 10.,
  "minRange" -> 0.,
  "p0" -> 0.5,
  "pOcc" -> 0.75,
  "pFree" -> 0.3,
  "lMin" -> -8.,
  "lMax" -> 8.,
  "noReturn" -> "free",
  "fov" -> PortablePi,
  "beams" -> 181,
  "noiseStd" -> 0.02|>;
(* [/snippet] *)

(* [snippet: lesson-world] *)
LessonWorld[] := Join[
  BuildBoxWorld[-10., -8., 10., 8.],
  {AddVerticalWall[0., -6., 6.], AddHorizontalWall[2., -8., -2.]}];
(* [/snippet] *)

(* [snippet: lesson-poses] *)
LessonPoses[] := Module[{ang, x, y},
  ang = (2.*PortablePi)*divideEach[N[Range[0, 119]], 120.];
  x = -6. + (6.*PortableCos[ang]);
  y = 0. + (4.*PortableSin[ang]);
  MapThread[Pose, {x, y, ang + Divide[PortablePi, 2.]}]];
(* [/snippet] *)

LessonScenario[] := <|
  "name" -> "lesson",
  "settings" -> LessonSettings[],
  "walls" -> LessonWorld[],
  "scans" -> LessonPoses[]|>;

End[];
