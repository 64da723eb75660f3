tiny[] := Module[{grid},
  grid = NewGrid[GridSpec[3, 2, 0.1, -11., 0.000000123456],
    0.5, 0.75, 0.3, -8., 8.];
  UpdateCell[grid, 0, 0, grid["lFree"]];
  Do[UpdateCell[grid, 2, 1, grid["lOcc"]], {9}];
  UpdateCell[grid, 1, 1, 1.*^-20];
  grid];

VerificationTest[
  With[{grid = tiny[]}, Pixels[grid]],
  {{179, 128, 128}, {128, 128, 0}},
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
yamlOf[resolution_, x_, y_] := Take[StringSplit[MapYaml[
  GridSpec[1, 1, resolution, x, y], "a.pgm"], "\n"], {3, 4}];
VerificationTest[
  {yamlOf[1000., -1.*^6, 1.*^-10], yamlOf[0.0625, -0.0000000005, 0.1234567895],
    yamlOf[0.0009765625, 0.0029296875, -12.50000000049]},
  {{"resolution: 1000.0", "origin: [-1000000.0, 0.0, 0.0]"},
    {"resolution: 0.0625", "origin: [-0.000000001, 0.123456789, 0.0]"},
    {"resolution: 0.000976562", "origin: [0.002929688, -12.5, 0.0]"}},
  TestID -> "nine decimals, ties to even, trailing zeros dropped"]

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
    grid = NewGrid[GridSpec[Length[numbers], 1, 1., 0., 0.],
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

folder = temporaryFile["-maps"];
VerificationTest[
  Module[{grid = Null},
    grid = tiny[];
    WriteMap[FileNameJoin[{folder, "a", "b"}], "m", grid];
    WriteMap[FileNameJoin[{folder, "a", "b"}], "m", grid];
    {Sort[Map[FileNameTake,
        Join[FileNames["*", {FileNameJoin[{folder, "a", "b"}]}],
          FileNames[".*", {FileNameJoin[{folder, "a", "b"}]}]]]],
      ReadString[FileNameJoin[{folder, "a", "b", "m.pgm"}]] === MapPgm[grid],
      ReadString[FileNameJoin[{folder, "a", "b", "m.yaml"}]]
        === MapYaml[grid, "m.pgm"],
      ReadString[FileNameJoin[{folder, "a", "b", "m.logodds"}]]
        === MapLogOdds[grid]}],
  {{"m.logodds", "m.pgm", "m.yaml"}, True, True, True},
  TestID -> "three files in a new folder, twice"]
VerificationTest[
  With[{grid = tiny[], name = FromCharacterCode[{246, 32, 22320}]},
    WriteMap[folder, name, grid];
    {Sort[Map[FileNameTake, FileNames[name <> "*", {folder}]]]
      === Map[name <> # &, {".logodds", ".pgm", ".yaml"}],
      ToCharacterCode[First[StringSplit[
        ReadString[FileNameJoin[{folder, name <> ".yaml"}]], "\n"]]]
      === ToCharacterCode["image: " <> name <> ".pgm"]}],
  {True, True},
  TestID -> "a name outside ASCII"]
VerificationTest[
  With[{grid = tiny[]},
    Catch[WriteMap[FileNameJoin[{folder, "a", "b", "m.pgm", "c"}], "m", grid],
      "output"]],
  FileNameJoin[{folder, "a", "b", "m.pgm", "c"}] <> ": cannot be written",
  TestID -> "a folder that cannot be made"]
VerificationTest[
  With[{grid = tiny[]},
    CreateDirectory[FileNameJoin[{folder, "n.logodds"}]];
    {Catch[WriteMap[folder, "n", grid], "output"],
      FileNames["*.part", {folder}], FileNames[".*", {folder}]}],
  {FileNameJoin[{folder, "n.logodds"}] <> ": cannot be written", {}, {}},
  TestID -> "a file that cannot be written leaves nothing beside it"]
DeleteDirectory[folder, DeleteContents -> True];
