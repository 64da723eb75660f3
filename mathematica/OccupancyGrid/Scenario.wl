(* Reading a scenario: a CARMEN log with PARAM, WALL and POSE lines (SPEC.md
   sections 5 and 8).

   The file is read as bytes and as a whole: bytes are the only form in which
   every interpreter hands over a file that is not text, and those that count
   the lines of a file count them differently. *)

Begin["OccupancyGrid`Private`"];

(* --- Numbers --- *)

numberForm = RegularExpression[
  "[+-]?([0-9]+(\\.[0-9]*)?|\\.[0-9]+)([eE][+-]?[0-9]+)?"];
wordForm = RegularExpression["[+-]?([nN][aA][nN]|[iI][nN][fF]|"
  <> "[iI][nN][fF][iI][nN][iI][tT][yY])"];
plainForm = RegularExpression["[0-9]{1,9}\\.[0-9]{1,6}"];
wholeForm = RegularExpression["[0-9]+"];

ReadNumber[token_String] := Which[
  StringMatchQ[token, numberForm],
    If[StringStartsQ[token, "-"], -1, 1]*readDecimal[token],
  StringMatchQ[token, wordForm],
    Which[
      StringContainsQ[ToLowerCase[token], "nan"], Indeterminate,
      StringStartsQ[token, "-"], -Infinity,
      True, Infinity],
  True, $Failed];
ReadNumber[___] := wrongArguments[ReadNumber];

(* digits * 10^power, without the sign *)
readDecimal[token_] := Module[{parts, fields, digits, power},
  parts = StringSplit[
    ToLowerCase[StringReplace[token, StartOfString ~~ ("+" | "-") -> ""]],
    "e"];
  (* a point alone at either end leaves an empty field out *)
  fields = StringSplit["0" <> First[parts] <> "0", "."];
  digits = FromDigits[StringJoin[fields]];
  power = If[Length[parts] > 1, wholeNumber[Last[parts]], 0]
    - If[Length[fields] > 1, StringLength[Last[fields]], 0];
  If[Length[fields] == 1, digits = Quotient[digits, 10]];
  decimal[digits, power]];

wholeNumber[text_] := If[StringStartsQ[text, "-"], -1, 1]*
  FromDigits[StringReplace[text, StartOfString ~~ ("+" | "-") -> ""]];

