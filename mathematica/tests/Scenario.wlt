(* --- numbers --- *)

VerificationTest[
  Map[ReadNumber, {"0", "-0", "1", "+1.", "-.5", "5.e1", "1E-2", "007.50",
    "+.5e+1", "0e99999", "2.5000000000000000000000000000000"}],
  {0., 0., 1., 1., -0.5, 50., 0.01, 7.5, 5., 0., 2.5},
  TestID -> "forms of numbers"]
VerificationTest[
  Map[ReadNumber, {"nan", "-NaN", "inf", "+Infinity", "-INF", "-infinity"}],
  {Indeterminate, Indeterminate, Infinity, Infinity, -Infinity, -Infinity},
  TestID -> "words for numbers"]
VerificationTest[
  Map[ReadNumber, {"", "x", "1e", ".", "-", "1e5.", "0x10", "1_0", "--1",
    "nan1", "infin", "1*^3", "1/2", "Pi", "1 ", "\[CapitalAGrave]"}],
  ConstantArray[$Failed, 16],
  TestID -> "no numbers"]
VerificationTest[
  Map[ReadNumber, {"1e300", "-1e300", "9.99999999999999999999e299",
    "1e-301", "-9e-301", "1e999999999999", "1e-999999999999"}],
  {Infinity, -Infinity, Infinity, 0., 0., Infinity, 0.},
  TestID -> "numbers too large and too small"]
