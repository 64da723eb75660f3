(* The command line (SPEC.md section 6). *)

BeginPackage["OccupancyGrid`"];

OccgridMain::usage = "OccgridMain[arguments] runs the command and gives its \
exit status.";
$OccgridVersion::usage = "$OccgridVersion is the version of the port.";

Begin["`Private`"];

$OccgridVersion = "1.0.0";

usageText = "usage: occgrid [--noise-free | --seed N] [--out DIR] \
[--plot FILE] [SCENARIO...]\n";

helpText = usageText <> "
Map range scans into an occupancy grid. Without a scenario: the built-in
lesson.

  SCENARIO      scenario files (CARMEN logs)
  --noise-free  simulate ranges without noise
  --seed N      seed of the noise, 0 to 4294967295 (default: 0)
  --out DIR     write NAME.pgm, NAME.yaml, NAME.logodds there
  --plot FILE   draw the map with axes; the ending says the format
  --version     the version
  --help        this text
";

OccgridMain[arguments_List] := Catch[
  Catch[
    Catch[run[arguments], "usage", usageError],
    "scenario", runError],
  "output", runError];

usageError[reason_, _] := (
  WriteString["stderr", usageText <> "occgrid: error: " <> reason <> "\n"];
  2);

runError[message_, _] := (
  WriteString["stderr", message <> "\n"];
  1);

run[arguments_] := Module[{options},
  options = readOptions[arguments];
  Which[
    options["help"],
      WriteString["stdout", helpText],
    options["version"],
      WriteString["stdout", StringJoin["occgrid ", $OccgridVersion, " (",
        $Version, ")\n"]],
    options["scenarios"] === {},
      mapOne[LessonScenario[], options],
    True,
      Scan[mapOne[ReadScenario[#], options] &, options["scenarios"]]];
  0];

(* Map one scenario and write what was asked for. *)
mapOne[scenario_, options_] := Module[{grid},
  grid = MapScenario[scenario, options["seed"]];
  If[options["out"] === None,
    If[!printText[MapPgm[grid]], cannotWrite["standard output"]],
    WriteMap[options["out"], scenario["name"], grid]];
  If[options["plot"] =!= None,
    If[Quiet[Check[Export[options["plot"], DrawMap[grid]], $Failed]]
        === $Failed,
      cannotWrite[options["plot"]]]]];

(* --- Options --- *)

wrongUse[reason_] := Throw[reason, "usage"];

readOptions[arguments_] := Module[
  {options, rest = arguments, first, names, seeds = 0, noiseFree = False},
  options = <|"help" -> False, "version" -> False, "seed" -> 0,
    "out" -> None, "plot" -> None, "scenarios" -> {}|>;
  While[rest =!= {},
    first = First[rest];
    rest = Rest[rest];
    Which[
      first === "--help" || first === "-h",
        options["help"] = True; Break[],
      first === "--version",
        options["version"] = True; Break[],
      first === "--noise-free",
        noiseFree = True,
      MemberQ[{"--seed", "--out", "--plot"}, first],
        If[rest === {} || StringStartsQ[First[rest], "-"],
          wrongUse[first <> " takes a value"]];
        If[first === "--seed",
          seeds = seeds + 1;
          options["seed"] = readSeed[First[rest]],
          options[StringDrop[first, 2]] = First[rest]];
        rest = Rest[rest],
      StringStartsQ[first, "-"],
        wrongUse["unknown option " <> first],
      True,
        options["scenarios"] = Append[options["scenarios"], first]]];
  If[options["help"] || options["version"], Return[options, Module]];
  If[noiseFree,
    If[seeds > 0, wrongUse["--noise-free and --seed exclude each other"]];
    options["seed"] = None];
  names = Map[ScenarioName, options["scenarios"]];
  If[Length[names] > 1,
    If[options["out"] === None, wrongUse["several scenarios need --out"]];
    If[options["plot"] =!= None, wrongUse["--plot draws one scenario"]]];
  If[!DuplicateFreeQ[names],
    wrongUse["two scenarios have the same name"]];
  options];

readSeed[text_] := If[
  StringMatchQ[text, wholeForm] && FromDigits[text] < 2^32,
  FromDigits[text],
  wrongUse["a seed is a whole number from 0 to 4294967295, not '"
    <> text <> "'"]];

End[];
EndPackage[];
