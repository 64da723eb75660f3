(* What a function does with arguments that it does not take: a message, and
   $Failed in place of a result that is half evaluated. *)

Begin["OccupancyGrid`Private`"];

wrongArguments[function_] := (
  Message[OccupancyGrid::args, function];
  $Failed);

(* numbers that can be computed with: neither symbols nor infinities *)
numbersQ[x_] := NumberQ[x] || VectorQ[x, NumberQ];

(* A grid's first part is read, and not the whole: woxi copies what it reads.
   A name that holds nothing has no parts. *)
SetAttributes[{gridQ, gridVariableQ}, HoldFirst];
gridQ[grid_Symbol] := gridVariableQ[grid];
gridQ[grid_] := MatchQ[grid, {_Association, _List}];
gridVariableQ[grid_Symbol] := ValueQ[grid] && AssociationQ[grid[[1]]];
gridVariableQ[_] := False;

End[];
