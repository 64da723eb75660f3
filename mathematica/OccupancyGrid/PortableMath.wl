(* sin, cos, exp and log with the same bits on every machine and in every
   language.

   The algorithms are those of fdlibm 5.3 (Sun Microsystems, 1993-1995), which
   Java's StrictMath is specified to be; SPEC.md section 9 writes them down.

   All four functions take a machine number or a list of them. Two spellings
   matter on the Wolfram kernel, and tests/rounding.wl checks them:
   Divide[x, y], because x/y is x*y^-1 and rounds twice; and sums and products
   of two terms each, because Plus and Times may put three in another order.
   Comparisons of machine numbers forgive their last bits there, so a
   difference is compared with 0, or UnitStep says which side it lies on.

   Results below 2^-1022 are what SPEC.md section 1 asks for, so the kernel's
   message about them, General::munfl, is quiet here.

   Wolfram has no infinite or undefined machine number: Infinity, -Infinity
   and Indeterminate stand for them, and NegativeZero for -0. Lists hold
   finite numbers only. *)

Begin["OccupancyGrid`Private`"];

PortablePi = 3.141592653589793;

(* {x1, x2, ..}/{y1, y2, ..}, or a list and a number.
   Lists are divided element by element, and by MapThread: the Wolfram kernel
   may multiply a whole list by reciprocals, and so may the code that it makes
   of Map or Table over a long one. *)
divideEach[x_List, y_List] := MapThread[Divide, {x, y}];
divideEach[x_List, y_] := divideEach[x, ConstantArray[y, Length[x]]];
divideEach[x_, y_List] := divideEach[ConstantArray[x, Length[y]], y];
divideEach[x_, y_] := Divide[x, y];

