(* Writing a map: picture (PGM), its description (YAML), log-odds (SPEC.md
   section 7). *)

BeginPackage["OccupancyGrid`"];

Pixels::usage = "Pixels[grid] gives the grey values, height lists of width: \
0 is occupied, 255 is free.";
MapPgm::usage = "MapPgm[grid] is the map as an ASCII PGM (P2), the row with \
the largest y first.";
MapYaml::usage = "MapYaml[grid, image] is the description that map_server \
and Nav2 read beside the picture.";
MapLogOdds::usage = "MapLogOdds[grid] is the map as text that reads back to \
the same doubles, the row with the smallest y first.";
WriteMap::usage = "WriteMap[folder, name, grid] writes NAME.pgm, NAME.yaml \
and NAME.logodds into a folder, which is made where it is missing. Each file \
is renamed into place when all of them are whole. What cannot be written is \
thrown as the text PATH: cannot be written with the tag \"output\".";

Begin["`Private`"];

(* [snippet: pixel] *)
Pixels[grid_] := Map[
  Floor[((1. - #)*255.) + 0.5] &, ProbabilityGrid[grid]];
(* [/snippet] *)

(* [snippet: map-pgm] *)
MapPgm[grid_] := StringJoin[
  "P2\n",
  ToString[grid["width"]], " ", ToString[grid["height"]], "\n",
  "255\n",
  Map[
    StringRiffle[Map[ToString, #], " "] <> "\n" &,
    Reverse[Pixels[grid]]]];
(* [/snippet] *)

MapYaml[grid_, image_] := StringJoin[
  "image: ", image, "\n",
  "mode: trinary\n",
  "resolution: ", fixed[grid["resolution"]], "\n",
  "origin: [", fixed[grid["originX"]], ", ", fixed[grid["originY"]],
  ", 0.0]\n",
  "negate: 0\n",
  "occupied_thresh: 0.65\n",
  "free_thresh: 0.196\n"];

MapLogOdds[grid_] := StringJoin[
  "# logodds ", ToString[grid["width"]], " ", ToString[grid["height"]], "\n",
  Map[
    StringRiffle[Map[decimalText, #], " "] <> "\n" &,
    LogOdds[grid]]];

(* {m, k}, whole numbers with |x| = m * 2^k *)
wholeAndPower[x_] := If[x == 0, {0, 0},
  With[{parts = exponentAndFraction[{x}]},
    {Floor[First[Last[parts]]*N[2^52]], First[First[parts]] - 52}]];

signText[x_] := If[x < 0, "-", ""];

(* A decimal that reads back to x. InputForm gives the shortest; it is not
   trusted with numbers that it writes with an exponent, which get 17 digits
   of their exact value. *)
decimalText[x_] := Which[
  x == 0, "0.0",
  Abs[x] - 0.001 > 0 && Abs[x] - 100000. < 0,
    With[{text = ToString[x, InputForm]},
      If[StringEndsQ[text, "."], text <> "0", text]],
  True, signText[x] <> seventeenDigits @@ wholeAndPower[x]];

seventeenDigits[m_, k_] := Module[{p, q, power, digits},
  p = m*2^Max[k, 0];
  q = 2^Max[-k, 0];
  (* the lengths tell the number of digits but for one *)
  power = (IntegerLength[p] - IntegerLength[q]) - 16;
  digits = roundHalfEven[p*10^Max[-power, 0], q*10^Max[power, 0]];
  If[IntegerLength[digits] < 17,
    power = power - 1;
    digits = roundHalfEven[p*10^Max[-power, 0], q*10^Max[power, 0]]];
  While[Mod[digits, 10] == 0,
    digits = Quotient[digits, 10];
    power = power + 1];
  ToString[digits] <> "e" <> ToString[power]];

(* The exact value rounded to nine decimals, ties to even, without trailing
   zeros but one. *)
fixed[x_] := Module[{m, k, units, decimals},
  {m, k} = wholeAndPower[x];
  units = roundHalfEven[(m*10^9)*2^Max[k, 0], 2^Max[-k, 0]];
  decimals = StringReplace[
    IntegerString[Mod[units, 10^9], 10, 9],
    RegularExpression["0+$"] -> ""];
  StringJoin[
    If[units == 0, "", signText[x]],
    ToString[Quotient[units, 10^9]], ".",
    If[decimals === "", "0", decimals]]];

WriteMap[folder_, name_, grid_] := Module[{texts, paths, beside, written},
  makeFolder[folder];
  texts = {MapPgm[grid], MapYaml[grid, name <> ".pgm"], MapLogOdds[grid]};
  paths = Map[
    FileNameJoin[{folder, name <> #}] &, {".pgm", ".yaml", ".logodds"}];
  beside = Map[
    FileNameJoin[{folder, StringJoin[
      ".", name, #, ".", ToString[$ProcessID], ".part"]}] &,
    {".pgm", ".yaml", ".logodds"}];
  written = MapThread[writeText, {beside, texts}];
  If[Apply[And, written],
    written = MapThread[renameOver, {beside, paths}]];
  If[!Apply[And, written],
    Scan[If[FileExistsQ[#], Quiet[Check[DeleteFile[#], Null]]] &, beside];
    cannotWrite[paths[[First[First[Position[written, False]]]]]]]];

cannotWrite[path_] := Throw[path <> ": cannot be written", "output"];

(* with its parents, where they are missing *)
makeFolder[folder_] := If[!DirectoryQ[folder],
  Quiet[Check[CreateDirectory[folder], Null]];
  If[!DirectoryQ[folder], cannotWrite[folder]]];

(* whether a text could be written as it is, in UTF-8 and with LF line ends on
   any system *)
writeText[path_, text_] := TrueQ[Quiet[Check[
  Module[{stream = OpenWrite[path, BinaryFormat -> True]},
    WriteString[stream, text];
    Close[stream];
    FileByteCount[path] == utf8Length[text]],
  False]]];

(* a text's bytes; only what is not ASCII is taken apart, since texts are long *)
utf8Length[text_] := With[
  {other = StringDelete[text, RegularExpression["[\\x00-\\x7f]+"]]},
  (StringLength[text] - StringLength[other])
    + Length[ToCharacterCode[other, "UTF-8"]]];

(* whether a text could be written to standard output. Nothing tells of a
   failure there (woxi does not even survive it), and opening /dev/stdout
   begins at the start of a file that others write to as well. So where there
   is cat, cat does it, and its exit status tells. *)
printText[text_] := If[$OperatingSystem === "Windows",
  WriteString["stdout", text];
  True,
  With[{file = CreateFile[]},
    With[{printed = StringQ[file] && writeText[file, text] && Run[
        StringJoin["cat '", StringReplace[file, "'" -> "'\\''"],
          "' 2> /dev/null"]] === 0},
      Quiet[Check[DeleteFile[file], Null]];
      printed]]];

(* RenameFile replaces a file only when told to. Interpreters that do not know
   the option either leave the expression as it is and replace files anyway, or
   refuse: then the old file goes first. *)
renameOver[from_, to_] := Module[{result},
  If[DirectoryQ[to], Return[False, Module]];
  result = Quiet[Check[
    RenameFile[from, to, OverwriteTarget -> True], $Failed]];
  If[Head[result] === RenameFile,
    result = Quiet[Check[RenameFile[from, to], $Failed]]];
  If[!StringQ[result],
    result = Quiet[Check[
      If[FileExistsQ[to], DeleteFile[to]];
      RenameFile[from, to], $Failed]]];
  StringQ[result]];

End[];
EndPackage[];
