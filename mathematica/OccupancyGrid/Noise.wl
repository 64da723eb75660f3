(* Range noise that depends on nothing but the seed, the scan and the beam
   (SPEC.md section 3.3). *)

BeginPackage["OccupancyGrid`"];

Philox4x32::usage = "Philox4x32[{c0, c1, c2, c3}, {k0, k1}] gives the four \
random words of Philox4x32-10 (Salmon et al. 2011) for a counter and a key of \
32-bit words. Each word of the counter may be a list: four lists come back.";
NormalDeviate::usage = "NormalDeviate[seed, scan, beams] gives a standard \
normal deviate (Box and Muller 1958) for each beam of a list. Seed: 0 to \
2^32 - 1; scan and beams: numbers from 0.";
AddRangeNoise::usage = "AddRangeNoise[ranges, noiseStd, seed, scan, zMax] \
gives simulated ranges (metres) with noise, within [0, zMax].";

Begin["`Private`"];

(* [snippet: philox] *)
Philox4x32[counter_List, key_List] := Module[
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

(* [snippet: normal-deviate] *)
NormalDeviate[seed_, scan_, beams_List] := Module[{zero, w, u1, u2, radius},
  zero = 0*beams;
  w = Philox4x32[{zero + scan, beams, zero, zero}, {seed, 0}];
  u1 = DivideEach[w[[1]] + 0.5, 4294967296.];
  u2 = DivideEach[w[[2]] + 0.5, 4294967296.];
  radius = MapThread[Sqrt, {-2.*PortableLog[u1]}];
  radius*PortableCos[6.283185307179586*u2]];
(* [/snippet] *)

(* [snippet: range-noise] *)
AddRangeNoise[ranges_List, noiseStd_, seed_, scan_, zMax_] := Module[
  {deviates},
  (* a beam that met no wall gets noise too, as in the lesson (6.5) *)
  deviates = NormalDeviate[seed, scan, Range[Length[ranges]] - 1];
  Map[Clamp[#, 0., zMax] &, ranges + (noiseStd*deviates)]];
(* [/snippet] *)

End[];
EndPackage[];
