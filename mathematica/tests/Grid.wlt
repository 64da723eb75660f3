small = GridSpec[4, 3, 0.5, -1., 0.25];
newSmall[p0_, lMin_, lMax_] := NewGrid[small, p0, 0.75, 0.3, lMin, lMax];

(* Problem 1: 30 m x 20 m in cells of 0.05 m *)
VerificationTest[
  With[{r = 0.05}, {Floor[Divide[30., r]], Floor[Divide[20., r]],
    Floor[Divide[30., r]]*Floor[Divide[20., r]]}],
  {600, 400, 240000},
  TestID -> "Problem 1: columns, rows and cells"]
VerificationTest[
  With[{spec = GridSpec[600, 400, 0.05, 0., 0.]},
    {WorldToGrid[spec, 0., 0.], WorldToGrid[spec, 29.99, 19.99],
      InBounds[spec, 599, 399], InBounds[spec, 600, 399]}],
  {{0, 0}, {599, 399}, 1, 0},
  TestID -> "Problem 1: the grid covers the rectangle"]

VerificationTest[
  Map[WorldToGrid[small, First[#], Last[#]] &,
    {{-1., 0.25}, {-0.51, 0.74}, {-0.5, 0.75}, {0.99, 1.74}, {1., 1.75},
      {-1.01, 0.24}, {-100., 100.}}],
  {{0, 0}, {0, 0}, {1, 1}, {3, 2}, {4, 3}, {-1, -1}, {-198, 199}},
  TestID -> "world to grid, inside and outside"]
VerificationTest[
  WorldToGrid[small, {-1., 1.}, {0.25, -0.5}], {{0, 4}, {0, -2}},
  TestID -> "world to grid, lists"]
VerificationTest[
  {GridToWorldCenter[small, 0, 0], GridToWorldCenter[small, 3, 2],
    GridToWorldCenter[small, -2, 5]},
  {{-0.75, 0.5}, {0.75, 1.5}, {-1.75, 3.}},
  TestID -> "centres of cells"]
VerificationTest[
  Map[InBounds[small, First[#], Last[#]] &,
    {{0, 0}, {3, 2}, {4, 2}, {3, 3}, {-1, 0}, {0, -1}}],
  {1, 1, 0, 0, 0, 0},
  TestID -> "in bounds"]

VerificationTest[
  bits[Map[Logit, {0.5, 0.75, 0.3, 0., 1., 1.*^-9, 0.9999999999}]],
  StringSplit["0000000000000000 3ff193ea7aad030a bfeb1d10670aae99 c034b927f327b435
    4034b927f3a12c85 c034b927f327b435 4034b927f3a12c85"],
  TestID -> "logit, kept from 0 and 1"]
VerificationTest[
  bits[Sigmoid[{0., 1., -1., 8., -8., 700., -700., 1000., -1000.}]],
  StringSplit["3fe0000000000000 3fe764d4f5d5a2bd 3fd136561454ba86 3feffd40b84505a2
    3f35fa3dd7d2f7a7 3ff0000000000000 00d14f2b0fb9307f 3ff0000000000000
    0000000000000000"],
  TestID -> "sigmoid, without overflow"]
VerificationTest[
  bits[Sigmoid[-0.8]], First[bits[Sigmoid[{-0.8}]]],
  TestID -> "sigmoid of a number"]

VerificationTest[
  With[{grid = newSmall[0.5, -2., 2.]}, LogOdds[grid]],
  ConstantArray[0., {3, 4}],
  TestID -> "a new grid is at the prior"]
VerificationTest[
  With[{grid = newSmall[0.2, -2., 2.]},
    {Union[Flatten[LogOdds[grid]]] === {grid["l0"]}, bits[grid["l0"]]}],
  {True, bits[Logit[0.2]]},
  TestID -> "a prior that is not one half"]
VerificationTest[
  With[{grid = newSmall[0.5, -2., 2.]},
    UpdateCell[grid, 1, 2, grid["lOcc"]];
    UpdateCell[grid, 3, 0, grid["lFree"]];
    UpdateCell[grid, 4, 0, grid["lOcc"]];
    UpdateCell[grid, 0, -1, grid["lOcc"]];
    bits[LogOdds[grid]] === bits[{
      {0., 0., 0., Logit[0.3]}, {0., 0., 0., 0.},
      {0., Logit[0.75], 0., 0.}}]],
  True,
  TestID -> "one cell is updated, cells outside are skipped"]
VerificationTest[
  With[{grid = newSmall[0.5, -2., 2.]},
    Table[UpdateCell[grid, 0, 0, grid["lOcc"]]; LogOdds[grid][[1, 1]], {3}]],
  {Logit[0.75], 2., 2.},
  TestID -> "the upper clamp"]
VerificationTest[
  With[{grid = newSmall[0.5, -2., 2.]},
    Table[UpdateCell[grid, 0, 0, grid["lFree"]]; LogOdds[grid][[1, 1]], {4}]],
  {Logit[0.3], Logit[0.3] + Logit[0.3], -2., -2.},
  TestID -> "the lower clamp"]

(* many beams at once do what UpdateCell does one by one, whatever the signs of
   the two steps, also when the cells are looked at in between *)
beamsOfTest = Table[
  {Table[randomBelow[12] + 1, {randomBelow[20]}],
    Table[randomBelow[12] + 1, {randomBelow[2]}]},
  {60}];
gridOfTest[{pFree_, pOcc_}] := NewGrid[
  GridSpec[4, 3, 1., 0., 0.], 0.4, pOcc, pFree, -1.5, 1.2];
updateEach[grid_, cells_, evidence_] := Scan[
  UpdateCell[grid, Mod[# - 1, 4], Quotient[# - 1, 4], evidence] &, cells];
VerificationTest[
  Map[
    Function[steps,
      With[{grid = gridOfTest[steps]},
        Scan[
          (updateEach[grid, First[#], grid["lFree"]];
            updateEach[grid, Last[#], grid["lOcc"]]) &,
          beamsOfTest];
        With[{expected = bits[LogOdds[grid]]},
          gridOfTest[steps];
          UpdateCells[grid, Take[beamsOfTest, 25]];
          LogOdds[grid];
          updateEach[grid, First[beamsOfTest[[26]]], grid["lFree"]];
          updateEach[grid, Last[beamsOfTest[[26]]], grid["lOcc"]];
          UpdateCells[grid, Drop[beamsOfTest, 26]];
          bits[LogOdds[grid]] === expected]]],
    {{0.3, 0.75}, {0.399, 0.9}, {0.4, 0.45}, {0.6, 0.2}, {0.3, 0.35},
      {0.7, 0.8}}],
  {True, True, True, True, True, True},
  TestID -> "a list of cells"]

VerificationTest[
  With[{grid = newSmall[0.5, -2., 2.]},
    UpdateCell[grid, 1, 0, grid["lOcc"]];
    ProbabilityGrid[grid]],
  {{0.5, 0.7499999999999999, 0.5, 0.5}, {0.5, 0.5, 0.5, 0.5}, {0.5, 0.5, 0.5, 0.5}},
  TestID -> "probabilities"]

(* Problem 4: after t updates the odds are O0 (Oinv/O0)^t. In decimal numbers
   of the textbook, so not to the last bit. *)
closedForm[p0_, pInv_, t_] := Module[{o0, oInv, odds},
  o0 = p0/(1 - p0);
  oInv = pInv/(1 - pInv);
  odds = o0*(oInv/o0)^t;
  odds/(1 + odds)];
VerificationTest[
  Max[Flatten[Table[
    With[{grid = NewGrid[GridSpec[1, 1, 1., 0., 0.],
        p0, 0.75, pInv, -50., 50.]},
      Table[
        UpdateCell[grid, 0, 0, grid["lFree"]];
        Abs[ProbabilityGrid[grid][[1, 1]] - closedForm[p0, pInv, t]],
        {t, 1, 12}]],
    {p0, {0.5, 0.2, 0.7}}, {pInv, {0.3, 0.4, 0.6}}]]] < 1.*^-14,
  True,
  TestID -> "Problem 4: repeated evidence in closed form"]
VerificationTest[
  With[{grid = NewGrid[GridSpec[1, 1, 1., 0., 0.],
      0.5, 0.75, 0.3, -50., 50.]},
    Do[UpdateCell[grid, 0, 0, grid["lFree"]], {40}];
    ProbabilityGrid[grid][[1, 1]] < 1.*^-14],
  True,
  TestID -> "Problem 4: free evidence drives the probability to 0"]
VerificationTest[
  {Clamp[3., 0., 2.], Clamp[-1., 0., 2.], Clamp[1., 0., 2.],
    Clamp[2.0000000000000004, 0., 2.]},
  {2., 0., 1., 2.},
  TestID -> "clamp, to the last bit"]