(* halfway cases, many digits, both ends of the range; bits as Java reads *)
VerificationTest[
  bits[Map[ReadNumber, {
    "0.1",
    "0.30000000000000004",
    "9007199254740993",
    "9007199254740993.00000000000000000000000000001",
    "9007199254740991.5",
    "9007199254740992.99999",
    "1.00000000000000011102230246251565404236316680908203125",
    "1.00000000000000011102230246251565404236316680908203126",
    "1e23",
    "8.5e22",
    "123456789012345678901234567890e-10",
    "1e-300",
    "1.0000000000000001e-300",
    "9.999999999999999e299",
    "0.000000000000000000000000000000012345678901234567890123",
    "179769313486231570000e270",
    "2.2250738585072011e-290",
    "6.02214076e23",
    "4.35",
    "0.0444444444444444444444444444444444",
    "-13.40",
    "982597919074833788e187",
    "232860129040479666972e74",
    "0273464686958969e-63",
    "04925899139441177151e120",
    "04661099069584830e17",
    "119803649420555e-159",
    "678698198463464848506e22",
    "699205755947090e-279",
    "47499525255944610924e212",
    "435261195537215397e-23",
    "108359245195926484e175",
    "64696062307986830784e256",
    "31941300836900712843e-280",
    "86091524870533181234207e109",
    "434988607500201e-249",
    "3.57545255280763692755152990275875605108608923377033761425991542637348\
175048828125E-12",
    "4.24813849363355399031350409380994315178270426258677616715431213378906\
25E-8",
    "303512787480897562607616",
    "11287890459.82206821441650390625",
    "3833866203688327.75",
    "18043959141211256917452476383232"}]],
  StringSplit["
    3fb999999999999a 3fd3333333333334 4340000000000000 4340000000000001
    4340000000000000 4340000000000000 3ff0000000000000 3ff0000000000001
    44b52d02c7e14af6 44b1ffdbf6b2b2eb 43e56a95319d63e1 01a56e1fc2f8f359
    01a56e1fc2f8f359 7e37e43c8800759b 3950068e359dd3b0 7c32725dd1d243ab
    03cbc16d674ec7ff 44dfe185ca57c517 4011666666666666 3fa6c16c16c16c17
    c02acccccccccccd 6a7f570931f806c4 538653a922ea2564 35d9942da744ef88
    5cba7927d63192e9 46b6fb22565ade2e 21d7ef90902f2aaf 48d37a496fe7d65a
    09168baa4eda82ae 700879e30bb41aaa 3ed24194dd3135a8 67ce667df1ae9bd7
    7932afad165293d0 09d925140bbcc278 5b536801eeebab40 0f46210f280ebbf1
    3d8f73341183c186 3e66ce98dabd2a4c 44d0115d83f18d62 4205067c50de9398
    432b3dc3125fdb10 466c77e5a59c217a"],
  TestID -> "numbers are rounded correctly"]

(* --- names --- *)

VerificationTest[
  Map[ScenarioName, {"a.log", "/x/y.z/a.b.log", "x/.log", "plain", "a.", "."}],
  {"a", "a.b", ".log", "plain", "a", "."},
  TestID -> "names of scenarios"]

(* --- a scenario --- *)

head = "PARAM occgrid_width 4
PARAM occgrid_height 3
PARAM occgrid_resolution 1
PARAM occgrid_origin_x 0
PARAM occgrid_origin_y -2.5 # metres
PARAM occgrid_max_range 10
";
readText[text_] := Module[{file = temporaryFile[".log"], stream, scenario},
  stream = OpenWrite[file, BinaryFormat -> True];
  WriteString[stream, text];
  Close[stream];
  scenario = ReadScenario[file];
  DeleteFile[file];
  scenario];
VerificationTest[
  With[{settings = readText[head <> "POSE 1 2 3"]["settings"]},
    Map[settings, {"width", "height", "resolution", "origin_x", "origin_y",
      "max_range", "p0", "p_occ", "p_free", "l_min", "l_max", "no_return",
      "fov", "beams", "noise_std"}]],
  {4, 3, 1., 0., -2.5, 10., 0.5, 0.75, 0.3, -8., 8., "free",
    3.141592653589793, 181, 0.02},
  TestID -> "settings and defaults"]
VerificationTest[
  With[{scenario = readText[StringJoin[
      "# c\[Eacute]\r\n\r\n \t \n", head,
      "PARAM robot_width 9\nPARAM\nSYNC x\n",
      "PARAM occgrid_no_return ignore\r\n\tWALL 0 1\t2 -3 # a wall\n",
      "POSE 1 2 3 # here\n",
      "FLASER 2 1.5 .25e1 1 2 3 x x x x x x\n",
      "ROBOTLASER1 x -1 x 0.5 x x x 3 nan inf 81.91 2 x x 1 2 3",
      " x x x x x x x x x x x\r"]]},
    {scenario["settings"]["no_return"], scenario["walls"],
      scenario["scans"]}],
  {"ignore", {Segment[0., 1., 2., -3.]},
    {{1., 2., 3.},
      {{1., 2., 3.}, FlaserAngles[2], {1.5, 2.5}},
      {{1., 2., 3.}, {-1., -0.5, 0.}, {Indeterminate, Infinity, 81.91}}}},
  TestID -> "walls and scans, comments, line ends, other programs' lines"]

(* --- errors: every row of SPEC.md section 8 --- *)

scan = "POSE 1 1 0\n";
good = StringSplit[head, "\n"];
without[name_] := StringJoin[Map[# <> "\n" &,
  Select[good, !StringContainsQ[#, "occgrid_" <> name <> " "] &]]];
flaser = "FLASER 2 1 2 0.5 0.5 0 0 0 0 1.5 host 2.5";
laser = "ROBOTLASER1 0 -1.5 3 3 81.9 0.1 0 2 1 2 0 0.5 0.5 0 0 0 0 0 0 0 0 \
0 0 0 0";

VerificationTest[
  Catch[ReadScenario["no/such.log"], "scenario"],
  "no/such.log:0: cannot be read",
  TestID -> "no such file"]
VerificationTest[
  Catch[ReadScenario[$TemporaryDirectory], "scenario"],
  $TemporaryDirectory <> ":0: cannot be read",
  TestID -> "a folder"]

(* bytes cannot be written as text everywhere *)
refusalOfBytes[codes_] := Module[
  {file = temporaryFile[".log"], stream, answer},
  stream = OpenWrite[file, BinaryFormat -> True];
  BinaryWrite[stream, codes];
  Close[stream];
  answer = Catch[ReadScenario[file]; "accepted", "scenario"];
  DeleteFile[file];
  StringReplace[answer, file <> ":" -> ""]];
VerificationTest[
  Map[refusalOfBytes[Join[ToCharacterCode["# x\nPOSE 0 0 "], {#, 10}]] &,
    {255, 195, 0, 127, 31, 11, 12}],
  ConstantArray["2: not plain ASCII text", 7],
  TestID -> "bytes that are no plain text"]
VerificationTest[
  Map[refusalOfBytes, {
    {35, 255, 0, 13, 10, 32, 9, 35, 200},
    {13, 80, 10}, {80, 13, 13, 10}, {239, 187, 191, 35, 10}, {}, {10, 10}}],
  {"2: no scan", "1: not plain ASCII text", "1: not plain ASCII text",
    "1: not plain ASCII text", "0: no scan", "2: no scan"},
  TestID -> "any bytes in comments, returns, no lines"]

VerificationTest[
  Map[refusal, {
    "POSE: 1", "1POSE", "# c\n\n%x 1", "pose 0 0 0\n",
    head <> scan <> "WALL x",
    head <> scan <> "PARAM occgrid_nil",
    head <> scan <> "PARAM other\nPOSE",
    "PARAM occgrid_p0", "PARAM occgrid_nil 4 5", "PARAM occgrid_p0 #4",
    "WALL 1 2 3", "WALL 1 2 3 4 5", head <> "POSE 1 # 2 3",
    "PARAM occgrid_hight 3", "PARAM occgrid_ 3",
    "PARAM occgrid_p0 0.5\n\nPARAM occgrid_p0 x"}],
  {"1: 'POSE:' is not a keyword", "1: '1POSE' is not a keyword",
    "3: '%x' is not a keyword", "1: no scan",
    "8: WALL must stand before the first scan",
    "8: PARAM must stand before the first scan",
    "9: POSE takes 3 values, found 0",
    "1: PARAM takes 2 values, found 1", "1: PARAM takes 2 values, found 3",
    "1: PARAM takes 2 values, found 1",
    "1: WALL takes 4 values, found 3", "1: WALL takes 4 values, found 5",
    "7: POSE takes 3 values, found 1",
    "1: unknown parameter occgrid_hight", "1: unknown parameter occgrid_",
    "3: occgrid_p0 is given twice"},
  TestID -> "keywords, place, number of values, names"]

VerificationTest[
  Map[refusal, {
    "PARAM occgrid_p0 1e", "WALL 1 2 x 4", head <> "POSE 1 2 c",
    "PARAM occgrid_width 4.0", "PARAM occgrid_height -4",
    "PARAM occgrid_no_return Free",
    "PARAM occgrid_width 0", "PARAM occgrid_height 25000001",
    "PARAM occgrid_resolution 0.00099999999999999",
    "PARAM occgrid_origin_x nan", "PARAM occgrid_origin_y -1e7",
    "PARAM occgrid_max_range inf", "PARAM occgrid_l_min -1000.0000000000001",
    "PARAM occgrid_fov 6.283185307179587", "PARAM occgrid_beams 100001",
    "PARAM occgrid_noise_std -1", "WALL 0 0 0 1000000.0000000002",
    "PARAM occgrid_p0 0", "PARAM occgrid_p_occ 1",
    "PARAM occgrid_p_free nan", "PARAM occgrid_p0 -inf"}],
  {"1: occgrid_p0 '1e' is not a number", "1: x1 'x' is not a number",
    "7: theta 'c' is not a number",
    "1: occgrid_width '4.0' is not a whole number",
    "1: occgrid_height '-4' is not a whole number",
    "1: occgrid_no_return 'Free' is not free or ignore",
    "1: occgrid_width '0' is not from 1 to 25000000",
    "1: occgrid_height '25000001' is not from 1 to 25000000",
    "1: occgrid_resolution '0.00099999999999999' is not from 0.001 to \
1000",
    "1: occgrid_origin_x 'nan' is not from -1000000 to 1000000",
    "1: occgrid_origin_y '-1e7' is not from -1000000 to 1000000",
    "1: occgrid_max_range 'inf' is not from 0.001 to 10000",
    "1: occgrid_l_min '-1000.0000000000001' is not from -1000 to 1000",
    "1: occgrid_fov '6.283185307179587' is not from 0 to 6.283185307179586",
    "1: occgrid_beams '100001' is not from 1 to 100000",
    "1: occgrid_noise_std '-1' is not from 0 to 1000",
    "1: y1 '1000000.0000000002' is not from -1000000 to 1000000",
    "1: occgrid_p0 '0' is not between 0 and 1",
    "1: occgrid_p_occ '1' is not between 0 and 1",
    "1: occgrid_p_free 'nan' is not between 0 and 1",
    "1: occgrid_p0 '-inf' is not between 0 and 1"},
  TestID -> "values and limits"]

VerificationTest[
  Map[refusal[head <> #] &, {
    "FLASER", "FLASER x", "FLASER 0", "FLASER 100001", flaser <> " 1",
    StringReplace[flaser, "2 1 2" -> "2 x -1"],
    StringReplace[flaser, "2 1 2" -> "2 1 -1"],
    StringReplace[flaser, "2 1 2" -> "2 1 -inf"],
    StringReplace[flaser, "0.5 0.5" -> "0.5 nan"],
    "ROBOTLASER1 0 0 0 0 0 0 0", "ROBOTLASER1 a b c d e f g h",
    "ROBOTLASER1 a b c d e f g 0", StringReplace[laser, " 1 2 0 " -> " 1 x "],
    StringReplace[laser, " 1 2 0 " -> " x y 1.0 "],
    StringReplace[laser, " 1 2 0 " -> " 1 2 100001 "], laser <> " 0",
    StringReplace[laser, " 1 2 0 " -> " 1 2 2 7 "],
    StringReplace[laser, "-1.5" -> "x"],
    StringReplace[laser, " 3 3 " -> " 3 inf "],
    StringReplace[laser, " 1 2 0 " -> " 1 -2 0 "],
    StringReplace[laser, " 0.5 0.5 " -> " 0.5 y "]}],
  {"7: FLASER has no beam count", "7: beam count 'x' is not a whole number",
    "7: beam count '0' is not from 1 to 100000",
    "7: beam count '100001' is not from 1 to 100000",
    "7: FLASER with 2 beams takes 12 values, found 13",
    "7: range 0 'x' is not a number", "7: range 1 '-1' is negative",
    "7: range 1 '-inf' is negative",
    "7: y 'nan' is not from -1000000 to 1000000",
    "7: ROBOTLASER1 has no beam count",
    "7: beam count 'h' is not a whole number",
    "7: beam count '0' is not from 1 to 100000",
    "7: ROBOTLASER1 with 2 beams takes at least 25 values, found 24",
    "7: remission count '1.0' is not a whole number",
    "7: remission count '100001' is not from 0 to 100000",
    "7: ROBOTLASER1 with 2 beams and 0 remissions takes 25 values, found 26",
    "7: ROBOTLASER1 with 2 beams and 2 remissions takes 27 values, found 26",
    "7: start 'x' is not a number",
    "7: step 'inf' is not from -1000000 to 1000000",
    "7: range 1 '-2' is negative", "7: y 'y' is not a number"},
  TestID -> "recorded scans"]

changed[name_, line_] := without[name] <> line <> "\n" <> scan;
VerificationTest[
  Map[refusal, {
    scan, without["width"] <> "POSE x", without["height"] <> scan,
    without["resolution"] <> scan, without["origin_x"] <> scan,
    without["origin_y"] <> flaser, without["max_range"] <> laser,
    changed["height", "PARAM occgrid_height 10000000"],
    changed["resolution", "PARAM occgrid_resolution 0.001\n"] <> scan,
    StringReplace[changed["resolution", "PARAM occgrid_resolution 0.001"],
      "range 10" -> "range 1000.001"],
    head <> "PARAM occgrid_l_min 8\n#\n" <> scan,
    head <> "PARAM occgrid_l_max 1\nPARAM occgrid_l_min 1\n" <> scan,
    head <> "PARAM occgrid_p0 0.9999\nWALL 0 0 1 1\n" <> scan,
    head <> "PARAM occgrid_l_max -1\n" <> scan,
    head <> "PARAM occgrid_l_min 0\n" <> scan,
    head, head <> "\n\n", "", "\n", "#", head <> "ODOM 1\r\n"}],
  {"1: occgrid_width is missing", "6: occgrid_width is missing",
    "6: occgrid_height is missing", "6: occgrid_resolution is missing",
    "6: occgrid_origin_x is missing", "6: occgrid_origin_y is missing",
    "6: occgrid_max_range is missing",
    "6: the grid has more than 25000000 cells", "accepted",
    "6: occgrid_max_range is more than 1000000 cells",
    "7: occgrid_l_min is not below occgrid_l_max",
    "8: occgrid_l_min is not below occgrid_l_max",
    "7: logit(occgrid_p0) is not from occgrid_l_min to occgrid_l_max",
    "7: logit(occgrid_p0) is not from occgrid_l_min to occgrid_l_max",
    "accepted", "6: no scan", "8: no scan", "0: no scan", "1: no scan",
    "1: no scan", "7: no scan"},
  TestID -> "the parameters as a whole, and files without a scan"]
