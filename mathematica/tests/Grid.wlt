small = GridSpec[4, 3, 0.5, -1., 0.25];
newSmall[p0_, lMin_, lMax_] := OccupancyGrid[
  small, p0, 0.75, 0.3, lMin, lMax];
smallGrid = newSmall[0.5, -2., 2.];

(* Problem 1: 30 m x 20 m in cells of 0.05 m *)
VerificationTest[
  With[{r = 0.05}, {Floor[Divide[30., r]], Floor[Divide[20., r]],
    Floor[Divide[30., r]]*Floor[Divide[20., r]]}],
  {600, 400, 240000},
  TestID -> "Problem 1: columns, rows and cells"]
VerificationTest[
  Module[{grid = {GridSpec[600, 400, 0.05, 0., 0.], {}}},
    {WorldToGrid[grid, 0., 0.], WorldToGrid[grid, 29.99, 19.99],
      InBounds[grid, 599, 399], InBounds[grid, 600, 399]}],
  {{0, 0}, {599, 399}, True, False},
  TestID -> "Problem 1: the grid covers the rectangle"]

VerificationTest[
  Map[WorldToGrid[smallGrid, First[#], Last[#]] &,
    {{-1., 0.25}, {-0.51, 0.74}, {-0.5, 0.75}, {0.99, 1.74}, {1., 1.75},
      {-1.01, 0.24}, {-100., 100.}}],
  {{0, 0}, {0, 0}, {1, 1}, {3, 2}, {4, 3}, {-1, -1}, {-198, 199}},
  TestID -> "world to grid, inside and outside"]
VerificationTest[
  WorldToGrid[smallGrid, {-1., 1.}, {0.25, -0.5}], {{0, 4}, {0, -2}},
  TestID -> "world to grid, lists"]
VerificationTest[
  {GridToWorldCenter[smallGrid, 0, 0], GridToWorldCenter[smallGrid, 3, 2],
    GridToWorldCenter[smallGrid, -2, 5]},
  {{-0.75, 0.5}, {0.75, 1.5}, {-1.75, 3.}},
  TestID -> "centres of cells"]
VerificationTest[
  Map[InBounds[smallGrid, First[#], Last[#]] &,
    {{0, 0}, {3, 2}, {4, 2}, {3, 3}, {-1, 0}, {0, -1}}],
  {True, True, False, False, False, False},
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
  LogOdds[smallGrid],
  ConstantArray[0., {3, 4}],
  TestID -> "a new grid is at the prior"]
VerificationTest[
  Module[{grid = newSmall[0.2, -2., 2.]},
    {Union[Flatten[LogOdds[grid]]] === {First[grid]["l0"]}, bits[First[grid]["l0"]]}],
  {True, bits[Logit[0.2]]},
  TestID -> "a prior that is not one half"]
VerificationTest[
  Module[{grid = newSmall[0.5, -2., 2.]},
    UpdateCell[grid, 1, 2, First[grid]["lOcc"]];
    UpdateCell[grid, 3, 0, First[grid]["lFree"]];
    UpdateCell[grid, 4, 0, First[grid]["lOcc"]];
    UpdateCell[grid, 0, -1, First[grid]["lOcc"]];
    bits[LogOdds[grid]] === bits[{
      {0., 0., 0., Logit[0.3]}, {0., 0., 0., 0.},
      {0., Logit[0.75], 0., 0.}}]],
  True,
  TestID -> "one cell is updated, cells outside are skipped"]
VerificationTest[
  Module[{grid = newSmall[0.5, -2., 2.]},
    Table[UpdateCell[grid, 0, 0, First[grid]["lOcc"]]; LogOdds[grid][[1, 1]], {3}]],
  {Logit[0.75], 2., 2.},
  TestID -> "the upper clamp"]
VerificationTest[
  Module[{grid = newSmall[0.5, -2., 2.]},
    Table[UpdateCell[grid, 0, 0, First[grid]["lFree"]]; LogOdds[grid][[1, 1]], {4}]],
  {Logit[0.3], Logit[0.3] + Logit[0.3], -2., -2.},
  TestID -> "the lower clamp"]

(* the cells of a beam at once do what UpdateCell does one by one *)
VerificationTest[
  Module[{one = newSmall[0.4, -2., 2.], all},
    all = one;
    Do[
      With[{gx = {-1, 0, 1, 2, 3, 4}, gy = {0, 0, 1, 1, 2, 3}},
        UpdateCells[all, gx, gy, evidence];
        MapThread[UpdateCell[one, #1, #2, evidence] &, {gx, gy}]],
      {evidence, {Logit[0.75], Logit[0.75], Logit[0.9], Logit[0.3],
        Logit[0.1], Logit[0.05], Logit[0.9]}}];
    {gridBits[one] === gridBits[all],
      Length[Union[Flatten[LogOdds[all]]]] > 1}],
  {True, True},
  TestID -> "the cells of a beam at once"]
VerificationTest[
  Module[{grid = newSmall[0.5, -2., 2.]},
    UpdateCells[grid, {}, {}, 1.];
    gridBits[grid] === gridBits[smallGrid]],
  True,
  TestID -> "no cells"]

(* a grid is a value *)
VerificationTest[
  Module[{first = newSmall[0.5, -2., 2.], second, copy},
    second = OccupancyGrid[GridSpec[2, 1, 1., 0., 0.],
      0.5, 0.75, 0.3, -8., 8.];
    copy = first;
    UpdateCell[first, 0, 0, Logit[0.75]];
    UpdateCell[second, 1, 0, Logit[0.3]];
    {Dimensions[LogOdds[first]], Dimensions[LogOdds[second]],
      LogOdds[first][[1, 1]], LogOdds[copy][[1, 1]],
      LogOdds[second] === {{0., Logit[0.3]}},
      Total[Flatten[LogOdds[first] - LogOdds[copy]]] === Logit[0.75]}],
  {{3, 4}, {1, 2}, Logit[0.75], 0., True, True},
  TestID -> "two grids at once, and a copy"]

VerificationTest[
  Module[{grid = newSmall[0.5, -2., 2.]},
    UpdateCell[grid, 1, 0, First[grid]["lOcc"]];
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
    Module[{grid = OccupancyGrid[GridSpec[1, 1, 1., 0., 0.],
        p0, 0.75, pInv, -50., 50.]},
      Table[
        UpdateCell[grid, 0, 0, First[grid]["lFree"]];
        Abs[ProbabilityGrid[grid][[1, 1]] - closedForm[p0, pInv, t]],
        {t, 1, 12}]],
    {p0, {0.5, 0.2, 0.7}}, {pInv, {0.3, 0.4, 0.6}}]]] < 1.*^-14,
  True,
  TestID -> "Problem 4: repeated evidence in closed form"]
VerificationTest[
  Module[{grid = OccupancyGrid[GridSpec[1, 1, 1., 0., 0.],
      0.5, 0.75, 0.3, -50., 50.]},
    Do[UpdateCell[grid, 0, 0, First[grid]["lFree"]], {40}];
    ProbabilityGrid[grid][[1, 1]] < 1.*^-14],
  True,
  TestID -> "Problem 4: free evidence drives the probability to 0"]
VerificationTest[
  {clamp[3., 0., 2.], clamp[-1., 0., 2.], clamp[1., 0., 2.],
    clamp[2.0000000000000004, 0., 2.],
    clamp[{3., -1., 1., 2.0000000000000004, 0., 2.}, 0., 2.]},
  {2., 0., 1., 2., {2., 0., 1., 2., 0., 2.}},
  TestID -> "clamp, to the last bit"]
