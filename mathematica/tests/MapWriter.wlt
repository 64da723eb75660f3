tiny[] := Module[{grid},
  grid = OccupancyGrid[GridSpec[3, 2, 0.1, -11., 0.000000123456],
    0.5, 0.75, 0.3, -8., 8.];
  UpdateCell[grid, 0, 0, First[grid]["lFree"]];
  Do[UpdateCell[grid, 2, 1, First[grid]["lOcc"]], {9}];
  UpdateCell[grid, 1, 1, 1.*^-20];
  grid];

VerificationTest[
  {Map[Pixel, LogOdds[tiny[]]], Pixel[0.], Pixel[-8.], Pixel[8.]},
  {{{179, 128, 128}, {128, 128, 0}}, 128, 255, 0},
  TestID -> "pixels"]
VerificationTest[
  With[{grid = tiny[]}, MapPgm[grid]],
  "P2\n3 2\n255\n128 128 0\n179 128 128\n",
  TestID -> "the picture"]
VerificationTest[
  With[{grid = tiny[]}, MapYaml[grid, "a.pgm"]],
  "image: a.pgm
mode: trinary
resolution: 0.1
origin: [-11.0, 0.000000123, 0.0]
negate: 0
occupied_thresh: 0.65
free_thresh: 0.196
",
  TestID -> "the description"]
yamlLines[p0_, resolution_, x_, y_] := StringSplit[MapYaml[
  OccupancyGrid[GridSpec[1, 1, resolution, x, y], p0, 0.75, 0.3, -8., 8.],
  "a.pgm"], "\n"];
VerificationTest[
  Map[Take[Apply[yamlLines[0.5, ##] &, #], {3, 4}] &, {
    {1000., -1.*^7, 1.*^-10}, {0.0625, -0.0000000005, 0.1234567895},
    {0.0009765625, 0.0029296875, -12.50000000049}}],
  {{"resolution: 1000.0", "origin: [-10000000.0, 0.0, 0.0]"},
    {"resolution: 0.0625", "origin: [-0.000000001, 0.123456789, 0.0]"},
    {"resolution: 0.000976562", "origin: [0.002929688, -12.5, 0.0]"}},
  TestID -> "nine decimals, ties to even, trailing zeros dropped"]

(* the cell that nothing touched lies between the thresholds, for every p0 *)
thresholds[p0_] := Map[
  ReadNumber[Last[StringSplit[#]]] &,
  Take[yamlLines[p0, 1., 0., 0.], -2]];
untouched[p0_] := Divide[255. - Pixel[Logit[p0]], 255.];
VerificationTest[
  Select[{0.001, 0.05, 0.15, 0.3, 0.5, 0.7, 0.85, 0.95, 0.999},
    !(First[thresholds[#]] - untouched[#] >= 0
      && untouched[#] - Last[thresholds[#]] >= 0
      && First[thresholds[#]] <= 1 && Last[thresholds[#]] >= 0) &],
  {},
  TestID -> "what nothing touched is unknown, for every prior"]
VerificationTest[
  Take[yamlLines[0.7, 1., 0., 0.], -2],
  {"occupied_thresh: 0.8125", "free_thresh: 0.362579281"},
  TestID -> "thresholds move with the prior"]

VerificationTest[
  Map[First[StringSplit[MapYaml[tiny[], #], "\n"]] &, {
    "a.pgm", "A_b-1.c.pgm", "1.pgm", "-a.pgm", ".a.pgm", "run #2.pgm",
    "lab: monday.pgm", "[x].pgm", "'q'.pgm", "a\"b\\c.pgm",
    FromCharacterCode[{97, 9, 27, 127}],
    FromCharacterCode[{246, 46, 112}]}],
  {"image: a.pgm", "image: A_b-1.c.pgm", "image: 1.pgm",
    "image: \"-a.pgm\"", "image: \".a.pgm\"", "image: \"run #2.pgm\"",
    "image: \"lab: monday.pgm\"", "image: \"[x].pgm\"",
    "image: \"'q'.pgm\"", "image: \"a\\\"b\\\\c.pgm\"",
    "image: \"a\\x09\\x1B\\x7F\"",
    StringJoin["image: \"", FromCharacterCode[246], ".p\""]},
  TestID -> "names that YAML would read otherwise stand in quotes"]

VerificationTest[
  With[{grid = tiny[]}, MapLogOdds[grid]],
  "# logodds 3 2\n-0.8472978603872036 0.0 0.0\n0.0 \
99999999999999995e-37 8.0\n",
  TestID -> "log-odds"]
(* what is written reads back: large, small, powers of two, random *)
VerificationTest[
  Module[{numbers, grid, text},
    numbers = Join[
      {1000., -1000., 0.1, 1.*^-5, 0.00000005960464477539063, 123456.7,
        5.551115123125783*^-17, 0.3, -0.001, 100000., 99999.99999999999},
      NestList[0.5*# &, 1., 60],
      Table[(randomBelow[2^22]*N[2^-22] - 0.5)*10.^(randomBelow[12] - 8),
        {100}]];
    grid = OccupancyGrid[GridSpec[Length[numbers], 1, 1., 0., 0.],
      0.5, 0.75, 0.3, -2000., 200000.];
    Do[UpdateCell[grid, i - 1, 0, numbers[[i]]], {i, Length[numbers]}];
    text = Rest[StringSplit[MapLogOdds[grid]]];
    {bits[Map[ReadNumber, Drop[text, 3]]] === bits[numbers],
      Max[Map[
        IntegerLength[FromDigits[
          StringDelete[First[StringSplit[#, "e"]], {"-", "."}]]] &,
        Drop[text, 3]]] <= 17}],
  {True, True},
  TestID -> "log-odds read back"]