(* 2^k for k = -1074 .. 1023, made by exact steps *)
SetAttributes[quietly, HoldFirst];
quietly[expression_] := Quiet[expression, General::munfl];
powersOfTwo = quietly[Join[
  Reverse[Rest[NestList[0.5*# &, 1., 1074]]], NestList[2.*# &, 1., 1023]]];
powerOfTwo[k_Integer] := powersOfTwo[[k + 1075]];
powerOfTwo[k_List] := Map[powersOfTwo[[# + 1075]] &, k];

(* x * 2^k in two steps, of which only the second may round (where the result
   is subnormal): 2^k itself need not be a double *)
scaled[x_, k_] := With[{half = Quotient[k, 2]},
  quietly[(x*powerOfTwo[half])*powerOfTwo[k - half]]];

DoubleFromBits[hex_String] /; StringLength[hex] == 16 := With[{bits = FromDigits[hex, 16]},
  Which[
    bits < 2^63, positiveDouble[Quotient[bits, 2^52], Mod[bits, 2^52]],
    bits == 2^63, NegativeZero,
    True, -positiveDouble[Quotient[bits, 2^52] - 2048, Mod[bits, 2^52]]]];
DoubleFromBits[___] := wrongArguments[DoubleFromBits];

positiveDouble[field_, fraction_] := Which[
  field == 2047, If[fraction == 0, Infinity, Indeterminate],
  field == 0, scaled[N[fraction], -1074],
  True, scaled[N[fraction + 2^52], field - 1075]];

doubles[text_String] := Map[DoubleFromBits, StringSplit[text]];
double = DoubleFromBits;

DoubleToBits[x_?doubleQ] := Module[{bits},
  bits = Which[
    x === Indeterminate, 2047*2^52 + 2^51,
    x === NegativeZero, 2^63,
    x === Infinity || x === -Infinity, 2047*2^52,
    Abs[x] - powerOfTwo[-1022] < 0, Floor[scaled[Abs[x], 1074]],
    True, With[{e = exponent[x]},
      Floor[scaled[Abs[x], 52 - e]] + (e + 1022)*2^52]];
  If[x =!= Indeterminate && x =!= NegativeZero && x < 0,
    bits = bits + 2^63];
  IntegerString[bits, 16, 16]];
DoubleToBits[___] := wrongArguments[DoubleToBits];
doubleQ[x_] := NumberQ[x] || MemberQ[
  {Indeterminate, NegativeZero, Infinity, -Infinity}, x];

(* {e, m} with |x| = m * 2^e and 1 <= m < 2, two lists, for x other than 0.
   Only a hint is taken from MantissaExponent, which some interpreters round
   near powers of two; a subnormal x is first made larger. *)
exponentAndFraction[x_List] := Module[{size, tiny, e, m},
  size = Abs[x];
  tiny = 1 - atLeast[size, powerOfTwo[-1022]];
  If[Max[tiny] == 1,
    size = MapThread[If[#2 == 1, #1*powerOfTwo[54], #1] &, {size, tiny}]];
  e = Map[Last[MantissaExponent[#, 2]] - 1 &, size];
  m = scaled[size, -e];
  e = (e + UnitStep[m - 2.]) - (1 - UnitStep[m - 1.]);
  {e - 54*tiny, scaled[size, -e]}];

(* 0 has no exponent and gets one that is smaller than all *)
exponent[x_] := If[x == 0, -1100, First[First[exponentAndFraction[{x}]]]];

(* 1 where x >= c, else 0; and b where mask is 0, a where it is 1. What comes
   out is a, b or a sum with an exact zero: nothing is rounded. *)
atLeast[x_, c_] := UnitStep[x - c];
choose[mask_, a_, b_] := (mask*a) + ((1 - mask)*b);


(* --- Reduction to [-pi/4, pi/4] --- *)

(* bounds: |x| up to about pi/4, up to 3pi/4, up to 2^20*pi/2 *)
{smallBound, middleBound, hugeBound} = doubles["
    3FE921FC00000000 4002D97C00000000 413921FC00000000"];
invPio2 = double["3FE45F306DC9C883"];
pio2Split = doubles["
    3FF921FB40000000 3E74442D00000000 3CF8469880000000
    3B78CC5160000000 39F01B8380000000"];

(* upper words of n*pi/2, n = 1 .. 31, of which the first subtraction leaves
   so little near them that more of pi/2 is needed *)
npio2High = Map[FromDigits[#, 16] &, StringSplit["
    3FF921FB 400921FB 4012D97C 401921FB 401F6A7A 4022D97C 4025FDBB 402921FB
    402C463A 402F6A7A 4031475C 4032D97C 40346B9C 4035FDBB 40378FDB 403921FB
    403AB41B 403C463A 403DD85A 403F6A7A 40407E4C 4041475C 4042106C 4042D97C
    4043A28C 40446B9C 404534AC 4045FDBB 4046C6CB 40478FDB 404858EB"]];

twoOverPiDigits = Map[FromDigits[#, 16] &, StringSplit["
    A2F983 6E4E44 1529FC 2757D1 F534DD C0DB62 95993C 439041 FE5163 ABDEBB
    C561B7 246E3A 424DD2 E00649 2EEA09 D1921C FE1DEB 1CB129 A73EE8 8235F5
    2EBB44 84E99C 7026B4 5F7E41 3991D6 398353 39F49C 845F8B BDF928 3B1FF8
    97FFDE 05980F EF2F11 8B5A0A 6D1F6D 367ECF 27CB09 B74F46 3F669E 5FEA2D
    7527BA C7EBE5 F17B3D 0739F7 8A5292 EA6BFB 5FB11F 8D5D08 560330 46FC7B
    6BABF0 CFBC20 9AF436 1DA9E3 91615E E61B08 659985 5F14A0 68408D FFD880
    4D7327 310606 1556CA 73A8C9 60E27B C08C6B"]];

(* upper 32 bits of t >= 2^-1022 *)
highWord[t_] := With[{e = exponent[t]},
  Floor[scaled[t, 20 - e]] + (e + 1022)*2^20];

(* {n, y0, y1} with x = n*pi/2 + y0 + y1 and |y0 + y1| <= pi/4, three lists;
   n = 0 and y0 = x where x is so small itself. Most numbers need one
   subtraction only; those that need more are gone through once again. *)
reduce[x_List] := Module[{t, reduced, sign, n, y0, y1, rare},
  t = Abs[x];
  If[Max[t] - hugeBound >= 0,
    t = Map[If[# - hugeBound < 0, #, 0.] &, t]];
  reduced = atLeast[t, smallBound];
  sign = 2*UnitStep[x] - 1;
  n = Floor[(t*invPio2) + 0.5]*reduced;
  {y0, y1} = subtractFirst[t, N[n]];
  rare = Pick[Range[Length[x]],
    reduced*UnitStep[(t*0.000030517578125) - Abs[y0]], 1];
  Do[{y0[[i]], y1[[i]]} = subtractMore[t[[i]], n[[i]]], {i, rare}];
  n = sign*n;
  y0 = sign*y0;
  y1 = sign*y1;
  rare = Pick[Range[Length[x]], atLeast[Abs[x], hugeBound], 1];
  Do[{n[[i]], y0[[i]], y1[[i]]} = reduceHuge[x[[i]]], {i, rare}];
  {n, y0, y1}];

(* {y0, y1} of t less fn times the first part of pi/2 *)
With[{
    part = double["3FF921FB54400000"], tail = double["3DD0B4611A626331"]},
  subtractFirst[t_, fn_] := Module[{r, w, y0},
    r = t - (fn*part);
    w = fn*tail;
    y0 = r - w;
    {y0, (r - y0) - w}]];

(* {y0, y1} of one number near n*pi/2, where the subtraction cancels: with the
   second part of pi/2, and the third. The numbers are kept in lists of one,
   see README.md. *)
With[{
    part1 = double["3FF921FB54400000"], tail1 = double["3DD0B4611A626331"],
    part2 = double["3DD0B4611A600000"], tail2 = double["3BA3198A2E037073"],
    part3 = double["3BA3198A2E000000"], tail3 = double["397B839A252049C1"]},
  subtractMore[t_, n_] := Module[{cancels, step, r, w},
    cancels[limit_] :=
      (exponent[t] - exponent[First[r] - First[w]]) - limit > 0;
    step[before_, part_, tail_] := (
      r = before - part;
      w = tail - ((before - r) - part));
    r = {t - (n*part1)};
    w = {n*tail1};
    If[(n >= 32 || highWord[t] - npio2High[[n]] == 0) && cancels[16],
      step[r, {n*part2}, {n*tail2}];
      (* up to 3pi/4 fdlibm is content with the second part *)
      If[t - middleBound >= 0 && cancels[49],
        step[r, {n*part3}, {n*tail3}]]];
    {First[r] - First[w], First[(r - (r - w)) - w]}]];

(* Payne and Hanek's method: x times the digits of 2/pi that matter. All of
   it up to the last sums is exact in fdlibm too, so that integers say the
   same as its doubles. *)
reduceHuge[x_] := Module[
  {e0, mantissa, tx, jv, q0, column, columns, one, value, n, rest, sign,
   digits, q, fq},
  e0 = exponent[x] - 23;
  mantissa = Floor[scaled[Abs[x], 29 - e0]];
  tx = {Quotient[mantissa, 2^29], Mod[Quotient[mantissa, 32], 2^24],
    Mod[mantissa, 32]*2^19};
  jv = Max[0, Quotient[e0 - 3, 24]];
  q0 = e0 - 24*(jv + 1);
  (* digits of 2/pi before the first are zero *)
  column[i_] := Sum[
    If[(jv + i) - j >= 0,
      tx[[j + 1]]*twoOverPiDigits[[((jv + i) - j) + 1]],
      0],
    {j, 0, 2}];
  columns = Table[column[i], {i, 0, 4}];
  While[True,
    (* value = x*2/pi, modulo 8, in units of the last column *)
    value = Fold[(#1*2^24) + #2 &, 0, columns];
    one = 2^(24*(Length[columns] - 1) - q0);
    n = Mod[Quotient[value, one], 8];
    rest = Mod[value, one];
    sign = If[2*rest - one >= 0, -1, 1];
    If[sign < 0, n = n + 1; rest = one - rest];
    If[rest >= 2^96, Break[]];
    (* too little is left: bring in as many digits as are zero *)
    With[{more = 5 - Max[1, Length[IntegerDigits[rest, 2^24]]]},
      columns = Join[columns,
        Table[column[i + Length[columns]], {i, 0, more - 1}]]]];
  digits = IntegerDigits[rest, 2^24];
  q = MapIndexed[
    scaled[N[#1], (q0 - 24*(Length[columns] - 1))
      + 24*(Length[digits] - First[#2])] &, digits];
  fq = Table[
    Fold[#1 + #2 &, 0., Table[pio2Split[[k]]*q[[(m - k) + 1]],
      {k, 1, Min[5, m]}]],
    {m, 1, Length[q]}];
  With[{y0 = Fold[#1 + #2 &, 0., Reverse[fq]]},
    {n, sign*y0, sign*Fold[#1 + #2 &, First[fq] - y0, Rest[fq]]}*(
      2*UnitStep[x] - 1)]];


(* --- sin and cos --- *)

(* [snippet: portable-sin] *)
With[{
    s1 = double["BFC5555555555549"], s2 = double["3F8111111110F8A6"],
    s3 = double["BF2A01A019C161D5"], s4 = double["3EC71DE357B1FE7D"],
    s5 = double["BE5AE5E68A2B9CEB"], s6 = double["3DE5D93A5ACFD57C"],
    c1 = double["3FA555555555554C"], c2 = double["BF56C16C16C15177"],
    c3 = double["3EFA01A019CB1590"], c4 = double["BE927E4F809C52AD"],
    c5 = double["3E21EE9EBDB4B1C4"], c6 = double["BDA8FAE9BE8838D4"],
    tiny = powerOfTwo[-27]},

  (* sin(x + y) for |x| <= pi/4; y is the tail of a reduced x *)
  kernelSin[x_, y_, reduced_] := Module[{z, v, r, far, near},
    z = x*x;
    v = z*x;
    r = s2 + (z*(s3 + (z*(s4 + (z*(s5 + (z*s6)))))));
    far = x - (((z*((0.5*y) - (v*r))) - y) - (v*s1));
    near = x + (v*(s1 + (z*r)));
    choose[atLeast[Abs[x], tiny], choose[reduced, far, near], x]];

  (* cos(x + y) for |x| <= pi/4; y is the tail of x *)
  kernelCos[x_, y_] := Module[{z, r, qx, hz, cosine},
    z = x*x;
    r = z*(c1 + (z*(c2 + (z*(c3 + (z*(c4 + (z*(c5 + (z*c6))))))))));
    qx = quarter[Abs[x]];
    hz = (0.5*z) - qx;
    cosine = (1. - qx) - (hz - ((z*r) - (x*y)));
    choose[atLeast[Abs[x], tiny], cosine, 1.]]];

(* {n, sin y, cos y} with x = n*pi/2 + y. The last two lists are remembered:
   who asks for a cosine often asks for the sine next, and a scan's beams are
   asked for again after its noise. *)
kernels[x_List] := Module[{n, y0, y1},
  Which[
    sameQ[x, lastArgument], lastKernels,
    sameQ[x, lastButOneArgument], lastButOneKernels,
    True,
      {n, y0, y1} = reduce[x];
      lastButOneArgument = lastArgument;
      lastButOneKernels = lastKernels;
      lastArgument = x;
      lastKernels = quietly[{
        n,
        kernelSin[y0, y1, atLeast[Abs[x], smallBound]],
        kernelCos[y0, y1]}]]];

PortableSin[x_List?numbersQ] := Module[{n, s, c},
  {n, s, c} = kernels[x];
  (1 - 2*Quotient[Mod[n, 4], 2])*choose[Mod[n, 2], c, s]];

PortableCos[x_List?numbersQ] := Module[{n, s, c},
  {n, s, c} = kernels[x];
  (1 - 2*Quotient[Mod[n + 1, 4], 2])*choose[Mod[n, 2], s, c]];
(* [/snippet] *)

(* SameQ forgives the last bit of a number on the Wolfram kernel; a difference
   does not. *)
sameQ[x_, y_] := Length[x] - Length[y] == 0 && Max[Abs[x - y]] <= 0;
lastArgument = {};
lastKernels = {{}, {}, {}};
lastButOneArgument = {};
lastButOneKernels = {{}, {}, {}};

(* about x/4 for x from 0.3 on: x with the lower half of its bits dropped, so
   that 1 - x/4 is exact; 9/32 near pi/4, and 0 below 0.3 *)
With[{
    low = double["3FD3333300000000"],
    high = double["3FE9000100000000"]},
  quarter[x_] := Module[{fine, coarse, qx},
    fine = (0.25*Floor[x*4194304.])*powerOfTwo[-22];
    coarse = (0.25*Floor[x*2097152.])*powerOfTwo[-21];
    qx = choose[atLeast[x, 0.5], coarse, fine];
    choose[atLeast[x, high], 0.28125, atLeast[x, low]*qx]]];

PortableSin[NegativeZero] = NegativeZero;
PortableSin[x_?NumericQ] := First[PortableSin[{N[x]}]];
PortableSin[Infinity] = Indeterminate;
PortableSin[-Infinity] = Indeterminate;
PortableSin[Indeterminate] = Indeterminate;
PortableCos[NegativeZero] = 1.;
PortableCos[x_?NumericQ] := First[PortableCos[{N[x]}]];
PortableCos[Infinity] = Indeterminate;
PortableCos[-Infinity] = Indeterminate;
PortableCos[Indeterminate] = Indeterminate;
PortableSin[___] := wrongArguments[PortableSin];
PortableCos[___] := wrongArguments[PortableCos];


(* --- exp and log --- *)

(* [snippet: portable-exp] *)
With[{
    p1 = double["3FC555555555553E"], p2 = double["BF66C16C16BEBD93"],
    p3 = double["3F11566AAF25DE2C"], p4 = double["BEBBBD41C5D26BF1"],
    p5 = double["3E66376972BEA4D0"],
    invLn2 = double["3FF71547652B82FE"],
    ln2High = double["3FE62E42FEE00000"], ln2Low = double["3DEA39EF35793C76"],
    (* |x| from about 0.5 ln 2, from about 1.5 ln 2, from 2^-28 on *)
    half = double["3FD62E4300000000"], more = double["3FF0A2B200000000"],
    tiny = double["3E30000000000000"]},

  expInside[x_] := Module[{size, sign, k, dk, hi, lo, r, t, c, y},
    size = Abs[x];
    sign = 2*UnitStep[x] - 1;
    (* x = k ln 2 + (hi - lo) *)
    k = sign*Floor[(invLn2*size) + 0.5];
    k = atLeast[size, half]*choose[atLeast[size, more], k, sign];
    dk = N[k];
    hi = x - (dk*ln2High);
    lo = dk*ln2Low;
    r = hi - lo;
    t = r*r;
    c = r - (t*(p1 + (t*(p2 + (t*(p3 + (t*(p4 + (t*p5)))))))));
    (* with k = 0 this is 1 - ((r c)/(c - 2) - r), bit by bit *)
    y = 1. - ((lo - divideEach[r*c, 2. - c]) - hi);
    choose[atLeast[size, tiny], scaled[y, k], 1. + x]]];

PortableExp[x_?NumericQ] := Which[
  x - expOverflow > 0, Infinity,
  x - expUnderflow < 0, 0.,
  True, First[quietly[expInside[{N[x]}]]]];
PortableExp[x_List?numbersQ] := Module[{far, result},
  (* beyond 700 the result may be infinite or subnormal: one by one *)
  far = Pick[Range[Length[x]], UnitStep[Abs[x] - 700.], 1];
  result = quietly[expInside[(1 - UnitStep[Abs[x] - 700.])*x]];
  Do[result[[i]] = PortableExp[x[[i]]], {i, far}];
  result];
(* [/snippet] *)

{expOverflow, expUnderflow} = doubles["40862E42FEFA39EF C0874910D52D3051"];
PortableExp[NegativeZero] = 1.;
PortableExp[Infinity] = Infinity;
PortableExp[-Infinity] = 0.;
PortableExp[Indeterminate] = Indeterminate;
PortableExp[___] := wrongArguments[PortableExp];

(* the logarithm of a list is that of numbers that have one *)
positiveQ[x_] := numbersQ[x] && Min[x] > 0;

(* [snippet: portable-log] *)
With[{
    g1 = double["3FE5555555555593"], g2 = double["3FD999999997FA04"],
    g3 = double["3FD2492494229359"], g4 = double["3FCC71C51D8E78AF"],
    g5 = double["3FC7466496CB03DE"], g6 = double["3FC39A09D078C69F"],
    g7 = double["3FC2F112DF3E5244"], third = double["3FD5555555555555"],
    ln2High = double["3FE62E42FEE00000"], ln2Low = double["3DEA39EF35793C76"]},

  logInside[x_] := Module[
    {k, m, high, up, f, dk, hi, lo, s, z, w, t1, t2, r, hfsq, terms},
    {k, m} = exponentAndFraction[x];
    (* x = 2^k (1 + f) with 1 + f between sqrt(1/2) and sqrt(2) *)
    high = Floor[(m - 1.)*1048576.];
    up = UnitStep[high - 16^^6A09C];
    f = choose[up, 0.5*m, m] - 1.;
    dk = N[k + up];
    hi = dk*ln2High;
    lo = dk*ln2Low;

    s = divideEach[f, 2. + f];
    z = s*s;
    w = z*z;
    t1 = w*(g2 + (w*(g4 + (w*g6))));
    t2 = z*(g1 + (w*(g3 + (w*(g5 + (w*g7))))));
    r = t2 + t1;
    hfsq = (0.5*f)*f;
    (* for hx from 0x6147a to 0x6b851, and elsewhere; with k = 0 each is
       fdlibm's separate formula, bit by bit *)
    terms = choose[
      UnitStep[high - 16^^6147A]*UnitStep[16^^6B851 - high],
      hi - ((hfsq - ((s*(hfsq + r)) + lo)) - f),
      hi - (((s*(f - r)) - lo) - f)];
    (* |f| < 2^-20 *)
    r = (f*f)*(0.5 - (third*f));
    choose[UnitStep[2 - Mod[high + 2, 16^^100000]],
      hi - ((r - lo) - f), terms]]];

PortableLog[x_?NumericQ] := Which[
  x == 0, -Infinity,
  x < 0, Indeterminate,
  True, First[quietly[logInside[{N[x]}]]]];
PortableLog[x_List?positiveQ] := quietly[logInside[x]];
(* [/snippet] *)

PortableLog[NegativeZero] = -Infinity;
PortableLog[Infinity] = Infinity;
PortableLog[-Infinity] = Indeterminate;
PortableLog[Indeterminate] = Indeterminate;
PortableLog[___] := wrongArguments[PortableLog];

End[];
