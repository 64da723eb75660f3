/** The command line, the files it writes, and what is left when it cannot. */

import assert from "node:assert/strict";
import { spawn, spawnSync } from "node:child_process";
import {
  existsSync,
  mkdirSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  rmSync,
  utimesSync,
  writeFileSync,
} from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { setTimeout } from "node:timers/promises";
import { fileURLToPath } from "node:url";

const PROGRAM = fileURLToPath(new URL("../occgrid", import.meta.url));
const SCENARIOS = new URL("../../scenarios/", import.meta.url);
const BEAM = fileURLToPath(new URL("one-beam.log", SCENARIOS));

/**
 * Runs a test in a folder of its own.
 *
 * @param {string} name
 * @param {(folder: string) => void | Promise<void>} body
 */
function inFolder(name, body) {
  test(name, async () => {
    const folder = mkdtempSync(join(tmpdir(), "occgrid-web-"));
    try {
      await body(folder);
    } finally {
      rmSync(folder, { recursive: true });
    }
  });
}

/**
 * @param {string} folder
 * @param {string} script what the shell runs; "$@" is the program
 */
function shell(folder, script) {
  const { status, stdout, stderr } = spawnSync(
    "sh",
    ["-c", script, "sh", PROGRAM],
    { cwd: folder, encoding: "latin1" },
  );
  return { status, stdout, stderr };
}

/** @param {string} folder @param {string[]} given */
function run(folder, ...given) {
  const { status, stdout, stderr } = spawnSync(PROGRAM, given, {
    cwd: folder,
    encoding: "latin1",
    maxBuffer: 1 << 26,
  });
  return { status, stdout, stderr };
}

/** @param {string} message */
const failed = (message) => ({
  status: 1,
  stdout: "",
  stderr: `${message}\n`,
});

inFolder("both paths print the same picture", (folder) => {
  const golden = readFileSync(
    new URL("golden/lesson.seed-0.pgm", SCENARIOS),
    "latin1",
  );
  for (const given of [[], ["--plain"], ["--seed", "00000000000000000000"]]) {
    const { status, stdout, stderr } = run(folder, ...given);
    assert.deepEqual([status, stderr], [0, ""]);
    assert.ok(stdout === golden, given.join(" "));
  }
});

const USAGE = {
  "-": "unknown option -",
  "--": "unknown option --",
  "-5": "unknown option -5",
  "--seed=7": "unknown option --seed=7",
  "--seed": "--seed needs a value",
  "--out --noise-free a.log": "--out needs a value",
  "--seed 4294967296":
    "--seed needs a whole number from 0 to 4294967295, not '4294967296'",
  "--seed -5": "--seed needs a whole number from 0 to 4294967295, not '-5'",
  "--bogus --help": "unknown option --bogus",
  "--seed 1 --noise-free": "--noise-free and --seed exclude each other",
  "a.log b.log": "several scenarios need --out",
  "--out o d/a.log d/a": "two scenarios are named a",
  "--out o a.log a/": "two scenarios are named a",
};
for (const [line, reason] of Object.entries(USAGE)) {
  inFolder(`usage: ${line}`, (folder) => {
    const { status, stdout, stderr } = run(folder, ...line.split(" "));
    assert.deepEqual([status, stdout], [2, ""]);
    assert.ok(stderr.startsWith(`occgrid: ${reason}\nusage: `), stderr);
    assert.deepEqual(readdirSync(folder), []);
  });
}

inFolder("empty arguments", (folder) => {
  assert.equal(run(folder, "--out", "").status, 2);
  assert.deepEqual(run(folder, ""), failed(":0: cannot be read"));
});

inFolder("--help and --version act where they are read", (folder) => {
  assert.equal(run(folder, "--help", "--bogus").status, 0);
  assert.match(
    run(folder, "--version").stdout,
    /^occgrid 1\.0\.0 \(Node.*\)\n$/,
  );
});

inFolder("what cannot be read", (folder) => {
  mkdirSync(join(folder, "d"));
  for (const path of ["none.log", "d", "d/", `${BEAM}/`, "/proc/self/mem"]) {
    const { status, stderr } = run(folder, path);
    assert.deepEqual([status, stderr], [1, `${path}:0: cannot be read\n`]);
  }
});

inFolder("names may have any bytes", (folder) => {
  const made = shell(
    folder,
    `n=$(printf 'a\\377 \\n"'); mkdir "$n" && cp ${BEAM} "$n.log" && "$@" --out "$n/" "$n.log"`,
  );
  assert.deepEqual(made, { status: 0, stdout: "", stderr: "" });
  const shown = shell(folder, "ls -b */*.yaml; head -1 */*.yaml");
  assert.equal(
    shown.stdout,
    'a\\377\\ \\n"/a\\377\\ \\n".yaml\nimage: "a\xff \\x0A\\".pgm"\n',
  );
  const missing = shell(folder, `"$@" "$(printf 'x\\377\\001y')"`);
  assert.equal(missing.stderr, "x\xff?y:0: cannot be read\n");
});