tens = NestList[10.*# &, 1., 22];

(* Both operands of the first two are exact, so that there is one rounding. *)
decimal[digits_, power_] := Which[
  digits == 0, 0.,
  digits < 2^53 && 0 <= power <= 22,
    N[digits]*tens[[power + 1]],
  digits < 2^53 && -22 <= power < 0,
    Divide[N[digits], tens[[1 - power]]],
  IntegerLength[digits] + power > 301, Infinity,
  IntegerLength[digits] + power < -300, 0.,
  True, withinLimits[nearest[
    digits*10^Max[power, 0], 10^Max[-power, 0]]]];

withinLimits[x_] := Which[
  x - 1.*^300 >= 0, Infinity,
  x - nearest[1, 10^300] < 0, 0.,
  True, x];

(* the double nearest to p/q, ties to even, in whole numbers *)
nearest[p_, q_] := Module[{k, whole},
  k = (IntegerLength[p, 2] - IntegerLength[q, 2]) - 53;
  If[p*2^Max[-k, 0] >= q*2^(53 + Max[k, 0]), k = k + 1];
  whole = roundHalfEven[p*2^Max[-k, 0], q*2^Max[k, 0]];
  scaled[N[whole], k]];

roundHalfEven[p_, q_] := With[{whole = Quotient[p, q], rest = Mod[p, q]},
  Which[
    2*rest > q, whole + 1,
    2*rest < q, whole,
    EvenQ[whole], whole,
    True, whole + 1]];

(* --- The table of parameters --- *)

(* a parameter's name in the file: its key in the settings, its kind, its
   limits *)
coordinateLimits = {"-10000000", "10000000"};
angleLimits = {"-1000000", "1000000"};
parameters = <|
  "width" -> {"width", "whole", "1", "25000000"},
  "height" -> {"height", "whole", "1", "25000000"},
  "resolution" -> {"resolution", "real", "0.001", "1000"},
  "origin_x" -> {"originX", "real", "-10000000", "10000000"},
  "origin_y" -> {"originY", "real", "-10000000", "10000000"},
  "max_range" -> {"maxRange", "real", "0.001", "10000"},
  "min_range" -> {"minRange", "real", "0", "10000"},
  "p0" -> {"p0", "probability"},
  "p_occ" -> {"pOcc", "probability"},
  "p_free" -> {"pFree", "probability"},
  "l_min" -> {"lMin", "real", "-1000", "1000"},
  "l_max" -> {"lMax", "real", "-1000", "1000"},
  "no_return" -> {"noReturn", "no_return"},
  "fov" -> {"fov", "real", "0", "6.283185307179586"},
  "beams" -> {"beams", "whole", "1", "100000"},
  "noise_std" -> {"noiseStd", "real", "0", "1000"}|>;
required = {
  "width", "height", "resolution", "origin_x", "origin_y", "max_range"};
defaults = <|
  "minRange" -> 0., "p0" -> 0.5, "pOcc" -> 0.75, "pFree" -> 0.3,
  "lMin" -> -8., "lMax" -> 8., "noReturn" -> "free", "fov" -> PortablePi,
  "beams" -> 181, "noiseStd" -> 0.02|>;

NewGrid[settings_Association] := OccupancyGrid[
  GridSpec[settings["width"], settings["height"], settings["resolution"],
    settings["originX"], settings["originY"]],
  settings["p0"], settings["pOcc"], settings["pFree"],
  settings["lMin"], settings["lMax"]];
NewGrid[___] := wrongArguments[NewGrid];

(* --- Going through the file --- *)

(* One file is read at a time: theFile and theLine are at hand, values and
   lineOf hold the parameters and their lines, walls the walls, and settings
   are None up to the first scan. *)
fail[reason_] := fail[reason, theLine];
fail[reason_, line_] := Throw[
  oneLine[theFile] <> ":" <> ToString[line] <> ": " <> reason, "scenario"];

(* a name as a message shows it: control characters would break its line *)
oneLine[text_] := StringReplace[
  text, RegularExpression["[\\x00-\\x1f\\x7f]"] -> "?"];

ReadScenario[path_String] := Module[{lines, scans},
  theFile = path;
  theLine = 0;
  values = <||>;
  lineOf = <||>;
  walls = {};
  settings = None;
  lines = readLines[path];
  scans = DeleteCases[Map[readLine, lines], Null];
  If[settings === None, fail["no scan"]];
  <|"name" -> ScenarioName[path], "settings" -> settings,
    "walls" -> walls, "scans" -> scans|>];
ReadScenario[___] := wrongArguments[ReadScenario];

ScenarioName[path_String] := Module[{name, dots},
  name = Last[StringSplit[path, "/"], ""];
  dots = StringPosition[name, "."];
  If[dots === {} || First[Last[dots]] == 1,
    name,
    StringTake[name, First[Last[dots]] - 1]]];
ScenarioName[___] := wrongArguments[ScenarioName];

(* The file of a name, where the kernel would read more into it: a command
   after !, somebody's folder after ~; and a program an option after -. *)
plainPath[path_] := If[
  StringStartsQ[path, "!" | "~" | "-"], "./" <> path, path];

(* The bars keep StringSplit from dropping empty lines at either end. *)
readLines[file_] := Module[{path = plainPath[file], bytes, lines},
  bytes = If[
    StringEndsQ[file, "/"] || DirectoryQ[path] || !FileExistsQ[path],
    $Failed,
    Quiet[Check[BinaryReadList[path], $Failed]]];
  If[!VectorQ[bytes, IntegerQ], fail["cannot be read"]];
  lines = StringSplit["|" <> FromCharacterCode[bytes] <> "|", "\n"];
  lines[[1]] = StringDrop[First[lines], 1];
  lines[[-1]] = StringDrop[Last[lines], -1];
  If[Last[lines] === "", Most[lines], lines]];

skippedForm = RegularExpression["(?s)[ \t]*(#.*)?"];
asciiForm = RegularExpression["[ -~\t]*"];
keywordForm = RegularExpression["[A-Za-z_][A-Za-z0-9_]*"];

(* a scan, or Null for a line that is none *)
readLine[text_] := Module[{line, fields},
  theLine = theLine + 1;
  line = If[StringEndsQ[text, "\r"], StringDrop[text, -1], text];
  If[StringMatchQ[line, skippedForm], Return[Null, Module]];
  If[!StringMatchQ[line, asciiForm], fail["not plain ASCII text"]];
  fields = StringSplit[line];
  If[!StringMatchQ[First[fields], keywordForm],
    fail["'" <> First[fields] <> "' is not a keyword"]];
  readFields[First[fields], Rest[fields]]];

readFields[keyword_, fields_] := Switch[keyword,
  "POSE" | "FLASER" | "ROBOTLASER1",
    If[settings === None, settings = checkSettings[]];
    Switch[keyword,
      "POSE", readPose[expect["POSE", 3, withoutComment[fields]]],
      "FLASER", readFlaser[fields],
      "ROBOTLASER1", readRobotlaser1[fields]],
  "PARAM",
    If[fields =!= {} && StringStartsQ[First[fields], "occgrid_"],
      beforeScans["PARAM"];
      readParameter[expect["PARAM", 2, withoutComment[fields]]]];
    Null,
  "WALL",
    beforeScans["WALL"];
    With[{ends = expect["WALL", 4, withoutComment[fields]]},
      walls = Append[walls,
        Segment @@ MapThread[coordinate, {{"x0", "y0", "x1", "y1"}, ends}]]];
    Null,
  _, Null];

withoutComment[fields_] := TakeWhile[fields, !StringStartsQ[#, "#"] &];

beforeScans[keyword_] := If[settings =!= None,
  fail[keyword <> " must stand before the first scan"]];

expect[keyword_, count_, fields_] := If[Length[fields] == count,
  fields,
  fail[StringJoin[keyword, " takes ", ToString[count], " values, found ",
    ToString[Length[fields]]]]];

(* --- PARAM --- *)

readParameter[{field_, token_}] := Module[{name, row},
  name = StringDrop[field, 8];
  row = Lookup[parameters, name, None];
  If[row === None, fail["unknown parameter " <> field]];
  If[KeyExistsQ[values, First[row]], fail[field <> " is given twice"]];
  values[First[row]] = Switch[row[[2]],
    "whole", whole[field, token, row[[3]], row[[4]]],
    "real", real[field, token, row[[3]], row[[4]]],
    "probability", probability[field, token],
    "no_return", If[token === "free" || token === "ignore",
      token,
      fail[field <> " '" <> token <> "' is not free or ignore"]]];
  lineOf[name] = theLine];

probability[field_, token_] := With[{p = number[field, token]},
  If[NumberQ[p] && p > 0 && p - 1 < 0,
    p,
    fail[field <> " '" <> token <> "' is not between 0 and 1"]]];

(* the parameters as a whole, checked together when the first scan comes *)
checkSettings[] := Module[{all, l0},
  Scan[
    If[!KeyExistsQ[values, First[parameters[#]]],
      fail["occgrid_" <> # <> " is missing"]] &,
    required];
  all = Join[defaults, values];
  If[all["width"]*all["height"] > 25000000,
    fail["the grid has more than 25000000 cells",
      latest[{"width", "height"}]]];
  If[Divide[all["maxRange"], all["resolution"]] - 1000000 > 0,
    fail["occgrid_max_range is more than 1000000 cells",
      latest[{"max_range", "resolution"}]]];
  If[all["lMin"] - all["lMax"] >= 0,
    fail["occgrid_l_min is not below occgrid_l_max",
      latest[{"l_min", "l_max"}]]];
  l0 = {Logit[all["p0"]]};
  If[First[l0] - all["lMin"] < 0 || First[l0] - all["lMax"] > 0,
    fail["logit(occgrid_p0) is not from occgrid_l_min to occgrid_l_max",
      latest[{"p0", "l_min", "l_max"}]]];
  If[all["minRange"] - all["maxRange"] >= 0,
    fail["occgrid_min_range is not below occgrid_max_range",
      latest[{"min_range", "max_range"}]]];
  all];

latest[names_] := Max[Map[Lookup[lineOf, #, 0] &, names]];

(* --- Scans --- *)

(* x, y and theta *)
readPose[{x_, y_, theta_}] := Pose[
  coordinate["x", x], coordinate["y", y], angle["theta", theta]];

(* FLASER n r1 .. rn x y theta and six fields that are not looked at *)
readFlaser[fields_] := Module[{n, ranges},
  If[fields === {}, fail["FLASER has no beam count"]];
  n = whole["beam count", First[fields], "1", "100000"];
  If[Length[fields] != n + 10,
    fail[StringJoin["FLASER with ", ToString[n], " beams takes ",
      ToString[n + 10], " values, found ", ToString[Length[fields]]]]];
  ranges = readRanges[fields[[2 ;; n + 1]]];
  RangeScan[readPose[fields[[n + 2 ;; n + 4]]], FlaserAngles[n],
    Map[fromMinRange, ranges]]];

(* ROBOTLASER1 type start fov step max accuracy mode n r1 .. rn m e1 .. em
   x y theta and eleven fields *)
readRobotlaser1[fields_] := Module[{found, n, m, start, step, ranges, at},
  found = Length[fields];
  If[found < 8, fail["ROBOTLASER1 has no beam count"]];
  n = whole["beam count", fields[[8]], "1", "100000"];
  If[found < n + 23,
    fail[StringJoin["ROBOTLASER1 with ", ToString[n],
      " beams takes at least ", ToString[n + 23], " values, found ",
      ToString[found]]]];
  m = whole["remission count", fields[[n + 9]], "0", "100000"];
  If[found != (n + m) + 23,
    fail[StringJoin["ROBOTLASER1 with ", ToString[n], " beams and ",
      ToString[m], " remissions takes ", ToString[(n + m) + 23],
      " values, found ", ToString[found]]]];
  start = {angle["start", fields[[2]]]};
  step = {angle["step", fields[[4]]]};
  ranges = readRanges[fields[[9 ;; n + 8]]];
  at = (n + m) + 10;
  RangeScan[readPose[fields[[at ;; at + 2]]],
    First[start] + (N[Range[n] - 1]*First[step]),
    Map[fromMinRange, ranges]]];

(* a range below the least one is no reading *)
fromMinRange[r_] := If[NumberQ[r] && r - settings["minRange"] < 0,
  Indeterminate,
  r];

(* Ranges are mostly of a plain form: digits, a point, digits. *)
readRanges[tokens_] := MapIndexed[
  If[StringMatchQ[#1, plainForm],
    plainNumber[StringSplit[#1, "."]],
    range[First[#2] - 1, #1]] &,
  tokens];

plainNumber[{before_, after_}] := Divide[
  N[FromDigits[before <> after]], tens[[StringLength[after] + 1]]];

range[beam_, token_] := With[
  {r = {number["range " <> ToString[beam], token]}},
  If[First[r] =!= Indeterminate && First[r] < 0,
    fail["range " <> ToString[beam] <> " '" <> token <> "' is negative"]];
  First[r]];

(* --- Values --- *)

number[field_, token_] := With[{x = {ReadNumber[token]}},
  If[First[x] === $Failed,
    fail[field <> " '" <> token <> "' is not a number"]];
  First[x]];

real[field_, token_, low_, high_] := With[{x = {number[field, token]}},
  If[First[x] === Indeterminate
      || First[x] - ReadNumber[low] < 0 || First[x] - ReadNumber[high] > 0,
    outside[field, token, low, high]];
  First[x]];

whole[field_, token_, low_, high_] := (
  If[!StringMatchQ[token, wholeForm],
    fail[field <> " '" <> token <> "' is not a whole number"]];
  With[{n = FromDigits[token]},
    If[n < FromDigits[low] || n > FromDigits[high],
      outside[field, token, low, high]];
    n]);

outside[field_, token_, low_, high_] := fail[StringJoin[
  field, " '", token, "' is not from ", low, " to ", high]];

(* metres, and radians *)
coordinate[field_, token_] := real[field, token,
  First[coordinateLimits], Last[coordinateLimits]];
angle[field_, token_] := real[field, token,
  First[angleLimits], Last[angleLimits]];

End[];
