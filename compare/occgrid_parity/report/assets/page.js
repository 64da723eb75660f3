"use strict";
/* The page's own script: unpacks the maps of a case, draws them, and reads out the cell under the mouse. */

const byId = (id) => document.getElementById(id);
const canvases = [byId("compare"), byId("difference")];
const unpacked = new Map();

const start = document.body.dataset.start ? JSON.parse(document.body.dataset.start) : null;

/* space for the axes: pixels of the page */
const LEFT = 44;
const BOTTOM = 22;

/* state of the case that is shown */
let shown = null;           // what load() made
let chosen = 0;             // index of the case
let port = 0;               // index of the chosen port
let now = null;             // what is drawn: {expected, found, differing, marks}
let view = null;            // {x, y, scale}: world of cells to canvas, y counted from the top row
let cursor = null;          // {gx, gy}
let drag = null;

async function inflate(text) {
  const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream).arrayBuffer();
}

/* What a case holds, as text still. */
function read(number) {
  if (!unpacked.has(number)) {
    const script = byId(`data-${number}`);
    unpacked.set(number, { ...JSON.parse(script.textContent), about: script.dataset.about, ready: false });
  }
  return unpacked.get(number);
}

/* A map's pixels, and its picture. */
async function unpackPicture(map) {
  if (map.picture) return;
  map.pixels = new Uint8Array(await inflate(map.pixels));
  map.picture = picture(map.pixels, map.width, map.height);
}

/* The maps of a case: typed arrays; frames are differences from one to the next. */
async function load(number) {
  const data = read(number);
  if (data.ready) return data;
  for (const map of data.maps) {
    await unpackPicture(map);
    if (map.logOdds !== null) map.logOdds = new Float64Array(await inflate(map.logOdds));
  }
  if (data.frames) {
    const { width, height } = data.maps[0];
    const all = new Uint8Array(await inflate(data.frames.pixels));
    const size = width * height;
    for (let i = size; i < all.length; i++) all[i] ^= all[i - size];
    data.frames.pixels = data.frames.scans.map((_, k) => all.subarray(k * size, (k + 1) * size));
  }
  data.ready = true;
  return data;
}

/* Draws a map small; pixels stay squares. */
function drawSmall(canvas, map) {
  canvas.width = map.width;
  canvas.height = map.height;
  canvas.getContext("2d").drawImage(map.picture, 0, 0);
}

