#!/usr/bin/env node
/** The command `occgrid` (SPEC.md section 6). */

import { main } from "./src/node/main.js";

process.exitCode = await main();
