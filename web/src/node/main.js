/** The command line (SPEC.md section 6). */

import { mapScenarioFast } from "../fast.js";
import { lessonScenario } from "../lesson.js";
import { mapScenario } from "../mapper.js";
import { mapPgm } from "../mapWriter.js";
import { readScenario, ScenarioError } from "../scenario.js";
import { fileSource } from "./fileSource.js";
import { parseOptions, UsageError, usageText } from "./options.js";
import { complain, print, WriteError } from "./output.js";
import { byteArguments } from "./paths.js";
import { writeMap } from "./writeMap.js";

/**
 * Runs the command.
 *
 * @param {string[]} given the arguments, a character for each byte
 * @returns {Promise<number>} the exit status: 0, 1 for bad input or output, 2 for bad usage
 */
export async function main(given = byteArguments()) {
  try {
    const options = parseOptions(given);
    if (options.text !== "") {
      print([options.text]);
      return 0;
    }
    if (options.scenarios.length === 0) {
      await mapOne(lessonScenario(), options);
    }
    for (const path of options.scenarios) {
      await mapOne(readScenario(fileSource(path)), options);
    }
    return 0;
  } catch (error) {
    if (error instanceof UsageError) {
      complain(usageText(error));
      return 2;
    }
    if (error instanceof ScenarioError || error instanceof WriteError) {
      complain(`${error.message}\n`);
      return 1;
    }
    throw error;
  }
}

/**
 * Maps one scenario and writes what was asked for.
 *
 * @param {import("../scenario.js").Scenario} scenario
 * @param {import("./options.js").Options} options
 */
async function mapOne(scenario, { seed, plain, out }) {
  const grid = plain
    ? mapScenario(scenario, seed)
    : mapScenarioFast(scenario, seed);
  if (out === null) print(mapPgm(grid));
  else await writeMap(out, scenario.name, grid);
}