async function drawThumbs() {
  for (const button of document.querySelectorAll("#thumbs .thumb")) {
    const data = read(Number(button.dataset.case));
    const own = data.ports[Number(button.dataset.port)].map;
    const map = data.maps[own === null ? 0 : own];
    if (!map) continue;
    await unpackPicture(map);
    drawSmall(button.querySelector("canvas"), map);
  }
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

/* Which cells differ between two maps, in any bit of their log-odds or in their pixel. */
function differences(expected, found) {
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

/* What the scrubber stands on: the expected map and the program's, which is drawn after the last scan, and after others
   only where the check has run the program on the first scans. */
function look() {
  const last = isLastFrame();
  const { width, height } = expectedMap();
  let expected = expectedMap();
  let found = foundMap();
  if (!last) {
    const k = frameIndex();
    const pixels = shown.frames.pixels[k];
    expected = { width, height, pixels, logOdds: null, picture: picture(pixels, width, height) };
    const partial = shown.partial[shown.frames.scans[k]];
    found = partial === undefined || found === expectedMap() ? null : shown.maps[partial];
  }
  const differing = differences(expected, found);
  const marks = new Uint8Array(width * height);
  for (const { gx, gy } of differing) marks[(height - 1 - gy) * width + gx] = 1;
  now = { expected, found, differing, marks: picture(marks, width, height, (v) => colourOf(v ? "--mark" : "--blank")) };
  const name = shown.ports[port].name;
  byId("found-name").textContent = found ? `found (${name})` : "found (no map)";
  byId("compare-caption").textContent = found ? "Expected left of the line, found right of it." : "Expected.";
  byId("difference-count").textContent = !found
    ? last ? "no map to compare" : `no map of ${name} after ${scansMapped()}${otherMaps()}`
    : found.width !== width || found.height !== height
      ? `another size: ${found.width} x ${found.height}, expected ${width} x ${height}`
      : `${differing.length} of ${width * height} cells ${differing.length === 1 ? "differs" : "differ"}`;
  byId("next-difference").disabled = differing.length === 0;
}

/* After how many scans there is a map of the program, where there are several. */
function otherMaps() {
  const counts = Object.keys(shown.partial);
  return foundMap() && counts.length ? `; there is one after ${[...counts, shown.frames.total].join(", ")}` : "";
}

/* A colour of the style sheet as red, green, blue. */
function colourOf(name) {
  const text = style(name);
  return [1, 3, 5].map((i) => parseInt(text.slice(i, i + 2), 16));
}

const style = (name) => {
  const text = getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  return text.length === 4 ? text.replace(/[0-9a-f]/gi, "$&$&") : text;
};

/* The maps of all ports side by side. */
function showPorts() {
  byId("ports").replaceChildren(...shown.ports.map(({ name, map, shown: word, tone }, index) => {
    const item = document.createElement("li");
    const button = document.createElement("button");
    button.type = "button";
    button.className = `thumb ${tone}`;
    button.setAttribute("aria-pressed", String(index === port));
    button.classList.toggle("chosen", index === port);
    if (map !== null) {
      const canvas = document.createElement("canvas");
      canvas.setAttribute("aria-hidden", "true");
      drawSmall(canvas, shown.maps[map]);
      button.append(canvas);
    }
    for (const [text, kind] of [[name, ""], [word, "word"]]) {
      const span = document.createElement("span");
      span.className = kind;
      span.textContent = text;
      button.append(span);
    }
    button.addEventListener("click", () => showCase(chosen, index));
    item.append(button);
    return item;
  }));
}

async function showCase(number, portIndex) {
  shown = await load(number);
  chosen = number;
  port = portIndex;
  cursor = null;
  const its = shown.ports[port];
  byId("case").hidden = false;
  byId("case-title").textContent = `${shown.scenario}, ${shown.mode}: ${its.name}`;
  byId("case-about").textContent = shown.about;
  byId("case-words").textContent = its.words.join("\n");
  byId("viewer").hidden = shown.maps.length === 0;
  document.querySelectorAll(":is(.status, #thumbs .thumb).chosen").forEach((b) => b.classList.remove("chosen"));
  document.querySelector(`.status[data-case="${number}"][data-port="${portIndex}"]`).classList.add("chosen");
  document.querySelector(`#thumbs [data-case="${number}"]`).classList.add("chosen");
  showPorts();
  if (shown.maps.length === 0) return;
  document.querySelector(".key.wall").hidden = shown.walls.length === 0;
  document.querySelector(".key.beam").hidden = !beamStart();
  const scrubber = byId("scrubber");
  scrubber.disabled = !shown.frames;
  scrubber.max = shown.frames ? shown.frames.scans.length - 1 : 0;
  scrubber.value = firstWrongFrame() ?? scrubber.max;
  look();
  wholeMap();
  readOut();
}

/* The first difference, where the map that is shown is the one in which it was found. */
const beamStart = () => (start && start.number === chosen && start.end && start.robot ? start : null);

/* The picture after the scan of the first difference, where there is a map of the program to compare with. */
function firstWrongFrame() {
  if (!shown.frames || !start || start.number !== chosen || start.scan === undefined) return null;
  const scans = start.scan + 1;
  const drawn = scans === shown.frames.total || shown.partial[scans] !== undefined;
  return drawn ? shown.frames.scans.indexOf(scans) : null;
}

function frameIndex() {
  return shown.frames ? Number(byId("scrubber").value) : null;
}

/* How many scans the map on the left is made of, in words. */
function scansMapped() {
  const count = shown.frames.scans[frameIndex()];
  return `${count} ${count === 1 ? "scan" : "scans"}`;
}

const isLastFrame = () => frameIndex() === null || frameIndex() === shown.frames.scans.length - 1;

function wholeMap() {
  const { width, height } = expectedMap();
  const left = LEFT * devicePixelRatio;
  const bottom = BOTTOM * devicePixelRatio;
  for (const canvas of canvases) {
    const box = canvas.clientWidth || 600;
    canvas.width = Math.round(box * devicePixelRatio);
    const inner = (canvas.width - left) * Math.min(1.2, Math.max(0.4, height / width));
    canvas.height = Math.round(inner + bottom);
    canvas.style.aspectRatio = `${canvas.width} / ${canvas.height}`;
  }
  const across = canvases[0].width - left;
  const up = canvases[0].height - bottom;
  const scale = Math.min(across / width, up / height);
  view = { x: left + (across - scale * width) / 2, y: (up - scale * height) / 2, scale };
  draw();
}

/* Canvas position of a point in metres. */
function toCanvas(x, y) {
  const [ox, oy] = shown.origin;
  const gx = (x - ox) / shown.resolution;
  const gy = (y - oy) / shown.resolution;
  return [view.x + gx * view.scale, view.y + (expectedMap().height - gy) * view.scale];
}

function line(context, from, to, colour, width, dash = []) {
  context.strokeStyle = colour;
  context.lineWidth = width * devicePixelRatio;
  context.setLineDash(dash.map((d) => d * devicePixelRatio));
  context.beginPath();
  context.moveTo(...from);
  context.lineTo(...to);
  context.stroke();
  context.setLineDash([]);
}

/* Walls, the beam of the first difference, and the robot: at this beam where the map is looked at for its sake, else
   where it took the last scan. */
function drawWorld(context) {
  if (!shown.origin) return;
  for (const [x0, y0, x1, y1] of shown.walls) line(context, toCanvas(x0, y0), toCanvas(x1, y1), style("--wall"), 1.5);
  const beam = beamStart();
  if (beam) line(context, toCanvas(beam.robot[0], beam.robot[1]), toCanvas(...beam.end), style("--beam"), 2, [6, 3]);
  const atBeam = beam && isLastFrame() && firstWrongFrame() === null;
  const pose = atBeam ? beam.robot : shown.frames ? shown.frames.poses[frameIndex()] : null;
  if (!pose) return;
  const [x, y] = toCanvas(pose[0], pose[1]);
  const size = 6 * devicePixelRatio;
  context.fillStyle = style("--robot");
  context.beginPath();
  context.arc(x, y, size / 2, 0, 2 * Math.PI);
  context.fill();
  line(context, [x, y], [x + 2.2 * size * Math.cos(pose[2]), y - 2.2 * size * Math.sin(pose[2])], style("--robot"), 2);
}

/* A step of 1, 2 or 5 times a power of ten that leaves so many pixels between two marks. */
function tickStep(perMetre, least) {
  const raw = least / perMetre;
  const power = 10 ** Math.floor(Math.log10(raw));
  return [1, 2, 5, 10].map((f) => f * power).find((step) => step >= raw);
}

/* Metres along both sides; without an origin, cells. */
function drawAxes(context) {
  const { width: w, height: h } = context.canvas;
  const left = LEFT * devicePixelRatio;
  const floor = h - BOTTOM * devicePixelRatio;
  const resolution = shown.origin ? shown.resolution : 1;
  const [ox, oy] = shown.origin || [0, 0];
  const perMetre = view.scale / resolution;
  const step = tickStep(perMetre, 56 * devicePixelRatio);
  const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const label = (value) => (Math.abs(value) < step / 2 ? 0 : value).toFixed(digits);
  context.fillStyle = style("--panel");
  context.fillRect(0, 0, left, h);
  context.fillRect(0, floor, w, h - floor);
  context.fillStyle = style("--text");
  context.font = `${11 * devicePixelRatio}px system-ui, sans-serif`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  const firstX = ox + ((left - view.x) / view.scale) * resolution;
  for (let i = Math.ceil(firstX / step); ; i++) {
    const at = view.x + ((i * step - ox) / resolution) * view.scale;
    if (at > w) break;
    line(context, [at, floor], [at, floor + 4 * devicePixelRatio], style("--text"), 1);
    context.textAlign = at > w - 12 * devicePixelRatio ? "right" : "center";
    context.fillText(label(i * step), Math.min(at, w - 2 * devicePixelRatio), floor + 13 * devicePixelRatio);
  }
  const top = expectedMap().height;
  const firstY = oy + (top - (floor - view.y) / view.scale) * resolution;
  context.textAlign = "right";
  for (let i = Math.ceil(firstY / step); ; i++) {
    const at = view.y + (top - (i * step - oy) / resolution) * view.scale;
    if (at < 0) break;
    line(context, [left - 4 * devicePixelRatio, at], [left, at], style("--text"), 1);
    context.fillText(label(i * step), left - 6 * devicePixelRatio, Math.max(at, 7 * devicePixelRatio));
  }
  context.textAlign = "left";
  context.fillText(shown.origin ? "m" : "cells", 4 * devicePixelRatio, floor + 13 * devicePixelRatio);
}

function draw() {
  const { width, height } = expectedMap();
  const [compare, difference] = canvases.map((canvas) => canvas.getContext("2d"));
  const place = (context, image) => {
    context.imageSmoothingEnabled = false;
    context.drawImage(image, view.x, view.y, width * view.scale, height * view.scale);
  };
  compare.clearRect(0, 0, compare.canvas.width, compare.canvas.height);
  place(compare, now.expected.picture);
  const split = Math.round((compare.canvas.width * Number(byId("slider").value)) / 100);
  if (now.found) {
    compare.save();
    compare.beginPath();
    compare.rect(split, 0, compare.canvas.width - split, compare.canvas.height);
    compare.clip();
    compare.clearRect(split, 0, compare.canvas.width - split, compare.canvas.height);
    place(compare, now.found.picture);
    compare.restore();
    compare.fillStyle = style("--accent");
    compare.fillRect(split - 1, 0, 2, compare.canvas.height);
  }
  difference.clearRect(0, 0, difference.canvas.width, difference.canvas.height);
  place(difference, now.marks);
  drawWorld(compare);
  if (cursor) {
    for (const context of [compare, difference]) {
      context.strokeStyle = style("--accent");
      context.lineWidth = 2 * devicePixelRatio;
      const size = Math.max(view.scale, 4);
      context.strokeRect(view.x + cursor.gx * view.scale, view.y + (height - 1 - cursor.gy) * view.scale, size, size);
    }
  }
  drawAxes(compare);
  drawAxes(difference);
  const scans = shown.frames ? shown.frames.scans[frameIndex()] : null;
  byId("scrubber-value").textContent = scans === null ? "" : `${scans} of ${shown.frames.total}`;
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
    const after = `after ${scansMapped()}`;
    const right = values(now.expected, gx, gy);
    addRow(body, [`expected ${after}`, ...right], false);
    if (now.found) {
      const own = values(now.found, gx, gy);
      addRow(body, [`found ${after}`, ...own], differ(own, right));
    }
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
byId("scrubber").addEventListener("input", () => { look(); draw(); readOut(); });
byId("zoom-in").addEventListener("click", () => zoom(1.6));
byId("zoom-out").addEventListener("click", () => zoom(0.625));
byId("zoom-all").addEventListener("click", wholeMap);
byId("next-difference").addEventListener("click", () => {
  const list = now.differing;
  const at = cursor ? list.findIndex((cell) => cell.gx === cursor.gx && cell.gy === cursor.gy) : -1;
  const next = list[(at + 1) % list.length];
  lookAt(next.gx, next.gy);
});
byId("only-failed").addEventListener("change", (event) => {
  byId("matrix").classList.toggle("only-failed", event.target.checked);
  byId("nothing-failed").hidden = !event.target.checked || document.querySelector("tr.failed") !== null;
});
document.querySelectorAll(".status, #thumbs .thumb").forEach((button) => {
  button.addEventListener("click", async () => {
    await showCase(Number(button.dataset.case), Number(button.dataset.port));
    byId("case").scrollIntoView({ block: "start" });
  });
});
const modes = document.querySelectorAll("#modes input");
function showMode(mode) {
  for (const input of modes) input.checked = input.value === mode;
  for (const item of document.querySelectorAll("#thumbs li")) item.hidden = item.dataset.mode !== mode;
}
modes.forEach((input) => input.addEventListener("change", () => showMode(input.value)));
window.addEventListener("resize", () => { if (shown && shown.maps.length) wholeMap(); });
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
  if (shown && shown.maps.length) { look(); draw(); }
});

/* What the page has found first, where it says so: a case, a port, and a cell where one is known. */
async function showStart() {
  await showCase(start.number, start.port);
  showMode(shown.mode);
  if (start.gx === undefined) return;
  lookAt(start.gx, start.gy);
  if (beamStart()) showBeam();
}

/* Brings the beam of the first difference into view as a whole, as large as it fits. */
function showBeam() {
  wholeMap();
  const ends = [toCanvas(start.robot[0], start.robot[1]), toCanvas(...start.end), toCanvas(...cellMiddle(start))];
  const [left, right] = [Math.min(...ends.map((e) => e[0])), Math.max(...ends.map((e) => e[0]))];
  const [top, bottom] = [Math.min(...ends.map((e) => e[1])), Math.max(...ends.map((e) => e[1]))];
  const across = canvases[0].width - LEFT * devicePixelRatio;
  const up = canvases[0].height - BOTTOM * devicePixelRatio;
  const room = 6 * view.scale;
  const factor = Math.min(across / (right - left + room), up / (bottom - top + room));
  if (factor <= 1) return;
  const scale = Math.min(view.scale * factor, 24 * devicePixelRatio);
  const grow = (at, middle, from) => middle + ((from - at) * scale) / view.scale;
  view = {
    x: grow((left + right) / 2, LEFT * devicePixelRatio + across / 2, view.x),
    y: grow((top + bottom) / 2, up / 2, view.y),
    scale,
  };
  draw();
}

const cellMiddle = ({ gx, gy }) => [0.5 + gx, 0.5 + gy].map((c, i) => shown.origin[i] + c * shown.resolution);

/* else the first failure is what people come for; without one, the first case */
async function begin() {
  const first = document.querySelector("tr.failed .status.bad") || document.querySelector(".status");
  if (start) await showStart();
  else if (first) {
    await showCase(Number(first.dataset.case), Number(first.dataset.port));
    showMode(shown.mode);
  }
  await drawThumbs();
}
if (byId("show-start")) {
  byId("show-start").addEventListener("click", async () => {
    await showStart();
    byId("case").scrollIntoView({ block: "start" });
  });
}
begin();
