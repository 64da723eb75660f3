(* The range sensor: bearings, what a range means, and the update of the grid
   (lesson section 4). RangeScan is a head that holds a scan; Scan is a
   function of the language. *)

Begin["OccupancyGrid`Private`"];

SetAttributes[UpdateGridFromScan, HoldFirst];

(* a range: a number, Infinity for no return, Indeterminate for no reading *)
rangeQ[r_] := NumberQ[r] || r === Infinity || r === Indeterminate;
noReturnQ[noReturn_] := noReturn === "free" || noReturn === "ignore";
scanQ[RangeScan[pose_, angles_List, ranges_List]] := poseQ[pose] &&
  numbersQ[angles] && VectorQ[ranges, rangeQ] &&
  Length[angles] == Length[ranges];
scanQ[_] := False;

(* [snippet: beam-angles] *)
BeamAngles[fov_?NumberQ, nBeams_Integer] := If[nBeams == 1,
  {0.},
  With[{i = N[Range[nBeams] - 1]},
    -Divide[fov, 2.] + divideEach[fov*i, nBeams - 1.]]];
(* [/snippet] *)
BeamAngles[___] := wrongArguments[BeamAngles];

(* [snippet: flaser-angles] *)
FlaserAngles[nBeams_Integer] := With[{
    step = Which[
      nBeams == 180 || nBeams == 181, Divide[PortablePi, 180.],
      nBeams == 360 || nBeams == 361, Divide[PortablePi, 360.],
      nBeams == 400 || nBeams == 401, Divide[PortablePi, 720.],
      nBeams > 1, Divide[PortablePi, nBeams - 1.],
      True, 0.]},
  -Divide[PortablePi, 2.] + (N[Range[nBeams] - 1]*step)];
(* [/snippet] *)
FlaserAngles[___] := wrongArguments[FlaserAngles];

(* [snippet: read-ranges] *)
ReadRanges[ranges_List, zMax_?NumberQ, noReturn_?noReturnQ] := Module[
  {hit, z, used},
  (* Indeterminate is ignored. At zMax or beyond nothing was hit (Problem 3):
     the beam is free up to zMax, or ignored. *)
  hit = Map[NumberQ[#] && # - (zMax - 1.*^-12) < 0 &, ranges];
  z = MapThread[If[#2, #1, zMax] &, {ranges, hit}];
  used = If[noReturn === "ignore",
    hit,
    Map[# =!= Indeterminate &, ranges]];
  {z, hit, used}] /; VectorQ[ranges, rangeQ];
(* [/snippet] *)
ReadRanges[___] := wrongArguments[ReadRanges];

(* [snippet: beam-endpoints] *)
BeamEndpoints[pose_?poseQ, angles_List?numbersQ, z_List?numbersQ] := With[
  {beam = pose[[3]] + angles},
  {pose[[1]] + (z*PortableCos[beam]), pose[[2]] + (z*PortableSin[beam])}];
(* [/snippet] *)
BeamEndpoints[___] := wrongArguments[BeamEndpoints];

(* [snippet: update-grid-from-scan] *)
UpdateGridFromScan[grid_, scan_?scanQ, zMax_, noReturn_] := Module[
  {pose, angles, ranges, z, hit, used, ex, ey, gx0, gy0, gx1, gy1, gx, gy,
    nFree},
  {pose, angles, ranges} = Apply[List, scan];
  {z, hit, used} = ReadRanges[ranges, zMax, noReturn];
  {ex, ey} = BeamEndpoints[pose, angles, z];
  {gx0, gy0} = WorldToGrid[grid, pose[[1]], pose[[2]]];
  {gx1, gy1} = WorldToGrid[grid, ex, ey];
  Do[
    {gx, gy} = Bresenham[gx0, gy0, gx1[[i]], gy1[[i]]];
    (* the cells before the hit *)
    nFree = If[hit[[i]], Length[gx] - 1, Length[gx]];
    UpdateCells[grid, Take[gx, nFree], Take[gy, nFree], grid[[1]]["lFree"]];
    If[hit[[i]],
      UpdateCell[grid, gx1[[i]], gy1[[i]], grid[[1]]["lOcc"]]],
    {i, Pick[Range[Length[ranges]], used]}]] /;
  gridVariableQ[grid] && NumberQ[zMax] && noReturnQ[noReturn];
(* [/snippet] *)
UpdateGridFromScan[___] := wrongArguments[UpdateGridFromScan];

End[];
