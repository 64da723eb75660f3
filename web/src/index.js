/** Occupancy grid mapping in JavaScript, the same bits in every language. SPEC.md is the contract behind it. */

export { clipRay, mapScenarioFast, updateGridFromScans } from "./fast.js";
export { GridSpec, logit, OccupancyGrid, sigmoid } from "./grid.js";
export {
  lessonPoses,
  lessonScenario,
  lessonSettings,
  lessonWorld,
} from "./lesson.js";
export { memorySource } from "./lines.js";
export { mapScenario, simulatedScans } from "./mapper.js";
export { mapLogOdds, mapPgm, mapYaml, pixel } from "./mapWriter.js";
export { addRangeNoise, normalDeviate, philox4x32 } from "./noise.js";
export { cos, exp, log, PI, sin } from "./portableMath.js";
export { bresenham } from "./ray.js";
export {
  newGrid,
  readScenario,
  Scenario,
  ScenarioError,
  Settings,
  scenarioName,
} from "./scenario.js";
export {
  beamAngles,
  beamEndpoints,
  flaserAngles,
  readRanges,
  Scan,
  updateGridFromScan,
} from "./sensor.js";
export {
  addHorizontalWall,
  addVerticalWall,
  buildBoxWorld,
  Pose,
  raySegmentIntersection,
  Segment,
  simulateLidarScan,
} from "./world.js";
