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
  {OccgridMain[{log["asymmetric"], "--seed", "5", "--out", "/nowhere",
      "--out", out, "--seed", "0"}],
    pgm["asymmetric"] === golden["asymmetric.seed-0"]},
  {0, True},
  TestID -> "options in any order, the last counts"]
VerificationTest[
  Map[OccgridMain, {{"--version"}, {"--help"}}], {0, 0},
  TestID -> "version and help"]
VerificationTest[
  Map[OccgridMain, {
    {"--bogus"}, {"--seed"}, {"--seed", "-1"}, {"--seed", "4294967296"},
    {"--seed", "1.0"}, {"--seed", "x"}, {"--out"},
    {"--noise-free", "--seed", "1"}, {"--seed", "1", "--noise-free"},
    {"a.log", "b.log"}, {"--out", out, "x/a.log", "y/a.txt"}}],
  ConstantArray[2, 11],
  TestID -> "bad usage"]
VerificationTest[
  {OccgridMain[{"--out", out, log["one-beam"], "no/such.log"}],
    pgm["one-beam"] === golden["one-beam.seed-0"],
    OccgridMain[{"--out", FileNameJoin[{out, "one-beam.pgm"}],
      log["one-beam"]}]},
  {1, True, 1},
  TestID -> "errors, and what was written before them"]
DeleteDirectory[out, DeleteContents -> True];
