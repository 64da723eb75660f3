(* The contract once more, as plain loops: slow, and with nothing to get
   wrong. The tests hold the package to it. Also what tests share. *)

plainLine[gx0_, gy0_, gx1_, gy1_] := Module[
  {dx, dy, sx, sy, err, e2, gx = gx0, gy = gy0, cells = {}},
  dx = Abs[gx1 - gx0];
  dy = Abs[gy1 - gy0];
  sx = If[gx0 < gx1, 1, -1];
  sy = If[gy0 < gy1, 1, -1];
  err = dx - dy;
  While[True,
    cells = Append[cells, {gx, gy}];
    If[gx == gx1 && gy == gy1, Break[]];
    e2 = 2*err;
    If[e2 > -dy, err = err - dy; gx = gx + sx];
    If[e2 < dx, err = err + dx; gy = gy + sy]];
  cells];

(* a scan cell by cell, with UpdateCell *)
plainUpdate[grid_, {pose_, angles_, ranges_}, zMax_, noReturn_] := Module[
  {start, end, cells, hit, z},
  start = WorldToGrid[grid, pose[[1]], pose[[2]]];
  Do[
    If[ranges[[i]] =!= Indeterminate,
      hit = ranges[[i]] =!= Infinity
        && ranges[[i]] - (zMax - 1.*^-12) < 0;
      If[hit || noReturn === "free",
        z = {If[hit, ranges[[i]], zMax]};
        end = {
          pose[[1]] + (First[z]*PortableCos[pose[[3]] + angles[[i]]]),
          pose[[2]] + (First[z]*PortableSin[pose[[3]] + angles[[i]]])};
        end = WorldToGrid[grid, First[end], Last[end]];
        cells = plainLine[First[start], Last[start], First[end], Last[end]];
        Do[
          UpdateCell[grid, cells[[k, 1]], cells[[k, 2]],
            If[hit && k == Length[cells], grid["lOcc"], grid["lFree"]]],
          {k, Length[cells]}]]],
    {i, Length[ranges]}]];

(* the same random numbers everywhere: a small linear congruence *)
randomState = 1;
randomBelow[n_] := (
  randomState = Mod[randomState*1103515245 + 12345, 2^31];
  Mod[Quotient[randomState, 256], n]);

bits[x_List] := Map[bits, x];
bits[x_] := DoubleToBits[x];

temporaryFile[name_] := FileNameJoin[
  {$TemporaryDirectory, StringJoin["occgrid-", ToString[$ProcessID], name]}];

(* what ReadScenario says of a text: LINE: REASON *)
refusal[text_] := Module[{file = temporaryFile[".log"], stream, answer},
  stream = OpenWrite[file];
  WriteString[stream, text];
  Close[stream];
  answer = Catch[ReadScenario[file]; "accepted", "scenario"];
  DeleteFile[file];
  StringReplace[answer, file <> ":" -> ""]];
