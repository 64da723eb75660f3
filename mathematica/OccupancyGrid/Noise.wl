(* Range noise that depends on nothing but the seed, the scan and the beam
   (SPEC.md section 3.3). *)

Begin["OccupancyGrid`Private`"];

(* [snippet: philox] *)
Philox4x32[counter_?wordsQ, key_?wordsQ] := Module[
  {c0, c1, c2, c3, k0, k1, high0, low0, high1, low1},
  {c0, c1, c2, c3} = counter;
  {k0, k1} = key;
  Do[
    {high0, low0} = multiplied[16^^D251, 16^^1F53, c0];
    {high1, low1} = multiplied[16^^CD9E, 16^^8D57, c2];
    c0 = BitXor[high1, c1, k0];
    c1 = low1;
    c2 = BitXor[high0, c3, k1];
    c3 = low0;
    k0 = Mod[k0 + 16^^9E3779B9, 2^32];
    k1 = Mod[k1 + 16^^BB67AE85, 2^32],
    {10}];
  {c0, c1, c2, c3}];

(* upper and lower word of (2^16 mHigh + mLow) c, in halves: no number here
   reaches 2^53, up to which lists of whole numbers are exact everywhere *)
multiplied[mHigh_, mLow_, c_] := Module[{lower, carry, upper, high},
  lower = mLow*c;
  carry = Quotient[lower, 65536];
  upper = (mHigh*c) + carry;
  high = Quotient[upper, 65536];
  {high,
    (65536*(upper - (65536*high))) + (lower - (65536*carry))}];
(* [/snippet] *)
Philox4x32[___] := wrongArguments[Philox4x32];

(* two or four words of 32 bits, or lists of them *)
wordsQ[words_] := ListQ[words] && MemberQ[{2, 4}, Length[words]] &&
  VectorQ[Flatten[words], IntegerQ] &&
  Min[words] >= 0 && Max[words] < 2^32;

(* [snippet: normal-deviate] *)
NormalDeviate[seed_Integer, scan_Integer, beam_List] := Module[
  {zero = 0*beam, w, u1, u2, radius},
  w = Philox4x32[{zero + scan, beam, zero, zero}, {seed, 0}];
  u1 = divideEach[w[[1]] + 0.5, 4294967296.];
  u2 = divideEach[w[[2]] + 0.5, 4294967296.];
  radius = MapThread[Sqrt, {-2.*PortableLog[u1]}];
  radius*PortableCos[(2.*PortablePi)*u2]];
(* [/snippet] *)
NormalDeviate[___] := wrongArguments[NormalDeviate];

(* [snippet: range-noise] *)
AddRangeNoise[ranges_List?numbersQ, noiseStd_, seed_, scan_, zMax_] := Module[
  {deviates},
  (* a beam that met no wall gets noise too, as in the lesson *)
  deviates = NormalDeviate[seed, scan, Range[Length[ranges]] - 1];
  clamp[ranges + (noiseStd*deviates), 0., zMax]];
(* [/snippet] *)
AddRangeNoise[___] := wrongArguments[AddRangeNoise];

End[];
