// A mapper for the lesson in JavaScript, with the engine's own sin, cos, exp and log; it prints the picture.
// usage: node mapper.js BUG SCENARIO > map.pgm         (without noise; BUG is a name, none for a right map)
'use strict'
const fs = require('fs')
const [bug, file] = process.argv.slice(2)
const is = name => bug === name
const P = { p0: 0.5, p_occ: 0.75, p_free: 0.3, l_min: -8, l_max: 8, no_return: 'free', fov: Math.PI, beams: 181,
  noise_std: 0.02, min_range: 0, width: null, height: null, resolution: null, origin_x: null, origin_y: null, max_range: null }
const walls = []
let grid = null, l0 = 0, occ = 0, free = 0, lineNumber = 0

function fail (reason) {
  process.stderr.write(`${file}:${lineNumber}: ${reason}\n`)
  process.exit(1)
}
function number (text) {
  if (/^[+-]?nan$/i.test(text)) return NaN
  if (is('parse-float') && /inf/i.test(text)) return parseFloat(text)
  if (/^[+-]?inf(inity)?$/i.test(text)) return text[0] === '-' ? -Infinity : Infinity
  if (!/^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(text)) fail('not a number')
  const v = Number(text)
  return Math.abs(v) < 1e-300 ? 0 : v
}
const logit = p => Math.log(p / (1 - p))

function start () {
  if (grid) return
  for (const name in P) if (P[name] === null) fail(`occgrid_${name} is missing`)
  l0 = logit(P.p0)
  occ = logit(P.p_occ) - l0
  free = logit(P.p_free) - l0
  grid = new Float64Array(P.width * P.height).fill(is('starts-at-zero') ? 0 : l0)
}
function cast (x, y, a) {
  const dx = Math.cos(a), dy = Math.sin(a)
  let best = P.max_range
  for (const [x0, y0, x1, y1] of walls) {
    const sx = x1 - x0, sy = y1 - y0, rxs = dx * sy - dy * sx
    if (Math.abs(rxs) < 1e-12) continue
    const qx = x0 - x, qy = y0 - y, t = (qx * sy - qy * sx) / rxs, u = (qx * dy - qy * dx) / rxs
    if (t >= 0 && u >= 0 && u <= 1 && (is('last-hit') || t < best) && t <= P.max_range) best = t
  }
  return best
}
function update (gx, gy, step) {
  if (gx < 0 || gx >= P.width || gy < 0 || gy >= P.height) return
  const i = gy * P.width + gx
  grid[i] = Math.min(Math.max(grid[i] + step, P.l_min), P.l_max)
}
function beam (x, y, a, range) {
  if (Number.isNaN(range)) return
  const hit = range < P.max_range - 1e-12
  if (!hit && P.no_return === 'ignore') return
  const z = hit ? range : P.max_range
  const whole = is('round') ? Math.round : is('bitwise') ? v => v | 0 : Math.floor
  let gx = whole((x - P.origin_x) / P.resolution), gy = whole((y - P.origin_y) / P.resolution)
  const gx1 = whole((x + z * Math.cos(a) - P.origin_x) / P.resolution)
  const gy1 = whole((y + z * Math.sin(a) - P.origin_y) / P.resolution)
  const dx = Math.abs(gx1 - gx), dy = Math.abs(gy1 - gy), sx = gx < gx1 ? 1 : -1, sy = gy < gy1 ? 1 : -1
  let err = dx - dy
  for (;;) {
    const end = gx === gx1 && gy === gy1
    update(gx, gy, end && hit ? occ : free)
    if (end) return
    const e2 = 2 * err
    if (e2 > -dy) { err -= dy; gx += sx }
    if (is('equal') ? e2 <= dx : e2 < dx) { err += dx; gy += sy }
  }
}
function recorded (ranges, at, first, step) {
  const [x, y, theta] = at.slice(0, 3).map(number)
  const texts = is('sorted') ? [...ranges].sort() : ranges
  texts.forEach((text, i) => {
    const range = number(text)
    if (range < 0) fail('a range is negative')
    if (range < P.min_range) return
    beam(x, y, theta + (first + i * step), range)
  })
}
let scans = 0
for (const line of fs.readFileSync(file, 'latin1').split('\n')) {
  lineNumber++
  let f = line.split(/[ \t\r]+/).filter(word => word)
  if (!f.length || f[0][0] === '#') continue
  if (['PARAM', 'WALL', 'POSE'].includes(f[0])) {
    const comment = f.findIndex(word => word[0] === '#')
    if (comment > 0) f = f.slice(0, comment)
  }
  if (f[0] === 'PARAM') {
    if (f.length < 2 || !f[1].startsWith('occgrid_')) continue
    const name = f[1].slice(8)
    if (scans) fail('PARAM must stand before the first scan')
    if (f.length !== 3) fail('PARAM takes 2 values')
    if (!(name in P)) fail(`unknown parameter ${f[1]}`)
    P[name] = name === 'no_return' ? f[2] : number(f[2])
    if (/^p/.test(name) && !(P[name] > 0 && P[name] < 1)) fail('not between 0 and 1')
  } else if (f[0] === 'WALL') {
    if (f.length !== 5) fail('WALL takes 4 values')
    walls.push(f.slice(1).map(number))
  } else if (f[0] === 'POSE') {
    start()
    scans++
    if (f.length !== 4) fail('POSE takes 3 values')
    const [x, y, theta] = f.slice(1).map(number)
    for (let i = 0; i < P.beams; i++) {
      const angle = P.beams === 1 ? 0 : -(P.fov / 2) + (P.fov * i) / (P.beams - 1)
      const range = cast(x, y, theta + angle)
      if (is('least-for-all') && range < P.min_range) continue
      beam(x, y, theta + angle, range)
    }
  } else if (f[0] === 'FLASER') {
    start()
    scans++
    const n = Number(f[1])
    if (f.length !== n + 11) fail('wrong number of values')
    const parts = { 180: 180, 181: 180, 360: 360, 361: 360, 400: 720, 401: 720 }[n] || n - 1
    recorded(f.slice(2, 2 + n), f.slice(2 + n), -(Math.PI / 2), n === 1 ? 0 : Math.PI / parts)
  } else if (f[0] === 'ROBOTLASER1') {
    start()
    scans++
    const n = Number(f[8]), m = Number(f[9 + n])
    if (f.length !== n + m + 24) fail('wrong number of values')
    recorded(f.slice(9, 9 + n), f.slice(10 + n + m), number(f[2]), number(f[4]))
  }
}
const rows = ['P2', `${P.width} ${P.height}`, '255']
for (let gy = P.height - 1; gy >= 0; gy--) {
  const row = []
  for (let gx = 0; gx < P.width; gx++) {
    const l = grid[gy * P.width + gx]
    const p = l >= 0 ? 1 / (1 + Math.exp(-l)) : Math.exp(l) / (1 + Math.exp(l))
    row.push(is('ceil') ? Math.ceil((1 - p) * 255) : Math.floor((1 - p) * 255 + 0.5))
  }
  rows.push(row.join(' '))
}
process.stdout.write(rows.join('\n') + '\n')
