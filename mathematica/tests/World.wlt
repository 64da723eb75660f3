wall = Segment[2., -1., 2., 1.];

VerificationTest[
  BuildBoxWorld[-1., -2., 3., 4.],
  {Segment[-1., -2., 3., -2.], Segment[3., -2., 3., 4.],
    Segment[3., 4., -1., 4.], Segment[-1., 4., -1., -2.]},
  TestID -> "a box"]
VerificationTest[
  {AddVerticalWall[1., 2., 3.], AddHorizontalWall[1., 2., 3.]},
  {Segment[1., 2., 1., 3.], Segment[2., 1., 3., 1.]},
  TestID -> "walls along the axes"]

VerificationTest[
  RaySegmentIntersection[0., 0., {1., -1., 0., 0.8, 0.6}, {0., 0., 1., 0.4,
    0.8}, wall],
  {2., Infinity, Infinity, 2.5, Infinity},
  TestID -> "hit, behind, parallel, at the end, beside"]
VerificationTest[
  RaySegmentIntersection[2., 0., {1., 0.}, {0., 1.}, wall],
  {0., Infinity},
  TestID -> "from the wall itself"]
VerificationTest[
  RaySegmentIntersection[0., 0., {1.*^-13, 1.*^-12}, {1., 1.},
    Segment[1., -1., 1., 0.]],
  {Infinity, Infinity},
  TestID -> "nearly parallel"]

VerificationTest[
  SimulateLidarScan[Pose[0., 0., 0.], {wall, Segment[1., -1., 1., 1.]},
    {0., 1.5707963267948966, 3.141592653589793}, 10.],
  {1., 10., 10.},
  TestID -> "the nearest wall, else the maximum"]
VerificationTest[
  {SimulateLidarScan[Pose[0., 0., 0.], {wall}, {0.}, 2.],
    SimulateLidarScan[Pose[0., 0., 0.], {wall}, {0.}, 1.5],
    SimulateLidarScan[Pose[0., 0., 0.], {}, {0., 1.}, 1.5]},
  {{2.}, {1.5}, {1.5, 1.5}},
  TestID -> "a wall at the maximum range, beyond it, none"]
