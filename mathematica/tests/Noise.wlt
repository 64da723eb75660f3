hex[text_] := Map[FromDigits[#, 16] &, StringSplit[text]];

(* the known answers published with Philox *)
VerificationTest[
  Philox4x32[{0, 0, 0, 0}, {0, 0}],
  hex["6627e8d5 e169c58d bc57ac4c 9b00dbd8"],
  TestID -> "Philox of zeros"]
VerificationTest[
  Philox4x32[hex["ffffffff ffffffff ffffffff ffffffff"],
    hex["ffffffff ffffffff"]],
  hex["408f276d 41c83b0e a20bc7c6 6d5451fd"],
  TestID -> "Philox of ones"]
VerificationTest[
  Philox4x32[hex["243f6a88 85a308d3 13198a2e 03707344"],
    hex["a4093822 299f31d0"]],
  hex["d16cfe09 94fdcceb 5001e420 24126ea1"],
  TestID -> "Philox of pi"]

VerificationTest[
  Philox4x32[{{5, 5, 4294967295}, {0, 1, 7}, {0, 0, 0}, {0, 0, 0}}, {9, 0}],
  Transpose[{Philox4x32[{5, 0, 0, 0}, {9, 0}],
    Philox4x32[{5, 1, 0, 0}, {9, 0}],
    Philox4x32[{4294967295, 7, 0, 0}, {9, 0}]}],
  TestID -> "Philox of lists"]

VerificationTest[
  bits[NormalDeviate[0, 5, {0, 1, 180}]],
  StringSplit["3ff3e772e50bfa1f 3fb954b9ea013af7 3fd12670a9ec35a4"],
  TestID -> "normal deviates"]
VerificationTest[
  bits[NormalDeviate[7, 3, {11}]], bits[{NormalDeviate[7, 3, {0, 11}][[2]]}],
  TestID -> "the noise of a beam depends on no other beam"]
VerificationTest[
  AddRangeNoise[{0., 10., 5.}, 4., 2, 0, 10.],
  {0., 10., 8.529211628877823},
  TestID -> "noisy ranges stay between 0 and the maximum"]
VerificationTest[
  bits[AddRangeNoise[{1., 2.}, 0.02, 4, 9, 10.]],
  bits[{1., 2.} + (0.02*NormalDeviate[4, 9, {0, 1}])],
  TestID -> "noise is added"]
