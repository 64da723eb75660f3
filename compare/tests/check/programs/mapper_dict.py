"""A mapper in plain Python, with the cells in a dictionary; without noise.

usage: mapper_dict.py BUG OUT SCENARIO         (BUG is a name, none for a right map)
"""

import math
import sys
from pathlib import Path

bug = sys.argv[1]


class ScenarioError(Exception):
    pass


DEFAULTS = {
    "min_range": 0.0,
    "p0": 0.5,
    "p_occ": 0.75,
    "p_free": 0.30,
    "l_min": -8.0,
    "l_max": 8.0,
    "no_return": "free",
    "fov": math.pi,
    "beams": 181,
    "noise_std": 0.02,
}
NEEDED = ["width", "height", "resolution", "origin_x", "origin_y", "max_range"]


class Scenario:
    def __init__(self, path):
        self.params = dict(DEFAULTS)
        self.walls = []
        self.scans = []
        with Path(path).open(newline="\n") as f:
            for number, line in enumerate(f, 1):
                try:
                    self.line(line.rstrip("\n").removesuffix("\r"))
                except ValueError as error:
                    raise ScenarioError(f"{path}:{number}: {error}") from error

    def line(self, text):
        fields = text.split()
        if not fields or fields[0].startswith("#"):
            return
        key = fields[0]
        if key in ("PARAM", "WALL", "POSE"):
            for i, field in enumerate(fields):
                if field.startswith("#"):
                    fields = fields[:i]
                    break
        values = fields[1:]
        if key == "PARAM":
            if values and values[0].startswith("occgrid_"):
                self.param(values)
        elif key == "WALL":
            self.walls.append([float(v) for v in values])
        elif key == "POSE":
            self.complete()
            x, y, th = map(float, values)
            self.scans.append((x, y, th, None, None))
        elif key == "FLASER":
            self.complete()
            self.flaser(values)
        elif key == "ROBOTLASER1":
            self.complete()
            self.robotlaser(values)

    def param(self, values):
        if self.scans:
            raise ValueError("PARAM must stand before the first scan")
        if len(values) != 2:
            raise ValueError("PARAM takes 2 values")
        name = values[0][8:]
        if bug == f"{name}-unread":
            return
        if name in ("width", "height", "beams"):
            self.params[name] = int(values[1])
        elif name == "no_return":
            self.params[name] = values[1]
        else:
            self.params[name] = float(values[1])
        if name.startswith("p") and not 0 < self.params[name] < 1:
            raise ValueError(f"{values[0]} is not between 0 and 1")

    def complete(self):
        for name in NEEDED:
            if name not in self.params:
                raise ValueError(f"occgrid_{name} is missing")

    def flaser(self, v):
        n = int(v[0])
        if len(v) != n + 10:
            raise ValueError(
                f"FLASER with {n} beams takes {n + 10} values, found {len(v)}"
            )
        ranges = [float(r) for r in v[1 : n + 1]]
        if min(ranges) < 0:
            raise ValueError("a range is negative")
        x, y, th = map(float, v[n + 1 : n + 4])
        if n in (180, 181):
            step = math.pi / 180
        elif n in (360, 361):
            step = math.pi / 360
        elif n in (400, 401):
            step = math.pi / 720
        else:
            step = math.pi / (n - 1) if n > 1 else 0.0
        self.scans.append(
            (x, y, th, [-(math.pi / 2) + i * step for i in range(n)], ranges)
        )

    def robotlaser(self, v):
        start, step, n = float(v[1]), float(v[3]), int(v[7])
        ranges = [float(r) for r in v[8 : 8 + n]]
        m = int(v[8 + n])
        x, y, th = map(float, v[9 + n + m : 12 + n + m])
        self.scans.append(
            (x, y, th, [start + i * step for i in range(n)], ranges)
        )


def logit(p):
    p = min(max(p, 1e-9), 1 - 1e-9)
    return math.log(p / (1 - p))


