(* What every public name is for, and the messages. OccupancyGrid.wl reads
   this file first, while names go to the context OccupancyGrid`. *)

Begin["OccupancyGrid`"];

$OccupancyGridFolder::usage = "$OccupancyGridFolder is the folder of \
OccupancyGrid.wl. It is set before the package is read where the interpreter \
does not say where a file lies (woxi).";

(* --- portable_math --- *)

PortablePi::usage = "PortablePi is pi as a machine number.";
PortableSin::usage = "PortableSin[x] is the sine of x (radians), a number \
or a list; Indeterminate where x is infinite or Indeterminate (SPEC.md 9.2).";
PortableCos::usage = "PortableCos[x] is the cosine of x (radians), a number \
or a list; Indeterminate where x is infinite or Indeterminate (SPEC.md 9.2).";
PortableExp::usage = "PortableExp[x] is e to the power x, a number or a \
list; Infinity above 709.78, 0. below -745.13 (SPEC.md 9.3).";
PortableLog::usage = "PortableLog[x] is the natural logarithm of x, a number \
or a list of positive ones; -Infinity at 0, Indeterminate below it (SPEC.md \
9.4).";
DoubleFromBits::usage = "DoubleFromBits[\"3ff0000000000000\"] is the machine \
number with these 64 bits, 16 hexadecimal digits; Infinity, -Infinity, \
Indeterminate and NegativeZero for what is not a machine number here.";
DoubleToBits::usage = "DoubleToBits[x] gives the 64 bits of x as 16 \
hexadecimal digits; NaN is 7ff8000000000000.";
NegativeZero::usage = "NegativeZero stands for the double -0, of which \
Wolfram keeps no account.";

(* --- noise --- *)

Philox4x32::usage = "Philox4x32[{c0, c1, c2, c3}, {k0, k1}] gives the four \
random words of Philox4x32-10 (Salmon et al. 2011) for a counter and a key of \
32-bit words. Each word of the counter may be a list: four lists come back.";
NormalDeviate::usage = "NormalDeviate[seed, scan, beam] gives a standard \
normal deviate (Box and Muller 1958) for each beam of a list. Seed: 0 to \
2^32 - 1; scan and beams: numbers from 0.";
AddRangeNoise::usage = "AddRangeNoise[ranges, noiseStd, seed, scan, zMax] \
gives simulated ranges (m) with noise, within [0, zMax] (lesson section 6.5).";

(* --- grid --- *)

GridSpec::usage = "GridSpec[width, height, resolution, originX, originY] \
says where the cells lie in the world: numbers of columns and rows, side of \
a cell (m), world coordinates of the lower left corner (m).";
Logit::usage = "Logit[p] is the log-odds of a probability, which is kept \
within [1e-9, 1 - 1e-9] (lesson section 3).";
Sigmoid::usage = "Sigmoid[logOdds] is the probability of log-odds, a number \
or a list; no overflow at either end (lesson section 3).";
OccupancyGrid::usage = "OccupancyGrid[spec, p0, pOcc, pFree, lMin, lMax] is \
a new grid of which every cell is l0 = Logit[p0]: the value {model, logOdds}. \
The model is an association: the spec, l0, lOcc and lFree (the log-odds that \
UpdateCell takes for a hit and for a free cell), lMin and lMax. The log-odds \
are one flat list, the row with the smallest y first; LogOdds gives them row \
by row. A grid owns its cells: a copy of it does not change with it.";
LogOdds::usage = "LogOdds[grid] gives the log-odds, height lists of width \
numbers; the first list is the row with the smallest y.";
WorldToGrid::usage = "WorldToGrid[grid, x, y] gives the cell {gx, gy} of a \
point (m), or {list, list} of points; it may lie outside (lesson section 1).";
GridToWorldCenter::usage = "GridToWorldCenter[grid, gx, gy] gives the centre \
{x, y} of a cell (m).";
InBounds::usage = "InBounds[grid, gx, gy] is True where a cell lies in the \
grid, else False.";
UpdateCell::usage = "UpdateCell[grid, gx, gy, lUpdate] adds the evidence \
lUpdate - l0 to one cell of the grid in the variable grid, and clamps it \
(lesson section 3). A cell outside the grid is skipped.";
UpdateCells::usage = "UpdateCells[grid, gx, gy, lUpdate] is UpdateCell for \
the cells of one beam, two lists without a cell that comes twice.";
ProbabilityGrid::usage = "ProbabilityGrid[grid] is P(occupied) of every \
cell, height lists of width numbers.";

(* --- ray --- *)

Bresenham::usage = "Bresenham[gx0, gy0, gx1, gy1] gives the cells of the \
line from (gx0, gy0) to (gx1, gy1) in order, both included, as {list of gx, \
list of gy} (Bresenham 1965; lesson section 4). At most 2^20 steps.";

(* --- world --- *)

Pose::usage = "Pose[x, y, theta] is where the sensor is (m) and where it \
looks (radians).";
Segment::usage = "Segment[x0, y0, x1, y1] is a wall from (x0, y0) to \
(x1, y1), metres.";
BuildBoxWorld::usage = "BuildBoxWorld[xmin, ymin, xmax, ymax] gives the four \
walls of a rectangle, counterclockwise from the lower one (m).";
AddVerticalWall::usage = "AddVerticalWall[x, y0, y1] is a wall along y (m).";
AddHorizontalWall::usage = "AddHorizontalWall[y, x0, x1] is a wall along x \
(m).";
RaySegmentIntersection::usage = "RaySegmentIntersection[rx, ry, rdx, rdy, \
wall] gives the distances (m) at which rays from one point (m) along \
directions, two lists, meet a wall; Infinity where a ray is parallel or \
misses (lesson section 6).";
SimulateLidarScan::usage = "SimulateLidarScan[pose, walls, angles, zMax] \
gives the ranges (m) along a list of bearings (radians) from a pose; zMax \
for a beam that meets no wall within it (lesson section 6).";

(* --- sensor --- *)

RangeScan::usage = "RangeScan[pose, angles, ranges] is one scan: a Pose, \
the bearings of its beams (radians) and their ranges (m), two lists.";
BeamAngles::usage = "BeamAngles[fov, nBeams] gives the bearings (radians) of \
a simulated scan over fov radians.";
FlaserAngles::usage = "FlaserAngles[nBeams] gives the bearings (radians) of \
a FLASER scan: its step is known by its count.";
ReadRanges::usage = "ReadRanges[ranges, zMax, noReturn] says what ranges (m) \
mean: {z, hit, used}, three lists: the distance, True where something was \
hit, True where the beam counts. A range is a number, Infinity, or \
Indeterminate for a beam that is ignored; noReturn is \"free\" or \"ignore\" \
(lesson section 4, Problem 3).";
BeamEndpoints::usage = "BeamEndpoints[pose, angles, z] gives {list of x, \
list of y}, the world points (m) where beams of length z end.";
UpdateGridFromScan::usage = "UpdateGridFromScan[grid, scan, zMax, noReturn] \
updates the grid in the variable grid by the inverse sensor model: free along \
each beam, occupied at its hit (lesson section 4).";

(* --- scenario --- *)

NewGrid::usage = "NewGrid[settings] is the grid that a scenario starts with.";
ReadScenario::usage = "ReadScenario[path] gives the scenario in a file, an \
association: name, settings, walls (a list of Segment) and scans. A scan is a \
Pose where it is to be simulated, and a RangeScan where it was recorded; \
recorded ranges below settings[\"minRange\"] are Indeterminate. What breaks a \
rule of SPEC.md section 8 is thrown as the text FILE:LINE: REASON with the \
tag \"scenario\".";
ScenarioName::usage = "ScenarioName[path] is a scenario's name: its file name \
without the part from its last dot on.";
ReadNumber::usage = "ReadNumber[token] is the machine number that a token \
stands for, rounded correctly; Infinity, -Infinity, Indeterminate, or $Failed \
where it is no number (SPEC.md section 5.1).";

(* --- lesson --- *)

LessonSettings::usage = "LessonSettings[] gives the grid, inverse sensor \
model and simulated sensor of the lesson (section 6): an association with the \
keys of SPEC.md 5.2 as width, originX, maxRange, pOcc, ...";
LessonWorld::usage = "LessonWorld[] gives the walls of the lesson: a box of \
20 m x 16 m, a vertical and a horizontal wall in it.";
LessonPoses::usage = "LessonPoses[] gives 120 poses on an ellipse, the \
heading along it.";
LessonScenario::usage = "LessonScenario[] is the lesson as a scenario, named \
lesson.";

(* --- mapper --- *)

SimulatedScans::usage = "SimulatedScans[scenario, seed] gives the scans of a \
scenario as a list of RangeScan: recorded ones as they are, a bare pose \
simulated, with noise of that seed; without noise where seed is None.";
MapScenario::usage = "MapScenario[scenario, seed] maps all scans of a \
scenario, beam by beam, and gives the grid; without noise where seed is None.";

(* --- fast --- *)

ClipRay::usage = "ClipRay[gx0, gy0, gx1, gy1, width, height] gives {first, \
last}, the steps of a line that lie in a grid; {0, -1} where none does.";
UpdateGridFromScans::usage = "UpdateGridFromScans[grid, scans, zMax, \
noReturn] updates the grid in the variable grid with scans in order: the same \
bits as UpdateGridFromScan for each, in less time.";
MapScenarioFast::usage = "MapScenarioFast[scenario, seed] gives the same \
grid as MapScenario, in less time. MapScenarioFast[scenario, seed, progress] \
calls progress with the number of scans mapped so far, now and then.";

(* --- map_writer --- *)

Pixel::usage = "Pixel[logOdds] is the grey value of log-odds, a number or a \
list: 0 is occupied, 255 is free.";
MapPgm::usage = "MapPgm[grid] is the map as an ASCII PGM (P2), the row with \
the largest y first. MapPgm[grid, write] calls write with the text, a row at \
a time.";
MapYaml::usage = "MapYaml[grid, image] is the description that map_server \
and Nav2 read beside the picture, the file image.";
MapLogOdds::usage = "MapLogOdds[grid] is the map as text that reads back to \
the same doubles, the row with the smallest y first. MapLogOdds[grid, write] \
calls write with the text, a row at a time.";
WriteMap::usage = "WriteMap[folder, name, grid] writes NAME.pgm, NAME.yaml \
and NAME.logodds into a folder, which is made where it is missing: all three \
or none. What cannot be written is thrown as the text PATH: cannot be written \
with the tag \"output\".";

(* --- picture --- *)

MapPlot::usage = "MapPlot[grid] is the map as the lesson's ArrayPlot, for a \
notebook. (woxi does not know DataReversed and draws no ticks.)";
DrawMap::usage = "DrawMap[grid] is the same picture made of a Raster, which \
comes out alike everywhere.";

(* --- main --- *)

OccgridMain::usage = "OccgridMain[arguments] runs the command with a list of \
texts and gives its exit status (SPEC.md section 6).";
ScriptArguments::usage = "ScriptArguments[] gives the arguments of the \
script that runs: as wolfram.sh hands them over, else $ScriptCommandLine.";
$OccgridVersion::usage = "$OccgridVersion is the version of the port.";

OccupancyGrid::args = "`1` does not take these arguments; ?`1` says which.";

End[];
