"use strict";
/* The page's own script: unpacks the maps of a case, draws them, and reads out the cell under the mouse. */

const byId = (id) => document.getElementById(id);
const canvases = [byId("compare"), byId("difference")];
const unpacked = new Map();

/* state of the case that is shown */
let shown = null;           // what load() made
let port = 0;               // index of the chosen port
let view = null;            // {x, y, scale}: world of cells to canvas, y counted from the top row
let cursor = null;          // {gx, gy}
let drag = null;

async function inflate(text) {
  const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream).arrayBuffer();
}

/* The maps of a case: typed arrays; frames are differences from one to the next. */
async function load(number) {
  if (unpacked.has(number)) return unpacked.get(number);
  const script = byId(`data-${number}`);
  const data = JSON.parse(script.textContent);
  data.about = script.dataset.about;
  for (const map of data.maps) {
    map.pixels = new Uint8Array(await inflate(map.pixels));
    map.logOdds = map.logOdds === null ? null : new Float64Array(await inflate(map.logOdds));
    map.picture = picture(map.pixels, map.width, map.height);
  }
  if (data.frames) {
    const { width, height } = data.maps[0];
    const all = new Uint8Array(await inflate(data.frames.pixels));
    const size = width * height;
    for (let i = size; i < all.length; i++) all[i] ^= all[i - size];
    data.frames.pixels = data.frames.scans.map((_, k) => all.subarray(k * size, (k + 1) * size));
  }
  unpacked.set(number, data);
  return data;
}

/* A canvas of one map, a pixel for a cell. */
function picture(pixels, width, height, colour = (v) => [v, v, v]) {
  const canvas = document.createElement("canvas");
  canvas.width = width;
  canvas.height = height;
  const image = new ImageData(width, height);
  pixels.forEach((v, i) => image.data.set([...colour(v), 255], 4 * i));
  canvas.getContext("2d").putImageData(image, 0, 0);
  return canvas;
}

const expectedMap = () => shown.maps[0];
const foundMap = () => (shown.ports[port].map === null ? null : shown.maps[shown.ports[port].map]);

/* Which cells differ between the expected and the found map, in any bit of their log-odds or in their pixel. */
function differences() {
  const expected = expectedMap();
  const found = foundMap();
  if (!found || found === expected || found.width !== expected.width || found.height !== expected.height) return [];
  const { width, height } = expected;
  const bits = expected.logOdds && found.logOdds;   // else the pixels are all there is to compare
  const list = [];
  for (let row = 0; row < height; row++) {
    const gy = height - 1 - row;
    for (let gx = 0; gx < width; gx++) {
      const i = gy * width + gx;
      const differs = (bits && !Object.is(expected.logOdds[i], found.logOdds[i]))
        || expected.pixels[row * width + gx] !== found.pixels[row * width + gx];
      if (differs) list.push({ gx, gy });
    }
  }
  return list;
}

async function showCase(number, portIndex) {
  shown = await load(number);
  port = portIndex;
  cursor = null;
  const chosen = shown.ports[port];
  byId("case").hidden = false;
  byId("case-title").textContent = `${shown.scenario}, ${shown.mode}: ${chosen.name}`;
  byId("case-about").textContent = shown.about;
  byId("case-words").textContent = chosen.words.join("\n");
  byId("viewer").hidden = shown.maps.length === 0;
  document.querySelectorAll(".status.chosen").forEach((b) => b.classList.remove("chosen"));
  document.querySelector(`[data-case="${number}"][data-port="${portIndex}"]`).classList.add("chosen");
  if (shown.maps.length === 0) return;
  shown.differing = differences();
  const { width, height } = expectedMap();
  const marks = new Uint8Array(width * height);
  for (const { gx, gy } of shown.differing) marks[(height - 1 - gy) * width + gx] = 1;
  shown.marks = picture(marks, width, height, (v) => (v ? [200, 30, 20] : [236, 238, 241]));
  const found = foundMap();
  byId("found-name").textContent = found ? `found (${chosen.name})` : "found (no map)";
  byId("difference-count").textContent = !found
    ? "no map to compare"
    : found.width !== width || found.height !== height
      ? `another size: ${found.width} x ${found.height}, expected ${width} x ${height}`
      : `${shown.differing.length} of ${width * height} cells differ`;
  byId("next-difference").disabled = shown.differing.length === 0;
  const scrubber = byId("scrubber");
  scrubber.disabled = !shown.frames;
  scrubber.max = shown.frames ? shown.frames.scans.length - 1 : 0;
  scrubber.value = scrubber.max;
  wholeMap();
  readOut();
}

