(* Files, written whole or not at all, and standard output (SPEC.md section
   7). *)

Begin["OccupancyGrid`Private`"];

WriteMap[folder_String, name_String, grid_?gridValueQ] := Module[
  {directory, paths, temporary, written},
  directory = StringReplace[folder, RegularExpression["/+$"] -> ""];
  makeFolder[If[directory === "", "/", directory]];
  removeLeftovers[directory];
  paths = Map[
    StringJoin[directory, "/", name, #] &, {".pgm", ".yaml", ".logodds"}];
  Scan[If[DirectoryQ[plainPath[#]], cannotWrite[#]] &, paths];
  temporary = Map[
    StringJoin[plainPath[directory <> "/"], ".occgrid-", runName[], "-",
      ToString[#], ".part"] &,
    {1, 2, 3}];
  written = MapThread[writeFile, {temporary, {
    MapPgm[grid, #] &,
    #[MapYaml[grid, name <> ".pgm"]] &,
    MapLogOdds[grid, #] &}}];
  If[Apply[And, written],
    written = renameAll[temporary, Map[plainPath, paths]]];
  If[!Apply[And, written],
    Scan[removeFile, temporary];
    cannotWrite[First[Pick[paths, written, False]]]]];
WriteMap[___] := wrongArguments[WriteMap];

cannotWrite[path_] := Throw[
  oneLine[path] <> ": cannot be written", "output"];

(* with its parents, where they are missing *)
makeFolder[directory_] := With[{path = plainPath[directory]},
  If[!DirectoryQ[path],
    Quiet[Check[CreateDirectory[path], Null]];
    If[!DirectoryQ[path], cannotWrite[directory]]]];

removeFile[path_] := If[FileExistsQ[path],
  Quiet[Check[DeleteFile[path], Null]]];

(* --- Temporary files --- *)

(* What wolfram.sh calls the run, so that it can remove its files when a
   signal ends it; else the number of the process. *)
runFolder[] := Environment["OCCGRID_FOLDER"];
runName[] := If[StringQ[runFolder[]],
  Last[StringSplit[runFolder[], "occgrid-"]],
  ToString[$ProcessID]];

(* what runs left that were killed more than 24 hours ago *)
removeLeftovers[directory_] := Scan[
  If[leftoverQ[Last[StringSplit[#, "/"]]] && oldFileQ[#], removeFile[#]] &,
  FileNames[".occgrid-*.part", {plainPath[directory <> "/"]}]];

leftoverQ[name_] := StringMatchQ[name,
  RegularExpression["\\.occgrid-[A-Za-z0-9-]{0,40}\\.part"]];

(* woxi has no FileDate and leaves it as it is *)
oldFileQ[path_] := With[{date = FileDate[path]},
  If[Head[date] === DateObject,
    (AbsoluteTime[] - AbsoluteTime[date]) - 86400 > 0,
    Run[StringJoin["test -n \"$(find ", shellQuoted[path],
      " -maxdepth 0 -type f -mmin +1440)\" 2> /dev/null"]] === 0]];

shellQuoted[text_] := "'" <> StringReplace[text, "'" -> "'\\''"] <> "'";

(* --- Writing --- *)

(* Whether a text could be written as it is, in UTF-8 and with LF line ends on
   any system. produce is called with the function that writes a piece. *)
writeFile[path_, produce_] := TrueQ[Quiet[Check[
  Module[{stream = OpenWrite[path, BinaryFormat -> True], bytes = 0},
    If[Head[stream] =!= OutputStream, Return[False, Module]];
    produce[Function[text,
      WriteString[stream, text];
      bytes = bytes + utf8Length[text]]];
    Close[stream];
    FileByteCount[path] == bytes],
  False]]];

(* a text's bytes; only what is not ASCII is taken apart, since texts are long *)
utf8Length[text_] := With[
  {other = StringDelete[text, RegularExpression["[\\x00-\\x7f]+"]]},
  (StringLength[text] - StringLength[other])
    + Length[ToCharacterCode[other, "UTF-8"]]];

(* Whether a text could be written to standard output. Nothing tells of a
   failure there (woxi does not even survive it), and opening /dev/stdout
   begins at the start of a file that others write to as well. So where there
   is cat, cat does it, and its exit status tells. *)
printText[produce_] := If[$OperatingSystem === "Windows",
  produce[WriteString["stdout", #] &];
  True,
  With[{file = If[StringQ[runFolder[]],
      FileNameJoin[{runFolder[], "output"}],
      CreateFile[]]},
    With[{printed = StringQ[file] && writeFile[file, produce] &&
        Run["cat " <> shellQuoted[file] <> " 2> /dev/null"] === 0},
      removeFile[file];
      printed]]];

(* --- Renaming --- *)

(* all of them, or none: which could be renamed *)
renameAll[from_, to_] := Module[{done = MapThread[renameOver, {from, to}]},
  If[!Apply[And, done], Scan[removeFile, Pick[to, done]]];
  done];

(* RenameFile replaces a file only when told to. Interpreters that do not know
   the option either leave the expression as it is and replace files anyway, or
   refuse: then the old file goes first. *)
renameOver[from_, to_] := Module[{result},
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
