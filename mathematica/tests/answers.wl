(* What the package answers to the shared vectors (scenarios/vectors):
   answer[function, columns] takes the texts of one line's arguments and gives
   the text of its results, separated by one space. The probe, the unit tests
   and kernel_check.wls ask here. *)

double = DoubleFromBits;
(* -0 is no number of the language, and 0 has the same results *)
number[text_] := If[DoubleFromBits[text] === NegativeZero,
  0.,
  DoubleFromBits[text]];
numbers[texts_] := Map[number, texts];
whole[text_] := If[StringTake[text, 1] === "-",
  -FromDigits[StringDrop[text, 1]],
  FromDigits[text]];
wholes[texts_] := Map[whole, texts];
flag[value_] := If[value, "1", "0"];
line[texts_] := StringRiffle[texts, " "];

portable = <|
  "sin" -> PortableSin, "cos" -> PortableCos,
  "exp" -> PortableExp, "log" -> PortableLog|>;

answer["sin", {x_}] := DoubleToBits[PortableSin[double[x]]];
answer["cos", {x_}] := DoubleToBits[PortableCos[double[x]]];
answer["exp", {x_}] := DoubleToBits[PortableExp[double[x]]];
answer["log", {x_}] := DoubleToBits[PortableLog[double[x]]];
answer["logit", {p_}] := DoubleToBits[Logit[number[p]]];
answer["sigmoid", {l_}] := DoubleToBits[Sigmoid[number[l]]];
answer["pixel", {l_}] := ToString[Pixel[number[l]]];

answer["world_to_grid", {resolution_, originX_, originY_, x_, y_}] := Module[
  {grid},
  grid = {
    GridSpec[1, 1, number[resolution], number[originX], number[originY]], {}};
  line[Map[ToString, WorldToGrid[grid, number[x], number[y]]]]];

answer["update_cell", {p0_, pOcc_, pFree_, lMin_, lMax_, updates_}] := Module[
  {grid},
  grid = OccupancyGrid[GridSpec[1, 1, 1., 0., 0.],
    number[p0], number[pOcc], number[pFree], number[lMin], number[lMax]];
  Scan[
    UpdateCell[grid, 0, 0, grid[[1]][If[# === "o", "lOcc", "lFree"]]] &,
    Characters[updates]];
  DoubleToBits[grid[[2, 1]]]];

answer["bresenham", columns_] := line[MapThread[
  StringJoin[ToString[#1], ":", ToString[#2]] &,
  Apply[Bresenham, wholes[columns]]]];
answer["clip_ray", columns_] := line[
  Map[ToString, Apply[ClipRay, wholes[columns]]]];
answer["flaser_angles", {nBeams_, beam_}] := DoubleToBits[
  FlaserAngles[whole[nBeams]][[whole[beam] + 1]]];

answer["read_ranges", {range_, zMax_, noReturn_}] := With[
  {read = ReadRanges[{double[range]}, number[zMax], noReturn]},
  line[{DoubleToBits[read[[1, 1]]], flag[read[[2, 1]]], flag[read[[3, 1]]]}]];
answer["beam_endpoints", {x_, y_, theta_, angle_, z_}] := With[
  {ends = BeamEndpoints[
    Pose[number[x], number[y], number[theta]], {number[angle]}, {number[z]}]},
  line[{DoubleToBits[ends[[1, 1]]], DoubleToBits[ends[[2, 1]]]}]];

answer["philox", words_] := line[Map[
  IntegerString[#, 16, 8] &,
  Philox4x32[Map[FromDigits[#, 16] &, Take[words, 4]],
    Map[FromDigits[#, 16] &, Take[words, -2]]]]];
answer["normal_deviate", {seed_, scan_, beam_}] := DoubleToBits[
  First[NormalDeviate[whole[seed], whole[scan], {whole[beam]}]]];

(* All lines of a function at once: what takes a list is asked for all numbers
   that a list may hold, as mapping does. *)
answers[function_, rows_] := If[
  MemberQ[{"sin", "cos", "exp", "log"}, function],
  portableAnswers[function, Map[First, rows]],
  Map[answer[function, #] &, rows]];

inListQ[function_, x_] := NumberQ[x] && (function =!= "log" || x > 0);

portableAnswers[function_, texts_] := Module[
  {x = Map[double, texts], together, alone},
  together = Pick[Range[Length[x]], Map[inListQ[function, #] &, x]];
  alone = Complement[Range[Length[x]], together];
  Map[Last, Sort[Join[
    Map[{#, answer[function, {texts[[#]]}]} &, alone],
    If[together === {}, {}, Transpose[{together,
      Map[DoubleToBits, portable[function][x[[together]]]]}]]]]]];
