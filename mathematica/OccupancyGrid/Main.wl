(* The command line (SPEC.md section 6). *)

Begin["OccupancyGrid`Private`"];

$OccgridVersion = "1.0.0";

usageText = "usage: occgrid [--noise-free | --seed N] [--plain] [--out DIR] \
[--plot FILE] [SCENARIO...]\n";

helpText = usageText <> "
Maps range scans into an occupancy grid.

  SCENARIO      scenario files (CARMEN logs); without any: the built-in lesson
  --noise-free  simulate ranges without noise
  --seed N      the seed of the noise, 0 to 4294967295 (default: 0)
  --plain       map beam by beam, with the program as the handouts print it
  --out DIR     write NAME.pgm, NAME.yaml and NAME.logodds into DIR;
                without it: the PGM on standard output
  --plot FILE   draw the map, with axes in metres; the ending says the format
  --version     print the version
  --help        print this
";

OccgridMain[arguments_List] /; VectorQ[arguments, StringQ] := Catch[
  Catch[
    Catch[run[readArguments[arguments]], "usage", usageError],
    "scenario", runError],
  "output", runError];
OccgridMain[___] := wrongArguments[OccgridMain];

usageError[reason_, _] := (
  WriteString["stderr", "occgrid: " <> oneLine[reason] <> "\n" <> usageText];
  2);

runError[message_, _] := (
  WriteString["stderr", message <> "\n"];
  1);

(* --- Arguments --- *)

(* wolfram.sh puts the arguments into a file, each with a byte 0 at its end:
   wolframscript may take options for its own, and woxi reads what
   $ScriptCommandLine holds as source text and runs it. *)
ScriptArguments[] := With[{folder = Environment["OCCGRID_FOLDER"]},
  If[StringQ[folder],
    splitArguments[
      BinaryReadList[FileNameJoin[{folder, "arguments"}]]],
    Rest[$ScriptCommandLine]]];

splitArguments[bytes_] := With[
  {ends = Flatten[Position[bytes, 0]]},
  MapThread[
    argumentText[Take[bytes, {#1 + 1, #2 - 1}]] &,
    {Most[Prepend[ends, 0]], ends}]];

(* An argument that is not UTF-8 names no file here: the bytes that make no
   character become U+FFFD, which no path has. *)
argumentText[bytes_] := With[
  {text = Quiet[FromCharacterCode[bytes, "UTF-8"]]},
  If[ToCharacterCode[text, "UTF-8"] === bytes,
    text,
    FromCharacterCode[Map[If[# < 128, #, 65533] &, bytes]]]];

wrongUse[reason_] := Throw[reason, "usage"];

readArguments[arguments_] := Module[
  {options, scenarios = {}, rest = arguments, argument, value},
  options = <|"noiseFree" -> False, "seed" -> None, "plain" -> False,
    "out" -> None, "plot" -> None, "text" -> None|>;
  value[] := If[
    rest === {} || First[rest] === "" || StringStartsQ[First[rest], "--"],
    wrongUse[argument <> " needs a value"],
    With[{text = First[rest]},
      rest = Rest[rest];
      text]];
  While[rest =!= {} && options["text"] === None,
    argument = First[rest];
    rest = Rest[rest];
    Which[
      argument === "--noise-free", options["noiseFree"] = True,
      argument === "--seed", options["seed"] = readSeed[value[]],
      argument === "--plain", options["plain"] = True,
      argument === "--out", options["out"] = value[],
      argument === "--plot", options["plot"] = value[],
      argument === "--help", options["text"] = helpText,
      argument === "--version", options["text"] = versionText[],
      StringStartsQ[argument, "-"], wrongUse["unknown option " <> argument],
      True, scenarios = Append[scenarios, argument]]];
  options["scenarios"] = scenarios;
  If[options["text"] === None, checkTogether[options]];
  options];

(* what no argument alone can show *)
checkTogether[options_] := Module[{scenarios, names},
  scenarios = options["scenarios"];
  names = Map[ScenarioName, scenarios];
  If[options["noiseFree"] && options["seed"] =!= None,
    wrongUse["--noise-free and --seed exclude each other"]];
  If[Length[scenarios] > 1 && options["out"] === None,
    wrongUse["several scenarios need --out"]];
  Scan[
    If[Count[names, #] > 1, wrongUse["two scenarios are named " <> #]] &,
    names];
  If[Length[scenarios] > 1 && options["plot"] =!= None,
    wrongUse["--plot draws one scenario"]]];

readSeed[text_] := If[
  StringMatchQ[text, wholeForm] && FromDigits[text] < 2^32,
  FromDigits[text],
  wrongUse["--seed takes a whole number from 0 to 4294967295, not '"
    <> text <> "'"]];

versionText[] := StringJoin[
  "occgrid ", $OccgridVersion, " (", $Version, ")\n"];

(* --- Work --- *)

run[options_] := (
  Which[
    options["text"] =!= None,
      printOut[Function[write, write[options["text"]]]],
    options["scenarios"] === {},
      mapOne[LessonScenario[], options],
    True,
      Scan[mapOne[ReadScenario[#], options] &, options["scenarios"]]];
  0);

printOut[produce_] := If[!printText[produce],
  cannotWrite["standard output"]];

(* Map one scenario and write what was asked for. *)
mapOne[scenario_, options_] := Module[{seed, grid},
  seed = Which[
    options["noiseFree"], None,
    options["seed"] === None, 0,
    True, options["seed"]];
  grid = If[options["plain"],
    MapScenario[scenario, seed],
    MapScenarioFast[scenario, seed,
      showProgress[scenario["name"], #, Length[scenario["scans"]]] &]];
  If[options["out"] === None,
    printOut[MapPgm[grid, #] &],
    WriteMap[options["out"], scenario["name"], grid]];
  If[options["plot"] =!= None, plotMap[options["plot"], grid]]];

(* On standard error, how long a long log still takes: a line after ten
   seconds, and then each minute. *)
showProgress[name_, 0, scans_] := (
  mappingStarted = AbsoluteTime[];
  nextProgress = 10);
showProgress[name_, done_, scans_] := With[
  {seconds = AbsoluteTime[] - mappingStarted},
  If[done < scans && seconds - nextProgress >= 0,
    WriteString["stderr", StringJoin[
      oneLine[name], ": ", ToString[Quotient[100*done, scans]],
      " % mapped, about ",
      ToString[Floor[Divide[seconds*(scans - done), done]]], " s to go\n"]];
    nextProgress = seconds + 60]];

plotMap[file_, grid_] := If[
  Quiet[Check[Export[plainPath[file], DrawMap[grid]], $Failed]] === $Failed,
  cannotWrite[file]];

End[];
