(* Every name of the package is read into the context that is meant. *)

packageText[name_] := ReadString[
  FileNameJoin[{here, "..", "OccupancyGrid", name <> ".wl"}]];
moduleFiles = Map[FileBaseName, FileNames["*.wl",
  {FileNameJoin[{here, "..", "OccupancyGrid"}]}]];
loader = ReadString[FileNameJoin[{here, "..", "OccupancyGrid.wl"}]];
usage = packageText["Usage"];
moduleTexts = Map[packageText, DeleteCases[moduleFiles, "Usage"]];

VerificationTest[
  ContextComplaints[usage, moduleTexts], {},
  TestID -> "no name is read into the wrong context"]

(* the modules are read after Usage.wl, and each of them *)
moduleOrder = Select[
  Map[StringTake[#, {2, -2}] &, Select[
    Map[First, codeTokens[loader]], StringMatchQ[#, "\"*\""] &]],
  MemberQ[moduleFiles, #] &];
VerificationTest[
  {First[moduleOrder], Sort[moduleOrder] === Sort[moduleFiles]},
  {"Usage", True},
  TestID -> "the loader reads Usage.wl first, and every module"]
(* the loader's own names, before Usage.wl is read *)
loaderComplaints[text_] := With[
  {parts = StringSplit[text, "Begin[\"OccupancyGrid`Private`\"];"]},
  Complement[
    Select[usedNames[Map[First, codeTokens[Last[parts]]]], capitalQ],
    usedNames[Map[First, codeTokens[First[parts]]]],
    languageNames]];
VerificationTest[
  {loaderComplaints[loader],
    loaderComplaints[StringReplace[loader, "\n$OccupancyGridFolder;" -> ""]]},
  {{}, {"$OccupancyGridFolder"}},
  TestID -> "the loader declares its names"]
VerificationTest[
  Select[moduleFiles, !StringContainsQ[packageText[#],
    If[# === "Usage", "\nBegin[\"OccupancyGrid`\"];\n",
      "\nBegin[\"OccupancyGrid`Private`\"];\n"]] &],
  {},
  TestID -> "each module begins its context"]
VerificationTest[
  Select[moduleFiles, # =!= "Usage"
    && StringContainsQ[packageText[#], "::usage"] &],
  {},
  TestID -> "usage stands in Usage.wl only"]

(* what the check refuses *)
complaintsAbout[code_] := Map[First,
  ContextComplaints["F::usage = \"text\"; G::usage = \"text\";", {code}]];
VerificationTest[
  complaintsAbout["F[x_] := Clmap[x]; G[x_] := F[x];"], {"Clmap"},
  TestID -> "refuses a name that is not declared"]
VerificationTest[
  complaintsAbout["F[x_] := x;"], {"G"},
  TestID -> "refuses a declared name without a definition"]
VerificationTest[
  complaintsAbout["F[x_] := Module[{y = x}, y + z]; G[x_] := helpr[x];
    helper[x_] := x;"],
  {"helpr", "z"},
  TestID -> "refuses names that nobody defines"]
VerificationTest[
  complaintsAbout["F[x_?testQ] /; testQ[x] := Do[Function[a, a + i], {i, x}];
    testQ[_] := True; {G, b} = {1, 2}; c = b + c; With[{d = 1},
    e[n_] := (d*n) + e[n - 1]];"],
  {},
  TestID -> "lets variables, iterators, patterns and definitions pass"]
VerificationTest[
  Union[Map[First, ContextComplaints[
    StringReplace[usage, "WorldToGrid::usage" -> "WorldToGird::usage"],
    moduleTexts]]],
  {"WorldToGird", "WorldToGrid"},
  TestID -> "a usage that is taken out of Usage.wl is missed"]
