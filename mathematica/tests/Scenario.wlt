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
  Map[ScenarioName, {"a.log", "/x/y.z/a.b.log", "x/.log", "plain", "a.", ".",
    "a.log/", "x/d.e//"}],
  {"a", "a.b", ".log", "plain", "a", ".", "a", "d"},
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
    Map[settings, {"width", "height", "resolution", "originX", "originY",
      "maxRange", "minRange", "p0", "pOcc", "pFree", "lMin", "lMax",
      "noReturn", "fov", "beams", "noiseStd"}]],
  {4, 3, 1., 0., -2.5, 10., 0., 0.5, 0.75, 0.3, -8., 8., "free",
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
    {scenario["settings"]["noReturn"], scenario["walls"],
      scenario["scans"]}],
  {"ignore", {Segment[0., 1., 2., -3.]},
    {Pose[1., 2., 3.],
      RangeScan[Pose[1., 2., 3.], FlaserAngles[2], {1.5, 2.5}],
      RangeScan[Pose[1., 2., 3.], {-1., -0.5, 0.},
        {Indeterminate, Infinity, 81.91}]}},
  TestID -> "walls and scans, comments, line ends, other programs' lines"]

VerificationTest[
  With[{scenario = readText[StringJoin[
      StringReplace[head, "_y -2.5" -> "_y -10000000"],
      "PARAM occgrid_min_range 2 # metres\n",
      "WALL -10000000 10000000 0 0\nPOSE 10000000 -1e7 1000000\n",
      "FLASER 4 1.9999999999999998 2 nan inf 1 2 3 x x x x x x\n"]]},
    {scenario["settings"]["minRange"], scenario["settings"]["originY"],
      scenario["walls"], scenario["scans"]}],
  {2., -1.*^7, {Segment[-1.*^7, 1.*^7, 0., 0.]},
    {Pose[1.*^7, -1.*^7, 1.*^6],
      RangeScan[Pose[1., 2., 3.], FlaserAngles[4],
        {Indeterminate, 2., Indeterminate, Infinity}]}},
  TestID -> "a least range, and coordinates far away"]
VerificationTest[
  bits[readText[StringReplace[head, {"_x 0" -> "_x 4123456.789012345",
      "_y -2.5" -> "_y -0.0000012345678901234"}] <> "POSE 1 2 3"][
        "settings"]["originX"]],
  bits[4123456.789012345],
  TestID -> "every bit of a large coordinate is kept"]

(* --- errors: scenarios/bad holds a file for each rule of SPEC.md section 8;
   what no file of text can hold is here --- *)

badFolder = FileNameJoin[{here, "..", "..", "scenarios", "bad"}];
VerificationTest[
  Catch[ReadScenario["no/such.log"], "scenario"],
  "no/such.log:0: cannot be read",
  TestID -> "no such file"]
VerificationTest[
  Catch[ReadScenario[$TemporaryDirectory], "scenario"],
  $TemporaryDirectory <> ":0: cannot be read",
  TestID -> "a folder"]
VerificationTest[
  Map[Catch[ReadScenario[#], "scenario"] &,
    {FileNameJoin[{here, "run_tests.wls"}] <> "/", "", "a\nb", "!ls",
      "/proc/self/mem"}],
  {FileNameJoin[{here, "run_tests.wls"}] <> "/:0: cannot be read",
    ":0: cannot be read", "a?b:0: cannot be read", "!ls:0: cannot be read",
    "/proc/self/mem:0: cannot be read"},
  TestID -> "what cannot be read"]

(* FILE: LINE: REASON *)
refusalOf[name_] := With[{file = FileNameJoin[{badFolder, name}]},
  StringReplace[
    Catch[ReadScenario[file]; file <> ":accepted", "scenario"],
    file -> name]];
badNames = Map[FileNameTake, Sort[FileNames["*.log", {badFolder}]]];
expectedRefusals = ReadList[FileNameJoin[{badFolder, "expected.txt"}], String];
VerificationTest[
  Length[badNames] > 300 && Length[badNames] == Length[expectedRefusals],
  True,
  TestID -> "there are bad scenarios"]
VerificationTest[
  Complement[expectedRefusals, Map[refusalOf, badNames]],
  {},
  TestID -> "bad scenarios"]
