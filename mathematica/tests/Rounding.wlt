(* No source of the package may round otherwise on a Wolfram kernel. *)

modules = {"Usage", "Arguments", "PortableMath", "Noise", "Grid", "Ray",
  "World", "Sensor", "Scenario", "Lesson", "Mapper", "Fast", "MapWriter",
  "MapFiles", "Picture", "Main"};
sourceOf[module_] := ReadString[
  FileNameJoin[{here, "..", "OccupancyGrid", module <> ".wl"}]];

VerificationTest[
  Map[Complaints[sourceOf[#]] &, modules],
  Map[{} &, modules],
  TestID -> "no source has a quotient, a long sum or a long product"]

VerificationTest[
  Map[ComparisonComplaints[sourceOf[#]] &,
    {"PortableMath", "Noise", "Grid", "World"}],
  {{}, {}, {}, {}},
  TestID -> "machine numbers are compared with 0"]

VerificationTest[
  Sort[Map[FileBaseName, FileNames["*.wl",
    {FileNameJoin[{here, "..", "OccupancyGrid"}]}]]],
  Sort[modules],
  TestID -> "all modules are looked at"]

(* each rule with what it refuses *)
VerificationTest[
  Complaints["t = Map[If[f[#], 1., Divide[a, #]] &, x];\nDivide[a, b];"],
  {{1, "a division mapped over a list"}},
  TestID -> "refuses Divide within Map"]
VerificationTest[
  Complaints["Table[(z = Divide[1., k]), {k, 9}]; Divide[1., x] /@ y"],
  {{1, "a division mapped over a list"}},
  TestID -> "refuses Divide within Table"]
VerificationTest[
  Complaints["MapThread[Divide, {x, y}]; Map[f, x]; Divide[a, b]"], {},
  TestID -> "lets MapThread and a single division pass"]
VerificationTest[
  Complaints["f[x_, y_] := x/y;"], {{1, "a quotient"}},
  TestID -> "refuses a quotient"]
VerificationTest[
  Complaints["a = 1;\nb = {x /y};"], {{2, "a quotient"}},
  TestID -> "refuses a quotient in a list"]
VerificationTest[
  Complaints["x /= 3."], {{1, "a quotient"}},
  TestID -> "refuses division in place"]
VerificationTest[
  Complaints["a + b + c"], {{1, "a sum of three terms"}},
  TestID -> "refuses a + b + c"]
VerificationTest[
  Complaints["a - b*c + d[[1]]"], {{1, "a sum of three terms"}},
  TestID -> "refuses a - b*c + d"]
VerificationTest[
  Complaints["x = f[a + (b - c) - d, 2]"], {{1, "a sum of three terms"}},
  TestID -> "refuses a sum that goes on after a bracket"]
VerificationTest[
  Complaints["-a + b"], {},
  TestID -> "lets a sign pass that is no difference"]
VerificationTest[
  Complaints["a*b*c"], {{1, "a product of three factors"}},
  TestID -> "refuses a*b*c"]
VerificationTest[
  Complaints["x + 2*(a)*c"], {{1, "a product of three factors"}},
  TestID -> "refuses a long product within a sum"]
VerificationTest[
  Complaints["2 x"], {{1, "a product without a sign"}},
  TestID -> "refuses a product without a sign"]
VerificationTest[
  Complaints["(a + b)(c)"], {{1, "a product without a sign"}},
  TestID -> "refuses a product of brackets without a sign"]
VerificationTest[
  Complaints["x^2"], {{1, "a power"}},
  TestID -> "refuses a power"]
VerificationTest[
  Complaints["x*1*^-5"], {{1, "an exact rational"}},
  TestID -> "refuses an exact rational"]
VerificationTest[
  Complaints["x = 3.14159265358979323846;"], {{1, "more than 17 digits"}},
  TestID -> "refuses arbitrary precision"]
VerificationTest[
  Complaints["y = Sin[x] + N[Pi]"],
  {{1, "the platform's Sin"}, {1, "the platform's Pi"}},
  TestID -> "refuses the platform's functions"]
VerificationTest[
  Complaints["(* a/b (* x + y + z *) c/d *) \"a/b\" <> f /@ x; y //. z;
    {a + b, c + d}; a*b + c*d; (a + b) + c; #1*#2 &; x_List; 2^52; a - -b"],
  {},
  TestID -> "lets comments, texts and two terms pass"]
VerificationTest[
  ComparisonComplaints["If[x < y, 1, 2]; x - y < 0; n >= 2^52; a == b;"],
  {{1, "a comparison of machine numbers"},
    {1, "a comparison of machine numbers"}},
  TestID -> "refuses comparisons of machine numbers"]
