(* The lesson, built in (lesson section 6): a robot drives an ellipse in a box
   with two inner walls. *)

BeginPackage["OccupancyGrid`"];

LessonSettings::usage = "LessonSettings[] gives the grid, inverse sensor \
model and simulated sensor of the lesson.";
LessonWorld::usage = "LessonWorld[] gives the walls of the lesson: a box of \
20 m x 16 m, a vertical and a horizontal wall in it.";
LessonPoses::usage = "LessonPoses[] gives 120 poses {x, y, theta} on an \
ellipse, the heading along it; metres, radians.";
LessonScenario::usage = "LessonScenario[] is the lesson as a scenario, named \
lesson.";

Begin["`Private`"];

(* [snippet: lesson-settings] *)
LessonSettings[] := <|
  "width" -> 220,
  "height" -> 180,
  "resolution" -> 0.1,
  "origin_x" -> -11.,
  "origin_y" -> -9.,
  "max_range" -> 10.,
  "p0" -> 0.5,
  "p_occ" -> 0.75,
  "p_free" -> 0.3,
  "l_min" -> -8.,
  "l_max" -> 8.,
  "no_return" -> "free",
  "fov" -> 3.141592653589793,
  "beams" -> 181,
  "noise_std" -> 0.02|>;
(* [/snippet] *)

(* [snippet: lesson-world] *)
LessonWorld[] := Join[
  BuildBoxWorld[-10., -8., 10., 8.],
  {AddVerticalWall[0., -6., 6.], AddHorizontalWall[2., -8., -2.]}];
(* [/snippet] *)

(* [snippet: lesson-poses] *)
LessonPoses[] := Module[{ang, x, y},
  ang = (2.*pi)*DivideEach[N[Range[0, 119]], 120.];
  x = -6. + (6.*PortableCos[ang]);
  y = 0. + (4.*PortableSin[ang]);
  Transpose[{x, y, ang + Divide[pi, 2.]}]];
(* [/snippet] *)

LessonScenario[] := <|
  "name" -> "lesson",
  "settings" -> LessonSettings[],
  "walls" -> LessonWorld[],
  "scans" -> LessonPoses[]|>;

End[];
EndPackage[];
