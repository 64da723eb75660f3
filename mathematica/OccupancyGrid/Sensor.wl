(* The range sensor: bearings, what a range means, and the update of the grid
   (lesson section 4). *)

BeginPackage["OccupancyGrid`"];

BeamAngles::usage = "BeamAngles[fov, nBeams] gives the bearings (radians) of \
a simulated scan over fov radians.";
FlaserAngles::usage = "FlaserAngles[nBeams] gives the bearings (radians) of \
a FLASER scan: its step is known by its count.";
ReadRanges::usage = "ReadRanges[ranges, zMax, noReturn] says what ranges (m) \
mean: {z, hit, used}, lists of the distance, 1 where something was hit and 1 \
where the beam counts. noReturn is \"free\" or \"ignore\".";
BeamEndpoints::usage = "BeamEndpoints[{x, y, theta}, angles, z] gives {list \
of x, list of y}, the world points (m) where beams of length z end.";
UpdateGridFromScan::usage = "UpdateGridFromScan[grid, {pose, angles, ranges}, \
zMax, noReturn] updates the map at hand by the inverse sensor model: free \
along each beam, occupied at its hit.";

Begin["`Private`"];

pi = 3.141592653589793;

(* [snippet: beam-angles] *)
BeamAngles[fov_, 1] := {0.};
BeamAngles[fov_, nBeams_] := With[{i = N[Range[nBeams] - 1]},
  -Divide[fov, 2.] + DivideEach[fov*i, nBeams - 1.]];
(* [/snippet] *)

(* [snippet: flaser-angles] *)
FlaserAngles[nBeams_] := With[{
    step = Which[
      nBeams == 180 || nBeams == 181, Divide[pi, 180.],
      nBeams == 360 || nBeams == 361, Divide[pi, 360.],
      nBeams == 400 || nBeams == 401, Divide[pi, 720.],
      nBeams > 1, Divide[pi, nBeams - 1.],
      True, 0.]},
  -Divide[pi, 2.] + (N[Range[nBeams] - 1]*step)];
(* [/snippet] *)

(* [snippet: read-ranges] *)
ReadRanges[ranges_List, zMax_, noReturn_] := Module[{hit, z, used},
  (* Indeterminate is ignored. At zMax or beyond nothing was hit (Problem 3):
     the beam is free up to zMax, or ignored. *)
  hit = Map[If[NumberQ[#] && # - (zMax - 1.*^-12) < 0, 1, 0] &, ranges];
  z = MapThread[If[#2 == 1, #1, zMax] &, {ranges, hit}];
  used = If[noReturn === "ignore",
    hit,
    Map[If[# === Indeterminate, 0, 1] &, ranges]];
  {z, hit, used}];
(* [/snippet] *)

(* [snippet: beam-endpoints] *)
BeamEndpoints[{x_, y_, theta_}, angles_List, z_List] := With[
  {beam = theta + angles},
  {x + (z*PortableCos[beam]), y + (z*PortableSin[beam])}];
(* [/snippet] *)

(* [snippet: update-grid-from-scan] *)
UpdateGridFromScan[grid_, {pose_, angles_, ranges_}, zMax_, noReturn_] :=
  Module[{z, hit, used, gx0, gy0, gx1, gy1, inside, startInside, cells},
    {z, hit, used} = ReadRanges[ranges, zMax, noReturn];
    {gx0, gy0} = WorldToGrid[grid, pose[[1]], pose[[2]]];
    {gx1, gy1} = Apply[WorldToGrid[grid, ##] &,
      BeamEndpoints[pose, angles, z]];
    startInside = InBounds[grid, gx0, gy0];
    inside = InBounds[grid, gx1, gy1];
    UpdateCells[grid, Table[
      cells = If[startInside*inside[[i]] == 1,
        wholeLine[gx0, gy0, gx1[[i]], gy1[[i]], grid["width"]],
        clippedLine[gx0, gy0, gx1[[i]], gy1[[i]],
          grid["width"], grid["height"]]];
      (* every cell is free, but a hit's last is occupied *)
      If[hit[[i]]*inside[[i]] == 1,
        {Most[cells], {Last[cells]}},
        {cells, {}}],
      {i, Pick[Range[Length[ranges]], used, 1]}]]];
(* [/snippet] *)

(* The cells of a line, as UpdateCells wants them; those that lie in the grid,
   where it leaves it. These are Bresenham and ClipRay, with a memory. *)
wholeLine[gx0_, gy0_, gx1_, gy1_, width_] :=
  (((width*gy0) + gx0) + 1) + lineFromOrigin[gx1 - gx0, gy1 - gy0, width];

clippedLine[gx0_, gy0_, gx1_, gy1_, width_, height_] := With[
  {steps = ClipRay[gx0, gy0, gx1, gy1, width, height]},
  Which[
    First[steps] > Last[steps],
      {},
    Max[Abs[gx1 - gx0], Abs[gy1 - gy0]] <= 10000,
      Take[wholeLine[gx0, gy0, gx1, gy1, width], steps + 1],
    True,
      Apply[((width*#2) + #1) + 1 &,
        Bresenham[gx0, gy0, gx1, gy1, steps]]]];

(* Lines with the same extents come again and again: their cells, as numbers to
   be added to the first one's, are remembered, up to a number that any memory
   holds. *)
rememberLine[dx_, dy_, width_] := With[{
    line = Apply[(width*#2) + #1 &, Bresenham[0, 0, dx, dy]]},
  rememberedCells = rememberedCells + Length[line];
  If[rememberedCells > 2000000, forgetLines[]];
  lineFromOrigin[dx, dy, width] = line];

forgetLines[] := (
  rememberedCells = 0;
  Clear[lineFromOrigin];
  lineFromOrigin[dx_, dy_, width_] := rememberLine[dx, dy, width]);
forgetLines[];

End[];
EndPackage[];
