(* Finds in the package what a kernel with contexts would read wrongly. A name
   belongs to the context in which it is read first: a public name that
   Usage.wl does not declare would become one of the private context, and so
   would a misspelt name of the language.

   ContextComplaints[usage, sources] lists {name, complaint}, for the text of
   Usage.wl and those of the modules:

   - a capital name that is neither declared nor of the language;
   - a declared name that no module defines, nor uses as a head of data;
   - any other name that no module defines, and that is no variable, pattern
     or iterator where it stands. *)

(* names of the language that the package uses *)
languageNames = Union[StringSplit["
  $CharacterEncoding $Failed $InputFileName $OperatingSystem $ProcessID
  $ScriptCommandLine $Version
  Abs AbsoluteTime And Append Apply ArrayPlot Association AssociationQ Automatic
  Begin BinaryFormat BinaryReadList BitXor Block Break
  Catch Characters Check Clear Close ColorFunction ColorFunctionScaling
  Complement ConstantArray Count CreateDirectory CreateFile
  DataRange DataReversed DateObject DeleteCases DeleteFile DirectoryQ Directory
  DirectoryName Divide Do
  End EndPackage Environment EvenQ Exit Export
  False FileByteCount FileDate FileExistsQ FileNameJoin FileNames First Flatten
  Floor Fold Frame FrameLabel FrameTicks FromCharacterCode FromDigits Function
  General Get Graphics GrayLevel
  Head HoldFirst
  If ImageSize Indeterminate Infinity Integer IntegerDigits IntegerLength
  IntegerQ IntegerString
  Join KeyExistsQ Last Length List ListQ Lookup
  MantissaExponent Map MapIndexed MapThread MatchQ Max MemberQ Message Min Mod
  Module Most
  N NestList None Null NumberQ NumericQ
  OpenWrite Outer OutputStream OverwriteTarget
  Part Partition Pick PlotLabel Position Prepend
  Quiet Quotient
  Range Raster Reap RegularExpression RenameFile Rest Return Reverse Run
  Scan Select SetAttributes Sow Sqrt StartOfString StringContainsQ
  StringDelete StringDrop StringEndsQ StringJoin StringLength StringMatchQ
  StringPosition StringQ StringReplace StringRiffle StringSplit StringStartsQ
  StringTake Sum Switch Symbol String
  Table Take TakeWhile Throw ToCharacterCode ToLowerCase ToString ToUpperCase
  Transpose True TrueQ
  UnitStep Union ValueQ VectorQ Which While With WriteString
  InputForm"]];

(* heads and symbols that stand for themselves *)
dataNames = {"Pose", "Segment", "RangeScan", "NegativeZero",
  "$OccupancyGridFolder"};

capitalQ[name_] := StringMatchQ[name, RegularExpression["[$]?[A-Z].*"]];

(* the names that a text declares by name::usage *)
declaredNames[text_] := Module[{tokens = Map[First, codeTokens[text]]},
  Union[Table[
    If[tokens[[i]] === "usage" && i > 3 && tokens[[i - 1]] === ":",
      tokens[[i - 3]],
      Nothing],
    {i, Length[tokens]}]]];

(* The names of a text by their part in it: {defined, {name, bound there}}. *)
statementsOf[text_] := Module[
  {tokens = Map[First, codeTokens[text]], depth = 0, statement = {}, all = {}},
  Scan[
    Function[token,
      statement = Append[statement, token];
      If[openQ[token], depth = depth + 1];
      If[closeQ[token], depth = depth - 1];
      If[token === ";" && depth == 0,
        all = Append[all, statement];
        statement = {}]],
    tokens];
  Append[all, statement]];

(* position of the bracket that belongs to the closing one at i *)
openOf[tokens_, i_] := Module[{depth = 0, k = i},
  While[k > 0,
    If[closeQ[tokens[[k]]], depth = depth + 1];
    If[openQ[tokens[[k]]], depth = depth - 1];
    If[depth == 0, Break[]];
    k = k - 1];
  k];

(* what the left side that ends at position i defines *)
definedAt[tokens_, i_] := Module[{token, open},
  If[i < 1, Return[{}, Module]];
  token = tokens[[i]];
  Which[
    token === "]",
      open = openOf[tokens, i];
      Which[
        open < 2, {},
        (* f[x_] /; condition[x] := ... *)
        open > 2 && tokens[[open - 2]] === "/;",
          definedAt[tokens, open - 3],
        True, definedAt[tokens, open - 1]],
    token === "}",
      open = openOf[tokens, i];
      Select[Take[tokens, {open, i}], nameQ],
    nameQ[token] && i > 1 && tokens[[i - 1]] === "/;",
      definedAt[tokens, i - 2],
    nameQ[token], {token},
    True, {}]];

definedNames[tokens_] := Union[Flatten[Table[
  If[tokens[[i]] === ":=" || tokens[[i]] === "=",
    definedAt[tokens, i - 1],
    {}],
  {i, Length[tokens]}]]];

(* variables of Module, With, Block and Function, iterators, patterns *)
boundNames[tokens_] := Module[
  {heads = {}, bound = {}, head, token, previous},
  Do[
    token = tokens[[i]];
    previous = If[i > 1, tokens[[i - 1]], ""];
    head = If[heads === {}, "", Last[heads]];
    Which[
      openQ[token],
        heads = Append[heads, Which[
          token === "[", If[nameQ[previous], previous, ""],
          token === "{" && MemberQ[{"Module", "With", "Block"}, head]
            && previous === "[", "variables",
          token === "{" && head === "Function" && previous === "[",
            "variables",
          token === "{" && MemberQ[{"Do", "Table", "Sum"}, head], "iterator",
          True, ""]],
      closeQ[token], heads = Most[heads],
      nameQ[token],
        If[head === "variables" && (previous === "{" || previous === ",")
            || head === "iterator" && previous === "{"
            || head === "Function" && previous === "["
            || i < Length[tokens] && StringMatchQ[tokens[[i + 1]],
              RegularExpression["_+"]],
          bound = Append[bound, token]]],
    {i, Length[tokens]}];
  Union[bound]];

usedNames[tokens_] := Union[Table[
  If[nameQ[tokens[[i]]] && !(i > 2 && tokens[[i - 1]] === ":"
      && tokens[[i - 2]] === ":"),
    tokens[[i]],
    Nothing],
  {i, Length[tokens]}]];

ContextComplaints[usage_, sources_] := Module[
  {declared, statements, defined, used},
  declared = declaredNames[usage];
  statements = Flatten[Map[statementsOf, sources], 1];
  defined = Union[Flatten[Map[definedNames, statements]]];
  (* names that are not bound where they stand *)
  used = Union[Flatten[Map[
    Complement[usedNames[#], boundNames[#]] &, statements]]];
  Join[
    Map[{#, "is declared, and nobody defines it"} &,
      Complement[declared, defined, dataNames]],
    Map[{#, "is neither declared nor of the language"} &,
      Complement[Select[used, capitalQ], declared, languageNames]],
    Map[{#, "is nobody's name"} &,
      Complement[Select[used, !capitalQ[#] &], defined]]]];
