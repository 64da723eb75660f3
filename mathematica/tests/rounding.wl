(* Finds in Wolfram source what may round otherwise on the Wolfram kernel than
   the contract asks for.

   Complaints[text] lists {line, complaint}: quotients (x/y is x*y^-1 and
   rounds twice), sums of three terms and products of three factors (Plus and
   Times may put them in another order), products without a sign, powers of
   anything but a whole number, exact rationals in scientific notation
   (1*^-5), numbers of more than 17 digits (which are of arbitrary precision),
   Divide within Map, Table, Array or Scan (the code that the kernel makes of
   these over a long list may multiply by reciprocals), and the platform's own
   functions.

   ComparisonComplaints[text] lists comparisons whose right side is no whole
   number: machine numbers are compared with forgiveness, so that a difference
   has to be compared with 0. *)

tokenForm = RegularExpression[StringJoin[
  "\"(\\\\.|[^\"\\\\])*\"",
  "|\\(\\*|\\*\\)",
  "|[0-9]+\\^\\^[0-9A-Za-z]+",
  "|([0-9]+\\.?[0-9]*|\\.[0-9]+)(`[0-9.]*)?(\\*\\^-?[0-9]+)?",
  "|[A-Za-z$][A-Za-z0-9$`]*",
  "|#+[0-9]*|_+",
  "|//@|/@|/;|/:|//\\.|/\\.|//|/=",
  "|===|=!=|==|!=|:=|:>|->|<=|>=|<>|<\\||\\|>",
  "|&&|\\|\\||@@@|@@|;;|~~|\\.\\.|\\+\\+|--|\\+=|-=|\\*=",
  "|\n|[^ \t\r\n]"]];

forbidden = {"Sin", "Cos", "Tan", "Exp", "Log", "Log2", "Log10", "Sinh",
  "Cosh", "ArcTan", "ArcSin", "ArcCos", "Pi", "E", "Degree", "Round",
  "Rationalize", "Total", "Mean", "Dot", "Norm", "Clip", "Chop", "Rescale",
  "Subdivide", "Accumulate", "Plus", "Times", "Power", "LogisticSigmoid"};

(* {token, line} without comments, which nest *)
codeTokens[text_] := Module[{line = 1, depth = 0, kept},
  kept = Map[
    Function[token, Module[{place = line},
      line = line + StringCount[token, "\n"];
      Which[
        token === "(*", depth = depth + 1; Nothing,
        token === "*)", depth = depth - 1; Nothing,
        depth > 0 || token === "\n", Nothing,
        True, {token, place}]]],
    StringCases[text, tokenForm]];
  kept];

wholeQ[token_] := StringMatchQ[token,
  RegularExpression["[0-9]+|[0-9]+\\^\\^[0-9A-Za-z]+"]];
numberQ[token_] := StringMatchQ[token, RegularExpression["\\.?[0-9].*"]];
nameQ[token_] := StringMatchQ[token, RegularExpression["[A-Za-z$].*"]];
operandQ[token_] := numberQ[token] || nameQ[token] ||
  StringMatchQ[token, RegularExpression["(?s)#.*|\".*"]];
openQ[token_] := MemberQ[{"(", "[", "{", "<|"}, token];
closeQ[token_] := MemberQ[{")", "]", "}", "|>"}, token];

mapping = {"Map", "Table", "Array", "Scan"};

(* A level of brackets is {terms, factors, whether it is within a mapping}.
   Signs that bind less than + begin a new sum; so does every bracket. *)
Complaints[text_] := Module[
  {tokens = codeTokens[text], levels = {}, terms = 0, factors = 0,
    mapped = False, ended = False, previous = "", found = {}, say},
  say[place_, what_] := (found = Append[found, {place, what}]);
  Do[
    With[{token = First[item], place = Last[item]},
      Which[
        openQ[token],
          If[ended && token =!= "[",
            say[place, "a product without a sign"]];
          levels = Append[levels, {terms, factors, mapped}];
          mapped = mapped || token === "[" && MemberQ[mapping, previous];
          terms = 0;
          factors = 0;
          ended = False,
        closeQ[token],
          {terms, factors, mapped} = Last[levels];
          levels = Most[levels];
          ended = True,
        StringMatchQ[token, RegularExpression["_+"]],
          (* a pattern: x_, x_List, _List *)
          ended = True,
        operandQ[token],
          If[ended && !StringMatchQ[previous, RegularExpression["_+"]],
            say[place, "a product without a sign"]];
          If[MemberQ[forbidden, token] && !StringMatchQ[previous, "_"],
            say[place, "the platform's " <> token]];
          If[mapped && token === "Divide",
            say[place, "a division mapped over a list"]];
          If[StringMatchQ[token, RegularExpression["[0-9]+\\*\\^-.*"]],
            say[place, "an exact rational"]];
          If[numberQ[token] && StringLength[First[StringSplit[
              StringReplace[token, {"." -> "", RegularExpression["^0*\\.?0*"]
                -> ""}] <> "*", "*"], ""]] > 17
              && !StringContainsQ[token, "^^"],
            say[place, "more than 17 digits"]];
          ended = True,
        token === "+" || token === "-",
          If[ended,
            terms = terms + 1;
            factors = 0;
            If[terms > 1, say[place, "a sum of three terms"]]];
          ended = False,
        token === "*",
          factors = factors + 1;
          If[factors > 1, say[place, "a product of three factors"]];
          ended = False,
        token === "/" || token === "/=",
          say[place, "a quotient"];
          ended = False,
        token === "^",
          If[!wholeQ[previous], say[place, "a power"]];
          ended = False,
        token === "&" || token === "++" || token === "--" || token === "..",
          ended = True;
          If[token === "&", terms = 0; factors = 0],
        token === "@" || token === "!" || token === "?" || token === ".",
          ended = False,
        True,
          terms = 0;
          factors = 0;
          ended = False];
      previous = token],
    {item, tokens}];
  found];

ComparisonComplaints[text_] := Module[{tokens = codeTokens[text], next},
  next[i_] := If[i <= Length[tokens], tokens[[i, 1]], ";"];
  Table[
    If[MemberQ[{"<", ">", "<=", ">=", "==", "!="}, tokens[[i, 1]]]
        && !comparedWithWholeQ[next[i + 1], next[i + 2], next[i + 3],
          next[i + 4]],
      {tokens[[i, 2]], "a comparison of machine numbers"},
      Nothing],
    {i, Length[tokens]}]];

endQ[token_] := closeQ[token] ||
  MemberQ[{",", ";", "&&", "||", "&", ":="}, token];
comparedWithWholeQ[a_, b_, c_, d_] := wholeQ[a] && (
  endQ[b] || (b === "^" && wholeQ[c] && endQ[d]));