def sigmoid(log_odds):
    if log_odds >= 0:
        return 1 / (1 + math.exp(-log_odds))
    return math.exp(log_odds) / (1 + math.exp(log_odds))


class Grid:
    def __init__(self, p):
        self.p = p
        self.l0 = logit(p["p0"])
        self.occ = logit(p["p_occ"]) - self.l0
        self.free = logit(p["p_free"]) - self.l0
        self.cells = {}

    def index(self, x, y):
        dx, dy = x - self.p["origin_x"], y - self.p["origin_y"]
        size = self.p["resolution"]
        if bug == "floor-division":
            return int(dx // size), int(dy // size)
        if bug == "reciprocal":
            per_metre = 1 / size
            return math.floor(dx * per_metre), math.floor(dy * per_metre)
        return math.floor(dx / size), math.floor(dy / size)

    def add(self, gx, gy, delta):
        if not (0 <= gx < self.p["width"] and 0 <= gy < self.p["height"]):
            return
        log_odds = self.cells.get((gx, gy), self.l0) + delta
        log_odds = min(max(log_odds, self.p["l_min"]), self.p["l_max"])
        self.cells[gx, gy] = log_odds

    def beam(self, x, y, a, z, hit):
        x0, y0 = self.index(x, y)
        x1, y1 = self.index(x + z * math.cos(a), y + z * math.sin(a))
        dx, dy = abs(x1 - x0), abs(y1 - y0)
        sx, sy = (1 if x0 < x1 else -1), (1 if y0 < y1 else -1)
        err = dx - dy
        while True:
            last = (x0, y0) == (x1, y1)
            self.add(x0, y0, self.occ if hit and last else self.free)
            if last:
                break
            e2 = 2 * err
            if e2 > -dy:
                err -= dy
                x0 += sx
            if (e2 < dx) if bug != "elif" else (e2 < dx and e2 <= -dy):
                err += dx
                y0 += sy


def simulate(s, x, y, th):
    p = s.params
    n, fov = p["beams"], p["fov"]
    angles = [
        0.0 if n == 1 and bug != "one-beam" else -(fov / 2) + fov * i / (n - 1)
        for i in range(n)
    ]
    ranges = []
    for a in angles:
        dx, dy = math.cos(th + a), math.sin(th + a)
        hits = [p["max_range"]]
        for wall in s.walls:
            x0, y0, x1, y1 = wall
            if bug == "wall-fields":
                x0, x1, y0, y1 = wall
            sx, sy = x1 - x0, y1 - y0
            den = dx * sy - dy * sx
            if abs(den) < 1e-12:
                continue
            qx, qy = x0 - x, y0 - y
            t, u = (qx * sy - qy * sx) / den, (qx * dy - qy * dx) / den
            if t >= 0 and 0 <= u <= 1:
                hits.append(t)
        ranges.append(min(hits))
    return angles, ranges


def main(out, path):
    s = Scenario(path)
    p = s.params
    grid = Grid(p)
    for x, y, th, angles, ranges in s.scans:
        simulated = ranges is None
        if simulated:
            angles, ranges = simulate(s, x, y, th)
        for a, r in zip(angles, ranges, strict=False):
            if math.isnan(r):
                continue
            if not simulated and r < p["min_range"]:
                continue
            hit = r < p["max_range"] - 1e-12
            if not hit:
                if p["no_return"] == "ignore":
                    continue
                r = p["max_range"]
            grid.beam(x, y, th + a, r, hit)
    w, h = p["width"], p["height"]
    rows = [f"P2\n{w} {h}\n255"]
    for gy in reversed(range(h)):
        row = [grid.cells.get((gx, gy), grid.l0) for gx in range(w)]
        grey = [math.floor((1 - sigmoid(one)) * 255 + 0.5) for one in row]
        rows.append(" ".join(map(str, grey)))
    picture = Path(out, Path(path).stem + ".pgm")
    picture.write_text("\n".join(rows) + "\n")


try:
    main(sys.argv[-2], sys.argv[-1])
except ScenarioError as e:
    print(e, file=sys.stderr)
    sys.exit(1)
