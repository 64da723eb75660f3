(* Writing a map: picture (PGM), its description (YAML), log-odds (SPEC.md
   section 7). Rows are written as they come. *)

Begin["OccupancyGrid`Private`"];

(* one row of the map in a variable *)
SetAttributes[rowOf, HoldFirst];
rowOf[map_, gy_] := With[{width = map[[1]]["width"]},
  Table[map[[2, cell]], {cell, (gy*width) + 1, (gy + 1)*width}]];

(* the text of what calls write with its pieces *)
collected[produce_] := StringJoin[First[Last[Reap[produce[Sow]]]]];

(* [snippet: pixel] *)
Pixel[logOdds_] := Floor[((1. - Sigmoid[logOdds])*255.) + 0.5];
(* [/snippet] *)

(* [snippet: map-pgm] *)
MapPgm[grid_?gridValueQ, write_] := Module[{map = grid, width, height},
  width = map[[1]]["width"];
  height = map[[1]]["height"];
  write[StringJoin[
    "P2\n", ToString[width], " ", ToString[height], "\n255\n"]];
  Do[
    write[StringRiffle[Map[ToString, Pixel[rowOf[map, gy]]], " "] <> "\n"],
    {gy, height - 1, 0, -1}]];
(* [/snippet] *)
MapPgm[grid_?gridValueQ] := collected[MapPgm[grid, #] &];
MapPgm[___] := wrongArguments[MapPgm];

MapLogOdds[grid_?gridValueQ, write_] := Module[{map = grid, width, height},
  width = map[[1]]["width"];
  height = map[[1]]["height"];
  write[StringJoin[
    "# logodds ", ToString[width], " ", ToString[height], "\n"]];
  Do[
    write[StringRiffle[Map[decimalText, rowOf[map, gy]], " "] <> "\n"],
    {gy, 0, height - 1}]];
MapLogOdds[grid_?gridValueQ] := collected[MapLogOdds[grid, #] &];
MapLogOdds[___] := wrongArguments[MapLogOdds];

gridValueQ[grid_] := MatchQ[grid, {_Association, _List}];

MapYaml[grid_?gridValueQ, image_String] := With[{model = First[grid]},
  StringJoin[
    "image: ", yamlName[image], "\n",
    "mode: trinary\n",
    "resolution: ", fixed[model["resolution"]], "\n",
    "origin: [", fixed[model["originX"]], ", ", fixed[model["originY"]],
    ", 0.0]\n",
    "negate: 0\n",
    "occupied_thresh: ", fixed[occupiedThreshold[model["l0"]]], "\n",
    "free_thresh: ", fixed[freeThreshold[model["l0"]]], "\n"]];
MapYaml[___] := wrongArguments[MapYaml];

(* The thresholds of p0 = 0.5, moved with the prior, and at least half a grey
   value away from its own: a cell that nothing touched loads as unknown. *)
occupiedThreshold[l0_] := With[{
    moved = Sigmoid[l0 + Logit[0.65]],
    least = Divide[(255 - Pixel[l0]) + 0.5, 255.]},
  clamp[If[moved - least < 0, least, moved], 0., 1.]];
freeThreshold[l0_] := With[{
    moved = Sigmoid[l0 + Logit[0.196]],
    most = Divide[(255 - Pixel[l0]) - 0.5, 255.]},
  clamp[If[moved - most > 0, most, moved], 0., 1.]];

(* a file name as YAML has it *)
yamlName[image_] := If[
  StringMatchQ[image, RegularExpression["[A-Za-z0-9_][A-Za-z0-9_.-]*"]],
  image,
  StringJoin["\"", Map[yamlCharacter, Characters[image]], "\""]];
yamlCharacter[character_] := With[
  {code = First[ToCharacterCode[character]]},
  Which[
    character === "\"" || character === "\\", "\\" <> character,
    code < 32 || code == 127,
      "\\x" <> ToUpperCase[IntegerString[code, 16, 2]],
    True, character]];

(* {m, k}, whole numbers with |x| = m * 2^k *)
wholeAndPower[x_] := If[x == 0, {0, 0},
  With[{parts = exponentAndFraction[{x}]},
    {Floor[First[Last[parts]]*N[2^52]], First[First[parts]] - 52}]];

signText[x_] := If[x < 0, "-", ""];

(* A decimal that reads back to x. InputForm gives the shortest; it is not
   trusted with numbers that it writes with an exponent, which get 17 digits
   of their exact value. *)
decimalText[x_] := Which[
  x == 0, "0.0",
  Abs[x] - 0.001 > 0 && Abs[x] - 100000. < 0,
    With[{text = ToString[x, InputForm]},
      If[StringTake[text, -1] === ".", text <> "0", text]],
  True, signText[x] <> seventeenDigits @@ wholeAndPower[x]];

seventeenDigits[m_, k_] := Module[{p, q, power, digits},
  p = m*2^Max[k, 0];
  q = 2^Max[-k, 0];
  (* the lengths tell the number of digits but for one *)
  power = (IntegerLength[p] - IntegerLength[q]) - 16;
  digits = roundHalfEven[p*10^Max[-power, 0], q*10^Max[power, 0]];
  If[IntegerLength[digits] < 17,
    power = power - 1;
    digits = roundHalfEven[p*10^Max[-power, 0], q*10^Max[power, 0]]];
  While[Mod[digits, 10] == 0,
    digits = Quotient[digits, 10];
    power = power + 1];
  ToString[digits] <> "e" <> ToString[power]];

(* The exact value rounded to nine decimals, ties to even, without trailing
   zeros but one. *)
fixed[x_] := Module[{m, k, units, decimals},
  {m, k} = wholeAndPower[x];
  units = roundHalfEven[(m*10^9)*2^Max[k, 0], 2^Max[-k, 0]];
  decimals = StringReplace[
    IntegerString[Mod[units, 10^9], 10, 9],
    RegularExpression["0+$"] -> ""];
  StringJoin[
    If[units == 0, "", signText[x]],
    ToString[Quotient[units, 10^9]], ".",
    If[decimals === "", "0", decimals]]];

End[];
