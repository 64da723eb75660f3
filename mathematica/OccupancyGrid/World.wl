(* The simulated world: walls, ray casting, range scans (lesson section 6). *)

BeginPackage["OccupancyGrid`"];

Segment::usage = "Segment[x0, y0, x1, y1] is a wall from (x0, y0) to \
(x1, y1), metres.";
BuildBoxWorld::usage = "BuildBoxWorld[xmin, ymin, xmax, ymax] gives the four \
walls of a rectangle, counterclockwise from the lower one; metres.";
AddVerticalWall::usage = "AddVerticalWall[x, y0, y1] is a wall along y.";
AddHorizontalWall::usage = "AddHorizontalWall[y, x0, x1] is a wall along x.";
RaySegmentIntersection::usage = "RaySegmentIntersection[rx, ry, rdx, rdy, \
wall] gives the distances (m) at which rays from one point (m) along \
directions, two lists, meet a wall; Infinity where a ray is parallel or \
misses.";
SimulateLidarScan::usage = "SimulateLidarScan[{x, y, theta}, walls, angles, \
zMax] gives the ranges (m) along a list of bearings (radians) from a pose; \
zMax for a beam that meets no wall within it.";

Begin["`Private`"];

(* [snippet: box-world] *)
BuildBoxWorld[xmin_, ymin_, xmax_, ymax_] := {
  Segment[xmin, ymin, xmax, ymin],
  Segment[xmax, ymin, xmax, ymax],
  Segment[xmax, ymax, xmin, ymax],
  Segment[xmin, ymax, xmin, ymin]};

AddVerticalWall[x_, y0_, y1_] := Segment[x, y0, x, y1];

AddHorizontalWall[y_, x0_, x1_] := Segment[x0, y, x1, y];
(* [/snippet] *)

(* [snippet: ray-segment-intersection] *)
RaySegmentIntersection[rx_, ry_, rdx_List, rdy_List,
    Segment[x0_, y0_, x1_, y1_]] := Module[{rxs, tTop, t, uTop},
  With[{sx = x1 - x0, sy = y1 - y0, qpx = x0 - rx, qpy = y0 - ry},
    rxs = (rdx*sy) - (rdy*sx);
    tTop = (qpx*sy) - (qpy*sx);
    (* a ray that is parallel meets a wall as little as one behind it *)
    t = Map[If[Abs[#] - 1.*^-12 < 0, -1., Divide[tTop, #]] &, rxs];
    uTop = (qpx*rdy) - (qpy*rdx)];
  MapThread[
    If[#1 < 0 || outsideUnit[Divide[#2, #3]], Infinity, #1] &,
    {t, uTop, rxs}]];

outsideUnit[u_] := u < 0 || u - 1. > 0;
(* [/snippet] *)

(* [snippet: simulate-lidar-scan] *)
SimulateLidarScan[{x_, y_, theta_}, walls_List, angles_List, zMax_] := Module[
  {beam, rdx, rdy, nearest, t},
  beam = theta + angles;
  rdx = PortableCos[beam];
  rdy = PortableSin[beam];
  nearest = ConstantArray[zMax, Length[angles]];
  Do[
    t = RaySegmentIntersection[x, y, rdx, rdy, wall];
    nearest = MapThread[If[#1 - #2 < 0, #1, #2] &, {t, nearest}],
    {wall, walls}];
  nearest];
(* [/snippet] *)

End[];
EndPackage[];
