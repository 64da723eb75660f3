(* Known answers are those of Java's StrictMath. *)

doublesOf[text_] := Map[DoubleFromBits, StringSplit[text]];

VerificationTest[
  bits[doublesOf["0000000000000000 0000000000000001 000fffffffffffff
    0010000000000000 3ff0000000000000 bff8000000000000 7fefffffffffffff
    7ff0000000000000 fff0000000000000 7ff8000000000000 8000000000000000
    3fefffffffffffff 432fffffffffffff 3e70000000000000"]],
  StringSplit["0000000000000000 0000000000000001 000fffffffffffff
    0010000000000000 3ff0000000000000 bff8000000000000 7fefffffffffffff
    7ff0000000000000 fff0000000000000 7ff8000000000000 8000000000000000
    3fefffffffffffff 432fffffffffffff 3e70000000000000"],
  TestID -> "bits are read and written"]

VerificationTest[
  bits[{1., -0.1, 3.141592653589793, 1.*^-7}],
  {"3ff0000000000000", "bfb999999999999a", "400921fb54442d18",
    "3e7ad7f29abcaf48"},
  TestID -> "bits of decimal numbers"]

VerificationTest[
  bits[Map[PortableSin, doublesOf["
    0000000000000001 3e3fffffffffffff 3fe921fb54442d18 3fe921fc00000000
    3ff0000000000000 3ff921fb54442d18 400921fb54442d18 c012d97c7f3321d2
    402921fb54442d18 4076800000000000 c0f3880000000000 413921fb54442d18
    4415af1d78b58c40 5fe3502d8ea5e2fa 7506ac5b262ca1ff 7fefffffffffffff"]]],
  StringSplit["
    0000000000000001 3e3fffffffffffff 3fe6a09e667f3bcc 3fe6a09edfee58ba
    3feaed548f090cee 3ff0000000000000 3ca1a62633145c07 3ff0000000000000
    bcc1a62633145c07 3feeaf7006f5e879 bfe38ab87c8733f8 bdd1a62633145c07
    bfe4a5e605fd6450 bfe690a12f59e1c5 3ff0000000000000 3f7452fc98b34e97"],
  TestID -> "sin, number by number"]

VerificationTest[
  bits[Map[PortableCos, doublesOf["
    0000000000000001 3e3fffffffffffff 3fe921fb54442d18 3fe921fc00000000
    3ff0000000000000 3ff921fb54442d18 400921fb54442d18 c012d97c7f3321d2
    402921fb54442d18 4076800000000000 c0f3880000000000 413921fb54442d18
    4415af1d78b58c40 5fe3502d8ea5e2fa 7506ac5b262ca1ff 7fefffffffffffff"]]],
  StringSplit["
    3ff0000000000000 3ff0000000000000 3fe6a09e667f3bcd 3fe6a09ded101c54
    3fe14a280fb5068c 3c91a62633145c07 bff0000000000000 bcaa79394c9e8a0a
    3ff0000000000000 bfd227feae0679b7 bfe957097e2c1a8a 3ff0000000000000
    3fe872720fc60d3d 3fe6b090593892a3 bc214ae72e6ba22f bfefffe62ecfab75"],
  TestID -> "cos, number by number"]

VerificationTest[
  bits[Map[PortableExp, doublesOf["
    3e2fffffffffffff bfd62e42fefa39ef 3fd62e4300000000 3ff0000000000000
    bff0a2b200000000 c02e000000000000 4086000000000000 40862e42fefa39ef
    40862e42fefa39f0 c086232bdd7abcd2 c086800000000000 c0874910d52d3051
    c0874910d52d3052"]]],
  StringSplit["
    3ff0000001000000 3fe6a09e667f3bcc 3ff6a09e66dbc8da 4005bf0a8b14576a
    3fd6a09ebfec0ef1 3e94875ca227ec38 7f693bf4ec282efb 7fefffffffffff2a
    7ff0000000000000 001000000000007c 0000000993b4dc95 0000000000000001
    0000000000000000"],
  TestID -> "exp, number by number"]

VerificationTest[
  bits[Map[PortableLog, doublesOf["
    0000000000000001 000fffffffffffff 0010000000000000 3e112e0be826d695
    3fe0000000000000 3fe6a09e667f3bcd 3fefffffffffffff 3ff0000000000000
    3ff0000000000001 3ff6a09e667f3bcd 4008000000000000 402e000000000000
    7fefffffffffffff"]]],
  StringSplit["
    c0874385446d71c3 c086232bdd7abcd2 c086232bdd7abcd2 c034b927f32bffb8
    bfe62e42fefa39ef bfd62e42fefa39ee bca0000000000000 0000000000000000
    3cafffffffffffff 3fd62e42fefa39f0 3ff193ea7aad030a 4005aa16394d481f
    40862e42fefa39ef"],
  TestID -> "log, number by number"]

VerificationTest[
  Map[PortableSin, {NegativeZero, Infinity, -Infinity, Indeterminate}],
  {NegativeZero, Indeterminate, Indeterminate, Indeterminate},
  TestID -> "sin of what is no machine number"]
VerificationTest[
  bits[Map[PortableCos, {NegativeZero, Infinity, -Infinity, Indeterminate}]],
  {"3ff0000000000000", "7ff8000000000000", "7ff8000000000000",
    "7ff8000000000000"},
  TestID -> "cos of what is no machine number"]
VerificationTest[
  bits[Map[PortableExp, {NegativeZero, Infinity, -Infinity, Indeterminate}]],
  {"3ff0000000000000", "7ff0000000000000", "0000000000000000",
    "7ff8000000000000"},
  TestID -> "exp of what is no machine number"]
VerificationTest[
  bits[Map[PortableLog,
    {NegativeZero, 0., -1., Infinity, -Infinity, Indeterminate}]],
  {"fff0000000000000", "fff0000000000000", "7ff8000000000000",
    "7ff0000000000000", "7ff8000000000000", "7ff8000000000000"},
  TestID -> "log of what has none"]

(* Lists take another way than numbers: sharing what they can, one by one
   where they must. *)
mixed = {0.5, -2., 1.5707963267948966, 0., 1.*^300, 3.*^-9, -1.*^6, 710.,
  6.283185307179586, -740., 0.7853981633974483, 100., 1.*^-310};
VerificationTest[
  bits[PortableSin[mixed]], Map[bits[PortableSin[#]] &, mixed],
  TestID -> "sin of a list"]
VerificationTest[
  bits[PortableCos[mixed]], Map[bits[PortableCos[#]] &, mixed],
  TestID -> "cos of a list"]
VerificationTest[
  bits[PortableExp[mixed]], Map[bits[PortableExp[#]] &, mixed],
  TestID -> "exp of a list"]
VerificationTest[
  bits[PortableLog[{0.5, 2., 1.*^-310, 1.*^300, 0.9999999999, 1.}]],
  Map[bits[PortableLog[#]] &,
    {0.5, 2., 1.*^-310, 1.*^300, 0.9999999999, 1.}],
  TestID -> "log of a list"]
VerificationTest[
  {bits[PortableSin[{1., 2.}]], bits[PortableSin[{1., 2.000000000000001}]]}
    === {bits[PortableSin[{1., 2.}]], bits[PortableSin[{1., 2.}]]},
  False,
  TestID -> "a list is not taken for the one before it"]

VerificationTest[
  bits[{divideEach[15, 137.], divideEach[1., 49.]}],
  {"3fbc077975b8fe22", "3f94e5e0a72f0539"},
  TestID -> "a quotient is rounded once"]
VerificationTest[
  bits[divideEach[{1., 15.}, 49.]], bits[Map[Divide[#, 49.] &, {1., 15.}]],
  TestID -> "a list by a number"]
VerificationTest[
  bits[divideEach[15., {49., 137.}]],
  bits[Map[Divide[15., #] &, {49., 137.}]],
  TestID -> "a number by a list"]
