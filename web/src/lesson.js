/** The lesson, built in (lesson section 6): a robot drives an ellipse in a box with two inner walls. */

import { cos, PI, sin } from "./portableMath.js";
import { Scenario, Settings } from "./scenario.js";
import {
  addHorizontalWall,
  addVerticalWall,
  buildBoxWorld,
  Pose,
} from "./world.js";

// [snippet: lesson-settings]
/**
 * Grid, inverse sensor model and simulated sensor of the lesson.
 *
 * @returns {Settings}
 */
export function lessonSettings() {
  return new Settings({
    width: 220,
    height: 180,
    resolution: 0.1,
    originX: -11,
    originY: -9,
    maxRange: 10,
    p0: 0.5,
    pOcc: 0.75,
    pFree: 0.3,
    lMin: -8,
    lMax: 8,
    noReturn: "free",
    fov: PI,
    beams: 181,
    noiseStd: 0.02,
  });
}
// [/snippet]

// [snippet: lesson-world]
/**
 * A box of 20 m x 16 m, a vertical and a horizontal wall in it.
 *
 * @returns {import("./world.js").Segment[]}
 */
export function lessonWorld() {
  const walls = buildBoxWorld(-10, -8, 10, 8);
  walls.push(addVerticalWall(0, -6, 6));
  walls.push(addHorizontalWall(2, -8, -2));
  return walls;
}
// [/snippet]

// [snippet: lesson-poses]
/**
 * 120 poses on an ellipse, the heading along it.
 *
 * @returns {Pose[]} in order
 */
export function lessonPoses() {
  const poses = [];
  for (let t = 0; t < 120; t++) {
    const ang = 2 * PI * (t / 120);
    const x = -6 + 6 * cos(ang);
    const y = 0 + 4 * sin(ang);
    poses.push(new Pose(x, y, ang + PI / 2));
  }
  return poses;
}
// [/snippet]

/**
 * The lesson as a scenario, named `lesson`.
 *
 * @returns {Scenario}
 */
export function lessonScenario() {
  return new Scenario(
    "lesson",
    lessonSettings(),
    lessonWorld(),
    lessonPoses(),
  );
}