inFolder("a name as long as the system accepts", (folder) => {
  const name = "n".repeat(247); // and .logodds make 255
  assert.equal(shell(folder, `cp ${BEAM} ${name}`).status, 0);
  assert.deepEqual(run(folder, "--out", "o", name).stderr, "");
  assert.equal(readdirSync(join(folder, "o")).length, 3);
  const { stderr } = shell(
    folder,
    `cp ${BEAM} ${name}n.x; "$@" --out p ${name}n.x`,
  );
  assert.equal(stderr, `p/${name}n.logodds: cannot be written\n`);
  assert.deepEqual(readdirSync(join(folder, "p")), []);
});

for (const suffix of ["pgm", "yaml", "logodds"]) {
  inFolder(`a folder in the place of NAME.${suffix}`, (folder) => {
    const inTheWay = `one-beam.${suffix}`;
    mkdirSync(join(folder, "o", inTheWay), { recursive: true });
    const expected = failed(`./o//${inTheWay}: cannot be written`);
    assert.deepEqual(run(folder, "--out", "./o///", BEAM), {
      ...expected,
      stderr: `./o/${inTheWay}: cannot be written\n`,
    });
    assert.deepEqual(readdirSync(join(folder, "o")), [inTheWay]);
  });
}

inFolder("paths of outputs that fail", (folder) => {
  writeFileSync(join(folder, "f"), "");
  const line = (/** @type {string} */ out) => run(folder, "--out", out, BEAM);
  assert.deepEqual(line("f"), failed("f: cannot be written"));
  assert.deepEqual(line("f//"), failed("f: cannot be written"));
  assert.deepEqual(line("./f//q/"), failed("./f//q: cannot be written"));
  const full = shell(folder, `ulimit -f 0; "$@" --out q ${BEAM}`);
  assert.deepEqual(full, failed("q/one-beam.pgm: cannot be written"));
  assert.deepEqual(readdirSync(join(folder, "q")), []);
});

for (const [output, script] of Object.entries({
  full: '"$@" > /dev/full',
  closed: '"$@" >&-',
  "a closed pipe": '{ "$@"; echo $? > status; } | true; exit $(cat status)',
})) {
  inFolder(`standard output is ${output}`, (folder) => {
    for (const option of output === "full"
      ? ["", "--help", "--version"]
      : [""]) {
      const line = script.replace('"$@"', `"$@" ${option}`);
      const expected = failed("standard output: cannot be written");
      // the pipe's other end may not be closed yet at the first write
      assert.deepEqual(shell(folder, line), expected);
    }
  });
}

inFolder("temporary files of killed runs, after a day", (folder) => {
  const old = ".occgrid-1-Z9.part";
  const others = [".occgrid-new.part", ".occgrid-a_b.part", "occgrid-1.part"];
  for (const name of [old, ...others]) writeFileSync(join(folder, name), "");
  const yesterday = Date.now() / 1000 - 24 * 3600 - 60;
  for (const name of [old, ...others.slice(1)]) {
    utimesSync(join(folder, name), yesterday, yesterday);
  }
  assert.equal(run(folder, "--out", ".", BEAM).status, 0);
  const left = readdirSync(folder).filter((name) => name.includes("part"));
  assert.deepEqual(left.sort(), others.sort());
});

for (const signal of /** @type {const} */ (["SIGINT", "SIGTERM"])) {
  inFolder(`${signal} leaves no temporary file`, async (folder) => {
    // large, so that writing takes a while
    const lines = ["width 3000", "height 3000", "resolution 1", "origin_x 0"];
    const text = [...lines, "origin_y 0", "max_range 1"]
      .map((line) => `PARAM occgrid_${line}\n`)
      .join("");
    writeFileSync(join(folder, "a.log"), `${text}POSE 1 1 0\n`);
    const child = spawn(PROGRAM, ["--out", "o", "a.log"], { cwd: folder });
    const ended = new Promise((resolve) => {
      child.on("exit", (_, by) => resolve(by));
    });
    const parts = () =>
      existsSync(join(folder, "o"))
        ? readdirSync(join(folder, "o")).filter((name) =>
            name.endsWith("part"),
          )
        : [];
    while (parts().length === 0 && child.exitCode === null) {
      await setTimeout(5);
    }
    assert.notDeepEqual(parts(), []);
    child.kill(signal);
    assert.equal(await ended, signal);
    assert.deepEqual(readdirSync(join(folder, "o")), []);
  });
}

inFolder("a pipe can be mapped", (folder) => {
  const { status, stdout } = shell(folder, `cat ${BEAM} | "$@" /dev/stdin`);
  assert.equal(status, 0);
  assert.ok(stdout.startsWith("P2\n"));
});