function frameIndex() {
  return shown.frames ? Number(byId("scrubber").value) : null;
}

const isLastFrame = () => frameIndex() === null || frameIndex() === shown.frames.scans.length - 1;

function wholeMap() {
  const { width, height } = expectedMap();
  for (const canvas of canvases) {
    const box = canvas.clientWidth || 600;
    canvas.width = Math.round(box * devicePixelRatio);
    canvas.height = Math.round(canvas.width * Math.min(1.2, Math.max(0.4, height / width)));
    canvas.style.aspectRatio = `${canvas.width} / ${canvas.height}`;
  }
  const scale = Math.min(canvases[0].width / width, canvases[0].height / height);
  view = { x: (canvases[0].width - scale * width) / 2, y: (canvases[0].height - scale * height) / 2, scale };
  draw();
}

function draw() {
  const { width, height } = expectedMap();
  const [compare, difference] = canvases.map((canvas) => canvas.getContext("2d"));
  const place = (context, image) => {
    context.imageSmoothingEnabled = false;
    context.drawImage(image, view.x, view.y, width * view.scale, height * view.scale);
  };
  const expected = isLastFrame() ? expectedMap().picture : framePicture(frameIndex());
  const found = foundMap();
  compare.clearRect(0, 0, compare.canvas.width, compare.canvas.height);
  place(compare, expected);
  const split = Math.round((compare.canvas.width * Number(byId("slider").value)) / 100);
  if (found && isLastFrame()) {
    compare.save();
    compare.beginPath();
    compare.rect(split, 0, compare.canvas.width - split, compare.canvas.height);
    compare.clip();
    compare.clearRect(split, 0, compare.canvas.width - split, compare.canvas.height);
    place(compare, found.picture);
    compare.restore();
    compare.fillStyle = "#1a56b8";
    compare.fillRect(split - 1, 0, 2, compare.canvas.height);
  }
  difference.clearRect(0, 0, difference.canvas.width, difference.canvas.height);
  place(difference, shown.marks);
  if (cursor) {
    for (const context of [compare, difference]) {
      context.strokeStyle = "#1a56b8";
      context.lineWidth = 2;
      const size = Math.max(view.scale, 4);
      context.strokeRect(view.x + cursor.gx * view.scale, view.y + (height - 1 - cursor.gy) * view.scale, size, size);
    }
  }
  const scans = shown.frames ? shown.frames.scans[frameIndex()] : null;
  byId("scrubber-value").textContent = scans === null ? "" : `${scans} of ${shown.frames.total}`;
}

function framePicture(k) {
  const { width, height } = expectedMap();
  return picture(shown.frames.pixels[k], width, height);
}

/* The numbers of the cell under the cursor, of every port. */
function readOut() {
  const body = document.querySelector("#readout tbody");
  body.replaceChildren();
  if (!cursor) {
    byId("readout-cell").textContent = "Point at a cell.";
    return;
  }
  const { gx, gy } = cursor;
  let where = `cell gx=${gx} gy=${gy}`;
  if (shown.origin) {
    const x = shown.origin[0] + (gx + 0.5) * shown.resolution;
    const y = shown.origin[1] + (gy + 0.5) * shown.resolution;
    where += `, centre (${x.toFixed(3)} m, ${y.toFixed(3)} m)`;
  }
  byId("readout-cell").textContent = where;
  if (!isLastFrame()) {
    const { width, height } = expectedMap();
    const pixel = shown.frames.pixels[frameIndex()][(height - 1 - gy) * width + gx];
    addRow(body, [`expected after scan ${shown.frames.scans[frameIndex()]}`, "", "", String(pixel)], false);
  }
  const expected = values(expectedMap(), gx, gy);
  for (const { name, map } of shown.ports) {
    const own = map === null ? ["", "", "no map"] : values(shown.maps[map], gx, gy);
    addRow(body, [name, ...own], map !== null && differ(own, expected));
  }
}

function values(map, gx, gy) {
  if (gx >= map.width || gy >= map.height) return ["", "", "outside"];
  const pixel = String(map.pixels[(map.height - 1 - gy) * map.width + gx]);
  if (!map.logOdds) return ["", "", pixel];
  const l = map.logOdds[gy * map.width + gx];
  const z = Math.exp(-Math.abs(l));
  const p = (l >= 0 ? 1 : z) / (1 + z);
  return [String(l), p.toFixed(6), pixel];
}

/* Whether two readings differ in what both of them say. */
function differ(a, b) {
  return a.some((text, i) => text !== "" && b[i] !== "" && text !== b[i]);
}

