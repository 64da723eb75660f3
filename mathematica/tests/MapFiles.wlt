(* as old as a text says *)
touch[name_, when_] := Run[StringJoin[
  "touch -d '", when, "' ", shellQuoted[folder <> "/" <> name]]];
leftovers = {".occgrid-abc-1.part", ".occgrid-12-3.part",
  ".occgrid-a_b.part", ".other-12.part"};

tinyMap = OccupancyGrid[GridSpec[2, 2, 0.5, 0., 0.],
  0.5, 0.75, 0.3, -8., 8.];
UpdateCell[tinyMap, 1, 0, First[tinyMap]["lOcc"]];

folder = temporaryFile["-maps"];
VerificationTest[
  Module[{grid = Null},
    grid = tinyMap;
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
  With[{grid = tinyMap, name = FromCharacterCode[{246, 32, 22320}]},
    WriteMap[folder, name, grid];
    {Sort[Map[FileNameTake, FileNames[name <> "*", {folder}]]]
      === Map[name <> # &, {".logodds", ".pgm", ".yaml"}],
      ToCharacterCode[First[StringSplit[
        ReadString[FileNameJoin[{folder, name <> ".yaml"}]], "\n"]]]
      === ToCharacterCode[StringJoin["image: \"", name, ".pgm\""]]}],
  {True, True},
  TestID -> "a name outside ASCII"]

inFolder[] := Sort[Map[FileNameTake, Join[
  FileNames["*", {folder}], FileNames[".*", {folder}]]]];
refused[arguments__] := Catch[WriteMap[arguments], "output"];
before = inFolder[];
VerificationTest[
  refused[FileNameJoin[{folder, "a", "b", "m.pgm", "c"}], "m", tinyMap],
  FileNameJoin[{folder, "a", "b", "m.pgm", "c"}] <> ": cannot be written",
  TestID -> "a folder that cannot be made"]

(* a folder in the way of one file: none is written *)
CreateDirectory[FileNameJoin[{folder, "n.logodds"}]];
CreateDirectory[FileNameJoin[{folder, "p.pgm"}]];
VerificationTest[
  {refused[folder <> "//", "n", tinyMap], refused[folder, "p", tinyMap],
    inFolder[]},
  {folder <> "/n.logodds: cannot be written",
    folder <> "/p.pgm: cannot be written",
    Sort[Join[before, {"n.logodds", "p.pgm"}]]},
  TestID -> "a folder in the way"]
VerificationTest[
  {refused["/proc", "m", tinyMap], refused["/dev/null", "m", tinyMap],
    refused["/dev/null///", "m", tinyMap]},
  {"/proc/m.pgm: cannot be written", "/dev/null: cannot be written",
    "/dev/null: cannot be written"},
  TestID -> "where nobody may write"]
VerificationTest[
  StringReplace[refused[folder, FromCharacterCode[
      Join[{120, 10, 121}, ConstantArray[97, 300]]], tinyMap],
    "a.." -> "a.."] === StringJoin[folder, "/x?y",
      FromCharacterCode[ConstantArray[97, 300]], ".pgm: cannot be written"],
  True,
  TestID -> "a name that is too long; a message is one line"]

(* names up to the system's limit *)
longName = FromCharacterCode[ConstantArray[110, 247]];
VerificationTest[
  WriteMap[folder, longName, tinyMap];
  Map[FileExistsQ[FileNameJoin[{folder, longName <> #}]] &,
    {".pgm", ".yaml", ".logodds"}],
  {True, True, True},
  TestID -> "a long name"]

(* names with characters that mean something to a shell or to YAML *)
oddNames = {"a\"b", "a'b", "a\\b", "a`b", "$HOME", "a;b", "a b", "*", "~",
  "!x", "-x", "[x]", "#", "%s"};
VerificationTest[
  Select[oddNames,
    (WriteMap[folder, #, tinyMap];
      BinaryReadList[StringJoin[folder, "/", #, ".pgm"]]
        =!= ToCharacterCode[MapPgm[tinyMap]]) &],
  {},
  TestID -> "odd names"]

(* what killed runs left goes when it is a day old, and only that *)
VerificationTest[
  touch[leftovers[[1]], "25 hours ago"];
  touch[leftovers[[2]], "23 hours ago"];
  touch[leftovers[[3]], "25 hours ago"];
  touch[leftovers[[4]], "25 hours ago"];
  WriteMap[folder, "z", tinyMap];
  Map[FileExistsQ[FileNameJoin[{folder, #}]] &, leftovers],
  {False, True, True, True},
  TestID -> "old temporary files are removed"]
DeleteDirectory[folder, DeleteContents -> True];
