(* The shared vectors, scenarios/vectors/FUNCTION.csv: arguments and results of
   the contract's functions, the same for every port. *)

vectorFolder = FileNameJoin[{here, "..", "..", "scenarios", "vectors"}];

(* how many arguments the lines of a function begin with *)
vectorArguments = <|
  "sin" -> 1, "cos" -> 1, "exp" -> 1, "log" -> 1, "logit" -> 1,
  "sigmoid" -> 1, "pixel" -> 1, "world_to_grid" -> 5, "update_cell" -> 6,
  "bresenham" -> 4, "clip_ray" -> 6, "flaser_angles" -> 2,
  "read_ranges" -> 3, "beam_endpoints" -> 5, "philox" -> 6,
  "normal_deviate" -> 3|>;

(* {line, answer, expected} where the two differ *)
wrongLines[function_] := Module[{rows, given, expected},
  rows = Map[StringSplit[#, ","] &, Rest[ReadList[
    FileNameJoin[{vectorFolder, function <> ".csv"}], String]]];
  given = Map[Take[#, vectorArguments[function]] &, rows];
  expected = Map[line[Drop[#, vectorArguments[function]]] &, rows];
  Select[
    Transpose[{Range[Length[rows]] + 1, answers[function, given], expected}],
    #[[2]] =!= #[[3]] &]];

VerificationTest[
  Sort[Map[FileBaseName, FileNames["*.csv", {vectorFolder}]]],
  Sort[Keys[vectorArguments]],
  TestID -> "every file of vectors is read"]
VerificationTest[wrongLines["sin"], {}, TestID -> "vectors of sin"]
VerificationTest[wrongLines["cos"], {}, TestID -> "vectors of cos"]
VerificationTest[wrongLines["exp"], {}, TestID -> "vectors of exp"]
VerificationTest[wrongLines["log"], {}, TestID -> "vectors of log"]
VerificationTest[wrongLines["logit"], {}, TestID -> "vectors of Logit"]
VerificationTest[wrongLines["sigmoid"], {}, TestID -> "vectors of Sigmoid"]
VerificationTest[wrongLines["pixel"], {}, TestID -> "vectors of Pixel"]
VerificationTest[
  wrongLines["world_to_grid"], {}, TestID -> "vectors of WorldToGrid"]
VerificationTest[
  wrongLines["update_cell"], {}, TestID -> "vectors of UpdateCell"]
VerificationTest[
  wrongLines["bresenham"], {}, TestID -> "vectors of Bresenham"]
VerificationTest[wrongLines["clip_ray"], {}, TestID -> "vectors of ClipRay"]
VerificationTest[
  wrongLines["flaser_angles"], {}, TestID -> "vectors of FlaserAngles"]
VerificationTest[
  wrongLines["read_ranges"], {}, TestID -> "vectors of ReadRanges"]
VerificationTest[
  wrongLines["beam_endpoints"], {}, TestID -> "vectors of BeamEndpoints"]
VerificationTest[
  wrongLines["philox"], {}, TestID -> "vectors of Philox4x32"]
VerificationTest[
  wrongLines["normal_deviate"], {}, TestID -> "vectors of NormalDeviate"]