function addRow(body, cells, other) {
  const row = body.insertRow();
  if (other) row.className = "other";
  const head = document.createElement("th");
  head.scope = "row";
  head.textContent = cells[0];
  row.append(head);
  for (const text of cells.slice(1)) row.insertCell().textContent = text;
}

function moveTo(gx, gy) {
  const { width, height } = expectedMap();
  cursor = { gx: Math.min(width - 1, Math.max(0, gx)), gy: Math.min(height - 1, Math.max(0, gy)) };
  draw();
  readOut();
}

/* Canvas position of a mouse event, in the canvas's own pixels. */
function position(event) {
  const box = event.target.getBoundingClientRect();
  const factor = event.target.width / box.width;
  return { x: (event.clientX - box.left) * factor, y: (event.clientY - box.top) * factor };
}

function zoom(factor, x = canvases[0].width / 2, y = canvases[0].height / 2) {
  const { width, height } = expectedMap();
  const least = Math.min(canvases[0].width / width, canvases[0].height / height) / 2;
  const scale = Math.min(80 * devicePixelRatio, Math.max(least, view.scale * factor));
  view = { x: x - ((x - view.x) * scale) / view.scale, y: y - ((y - view.y) * scale) / view.scale, scale };
  draw();
}

/* Brings a cell into the middle, large enough to see. */
function lookAt(gx, gy) {
  const { height } = expectedMap();
  view = { ...view, scale: Math.max(view.scale, 16 * devicePixelRatio) };
  view.x = canvases[0].width / 2 - (gx + 0.5) * view.scale;
  view.y = canvases[0].height / 2 - (height - 1 - gy + 0.5) * view.scale;
  moveTo(gx, gy);
}

for (const canvas of canvases) {
  canvas.addEventListener("pointermove", (event) => {
    const at = position(event);
    if (drag) {
      view = { ...view, x: drag.x + at.x, y: drag.y + at.y };
      draw();
      return;
    }
    const { width, height } = expectedMap();
    const gx = Math.floor((at.x - view.x) / view.scale);
    const row = Math.floor((at.y - view.y) / view.scale);
    if (gx >= 0 && gx < width && row >= 0 && row < height) moveTo(gx, height - 1 - row);
  });
  canvas.addEventListener("pointerdown", (event) => {
    const at = position(event);
    drag = { x: view.x - at.x, y: view.y - at.y };
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointerup", () => { drag = null; });
  canvas.addEventListener("pointercancel", () => { drag = null; });
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    const at = position(event);
    zoom(event.deltaY < 0 ? 1.25 : 0.8, at.x, at.y);
  }, { passive: false });
}
byId("compare").addEventListener("keydown", (event) => {
  const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
  if (!step) return;
  event.preventDefault();
  const from = cursor || { gx: 0, gy: 0 };
  moveTo(from.gx + step[0], from.gy + step[1]);
});
byId("slider").addEventListener("input", draw);
byId("scrubber").addEventListener("input", () => { draw(); readOut(); });
byId("zoom-in").addEventListener("click", () => zoom(1.6));
byId("zoom-out").addEventListener("click", () => zoom(0.625));
byId("zoom-all").addEventListener("click", wholeMap);
byId("next-difference").addEventListener("click", () => {
  const list = shown.differing;
  const at = cursor ? list.findIndex((cell) => cell.gx === cursor.gx && cell.gy === cursor.gy) : -1;
  const next = list[(at + 1) % list.length];
  lookAt(next.gx, next.gy);
});
byId("only-failed").addEventListener("change", (event) => {
  byId("matrix").classList.toggle("only-failed", event.target.checked);
  byId("nothing-failed").hidden = !event.target.checked || document.querySelector("tr.failed") !== null;
});
document.querySelectorAll(".status").forEach((button) => {
  button.addEventListener("click", async () => {
    await showCase(Number(button.dataset.case), Number(button.dataset.port));
    byId("case").scrollIntoView({ block: "start" });
  });
});
window.addEventListener("resize", () => { if (shown && shown.maps.length) wholeMap(); });

/* What the page has found first, where it says so: a case, a port and a cell. */
async function showStart() {
  const { number, port, gx, gy } = JSON.parse(document.body.dataset.start);
  await showCase(number, port);
  lookAt(gx, gy);
}

/* else the first failure is what people come for; without one, the first case */
if (document.body.dataset.start) {
  showStart();
  byId("show-start").addEventListener("click", async () => {
    await showStart();
    byId("case").scrollIntoView({ block: "start" });
  });
} else {
  const first = document.querySelector("tr.failed .status.bad") || document.querySelector(".status");
  if (first) showCase(Number(first.dataset.case), Number(first.dataset.port));
}
