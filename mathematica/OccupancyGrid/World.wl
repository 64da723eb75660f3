(* The simulated world: walls, ray casting, range scans (lesson section 6).
   Pose and Segment are heads that hold their numbers. *)

Begin["OccupancyGrid`Private`"];

poseQ[pose_] := MatchQ[pose, Pose[_?NumberQ, _?NumberQ, _?NumberQ]];
segmentQ[wall_] := MatchQ[wall,
  Segment[_?NumberQ, _?NumberQ, _?NumberQ, _?NumberQ]];

(* [snippet: box-world] *)
BuildBoxWorld[xmin_, ymin_, xmax_, ymax_] := {
  Segment[xmin, ymin, xmax, ymin],
  Segment[xmax, ymin, xmax, ymax],
  Segment[xmax, ymax, xmin, ymax],
  Segment[xmin, ymax, xmin, ymin]};

AddVerticalWall[x_, y0_, y1_] := Segment[x, y0, x, y1];

AddHorizontalWall[y_, x0_, x1_] := Segment[x0, y, x1, y];
(* [/snippet] *)
BuildBoxWorld[___] := wrongArguments[BuildBoxWorld];
AddVerticalWall[___] := wrongArguments[AddVerticalWall];
AddHorizontalWall[___] := wrongArguments[AddHorizontalWall];

(* [snippet: ray-segment-intersection] *)
RaySegmentIntersection[rx_, ry_, rdx_List, rdy_List, wall_?segmentQ] := Module[
  {rxs, parallel, t, u},
  With[{
      sx = wall[[3]] - wall[[1]],
      sy = wall[[4]] - wall[[2]],
      qpx = wall[[1]] - rx,
      qpy = wall[[2]] - ry},
    rxs = (rdx*sy) - (rdy*sx);
    (* 1 where the ray is parallel to the wall: no distance is asked for *)
    parallel = 1 - UnitStep[Abs[rxs] - 1.*^-12];
    rxs = ((1 - parallel)*rxs) + parallel;
    t = divideEach[(qpx*sy) - (qpy*sx), rxs];
    u = divideEach[(qpx*rdy) - (qpy*rdx), rxs]];
  MapThread[
    If[#1 == 0 && #2 >= 0 && #3 >= 0 && #3 - 1. <= 0, #2, Infinity] &,
    {parallel, t, u}]];
(* [/snippet] *)
RaySegmentIntersection[___] := wrongArguments[RaySegmentIntersection];

(* [snippet: simulate-lidar-scan] *)
SimulateLidarScan[pose_?poseQ, walls_List, angles_List?numbersQ,
    zMax_] := Module[
  {beam, rdx, rdy, nearest, t},
  beam = pose[[3]] + angles;
  rdx = PortableCos[beam];
  rdy = PortableSin[beam];
  nearest = ConstantArray[zMax, Length[angles]];
  Do[
    t = RaySegmentIntersection[pose[[1]], pose[[2]], rdx, rdy, wall];
    nearest = MapThread[If[#1 - #2 < 0, #1, #2] &, {t, nearest}],
    {wall, walls}];
  nearest] /; VectorQ[walls, segmentQ] && NumberQ[zMax];
(* [/snippet] *)
SimulateLidarScan[___] := wrongArguments[SimulateLidarScan];

End[];
