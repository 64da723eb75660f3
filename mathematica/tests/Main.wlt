scenarios = FileNameJoin[{here, "..", "..", "scenarios"}];
out = temporaryFile["-out"];
pgm[name_] := ReadString[FileNameJoin[{out, name <> ".pgm"}]];
golden[name_] := ReadString[
  FileNameJoin[{scenarios, "golden", name <> ".pgm"}]];
log[name_] := FileNameJoin[{scenarios, name <> ".log"}];

VerificationTest[
  {OccgridMain[{"--noise-free", "--out", out, log["asymmetric"],
      log["outside"], log["no-return-ignore"]}],
    pgm["asymmetric"] === golden["asymmetric.noise-free"],
    pgm["outside"] === golden["outside.noise-free"],
    pgm["no-return-ignore"] === golden["no-return-ignore.noise-free"]},
  {0, True, True, True},
  TestID -> "several scenarios without noise"]
VerificationTest[
  {OccgridMain[{log["outside"], "--seed", "5", "--plain", "--out",
      "/nowhere", "--out", out, "--seed", "000000000000000000000000"}],
    pgm["outside"] === golden["outside.seed-0"]},
  {0, True},
  TestID -> "options in any order, the last counts"]

(* --- Arguments, read from left to right --- *)

optionsOf[arguments__] := readArguments[{arguments}];
VerificationTest[
  {optionsOf["--help"]["text"] === helpText,
    optionsOf["--noise-free", "--plain"]["text"]},
  {True, None},
  TestID -> "help"]
VerificationTest[
  {optionsOf["--out", "-5", "a.log"]["out"],
    optionsOf["--out", "o", "a.log", "b/"]["scenarios"]},
  {"-5", {"a.log", "b/"}},
  TestID -> "a folder whose name begins with a dash"]
VerificationTest[
  {optionsOf["--seed", "4294967295"]["seed"],
    optionsOf["--seed", "00000000000000000007"]["seed"]},
  {4294967295, 7},
  TestID -> "seeds"]
VerificationTest[
  {StringQ[optionsOf["--help", "--bogus"]["text"]],
    StringQ[optionsOf["--noise-free", "--seed", "1", "--version"]["text"]]},
  {True, True},
  TestID -> "help and version hide what comes after them"]
misuse[arguments___] := Catch[readArguments[{arguments}], "usage"];
VerificationTest[
  {misuse["--bogus", "--help"], misuse["-"], misuse["--"], misuse["-5"],
    misuse["-h"], misuse["--seed=7"], misuse["--seed"], misuse["--out", ""],
    misuse["--out", "--noise-free", "a.log"], misuse["--seed", "-1"],
    misuse["--seed", "4294967296"], misuse["--seed", "1.0"],
    misuse["--seed", "x"], misuse["--noise-free", "--seed", "1"],
    misuse["--seed", "1", "--noise-free"], misuse["a.log", "b.log"],
    misuse["--out", "o", "x/a.log", "y/a.txt"],
    misuse["--out", "o", "d/", "e/d"],
    misuse["--out", "o", "--plot", "p.png", "a.log", "b.log"]},
  {"unknown option --bogus", "unknown option -", "unknown option --",
    "unknown option -5", "unknown option -h", "unknown option --seed=7",
    "--seed needs a value", "--out needs a value", "--out needs a value",
    "--seed takes a whole number from 0 to 4294967295, not '-1'",
    "--seed takes a whole number from 0 to 4294967295, not '4294967296'",
    "--seed takes a whole number from 0 to 4294967295, not '1.0'",
    "--seed takes a whole number from 0 to 4294967295, not 'x'",
    "--noise-free and --seed exclude each other",
    "--noise-free and --seed exclude each other",
    "several scenarios need --out", "two scenarios are named a",
    "two scenarios are named d", "--plot draws one scenario"},
  TestID -> "bad usage"]
VerificationTest[
  {OccgridMain[{"--bogus"}], OccgridMain[{"no/such.log"}],
    OccgridMain[{"--out", FileNameJoin[{out, "outside.pgm"}],
      log["one-beam"]}]},
  {2, 1, 1},
  TestID -> "statuses"]
VerificationTest[
  {OccgridMain[{"--out", out, log["one-beam"], "no/such.log"}],
    pgm["one-beam"] === golden["one-beam.seed-0"]},
  {1, True},
  TestID -> "what was written before an error stays"]
DeleteDirectory[out, DeleteContents -> True];

VerificationTest[
  splitArguments[{97, 0, 0, 195, 188, 0, 255, 98, 0, 34, 0}],
  {"a", "", FromCharacterCode[252], FromCharacterCode[{65533, 98}], "\""},
  TestID -> "arguments as wolfram.sh hands them over"]
