/**
 * Makes the pages, each a single file without anything from elsewhere: `node build.mjs [FOLDER]`, by default
 * build/handouts.
 */

import { mkdirSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const root = dirname(here);
const PAGES = ["play", "check"];
const MOST_BYTES = 500000;

/** What docs/mistakes.md says of each mistake. */
function catalogue() {
  const text = readFileSync(join(root, "docs/mistakes.md"), "utf8");
  const entries = text.matchAll(
    /^\*\*(.+)\*\* \(`(.+)`\) *\n(.+?) \*Lesson: (.+)\.\*$/gm,
  );
  return Object.fromEntries(
    Array.from(entries, ([, title, name, lesson, where]) => [
      name,
      { title, lesson: `${lesson} (Lesson: ${where}.)` },
    ]),
  );
}

/** The scenario files, by name, the lesson first. */
function offered() {
  const names = readdirSync(join(root, "scenarios"))
    .filter((name) => name.endsWith(".log"))
    .map((name) => name.slice(0, -4))
    .sort((a, b) => Number(b === "lesson") - Number(a === "lesson"));
  return Object.fromEntries(
    names.map((name) => [
      name,
      readFileSync(join(root, `scenarios/${name}.log`), "ascii"),
    ]),
  );
}

/** @type {import("esbuild").Plugin} */
const imports = {
  name: "texts",
  setup(esbuild) {
    esbuild.onResolve({ filter: /^text:/ }, ({ path, resolveDir }) => ({
      path: resolve(resolveDir, path.slice("text:".length)),
      namespace: "text",
    }));
    esbuild.onLoad({ filter: /.*/, namespace: "text" }, ({ path }) => ({
      contents: readFileSync(path, "utf8"),
      loader: "text",
      watchFiles: [path],
    }));
    esbuild.onResolve({ filter: /^worker:/ }, ({ path, resolveDir }) => ({
      path: resolve(resolveDir, path.slice("worker:".length)),
      namespace: "worker",
    }));
    esbuild.onLoad(
      { filter: /.*/, namespace: "worker" },
      async ({ path }) => ({ contents: await bundle(path), loader: "text" }),
    );
    for (const [name, made] of Object.entries({
      "docs:mistakes": catalogue,
      "scenarios:offered": offered,
    })) {
      esbuild.onResolve({ filter: new RegExp(`^${name}$`) }, () => ({
        path: name,
        namespace: "made",
      }));
      esbuild.onLoad(
        { filter: new RegExp(`^${name}$`), namespace: "made" },
        () => ({
          contents: JSON.stringify(made()),
          loader: "json",
        }),
      );
    }
  },
};

/** A program and all that it imports, as one script. @param {string} path @returns {Promise<string>} */
async function bundle(path) {
  const result = await build({
    entryPoints: [path],
    bundle: true,
    minify: true,
    charset: "utf8",
    format: "iife",
    target: ["chrome100", "firefox100", "safari15"],
    write: false,
    plugins: [imports],
    logLevel: "warning",
  });
  return result.outputFiles[0].text;
}

/** @param {string} page */
async function makePage(page) {
  const read = (/** @type {string} */ path) =>
    readFileSync(join(here, "pages", path), "utf8");
  const program = await bundle(join(here, `pages/${page}/main.js`));
  const script = program.replaceAll("</script", "<\\/script");
  return read(`${page}/page.html`)
    .replace(
      "<!-- style -->",
      () =>
        `<style>\n${read("shared/style.css")}${read(`${page}/style.css`)}</style>`,
    )
    .replace("<!-- script -->", () => `<script>${script}</script>`);
}

const folder = resolve(process.argv[2] ?? join(root, "build/handouts"));
mkdirSync(folder, { recursive: true });
for (const page of PAGES) {
  const text = await makePage(page);
  const bytes = Buffer.byteLength(text);
  if (bytes >= MOST_BYTES) throw new Error(`${page}.html has ${bytes} bytes`);
  writeFileSync(join(folder, `${page}.html`), text);
  console.log(`${join(folder, page)}.html: ${bytes} bytes`);
}
