"""Random worlds and logs that use the whole of the contract, each with its emphasis. The same for the same numbers."""

from __future__ import annotations

import math
import random

# what a scenario is about, by its number
KINDS = (
    "usual",
    "reversed signs",  # p_free > p0 > p_occ
    "prior",  # p0 away from 1/2, close to a clamp
    "cell edges",  # poses, walls and ends on the corners of cells
    "horizon",  # ranges one ulp beside max_range and beside max_range - 1e-12
    "least range",  # ranges beside min_range
    "far",  # coordinates up to ten million metres
    "limits",  # parameters at their limits
)
FARTHEST = 10_000_000.0


def kind_of(number: int) -> str:
    """What the scenario of this number is about."""
    return KINDS[number % len(KINDS)]


def scenario_text(number: int, seed: int = 0) -> str:
    """The scenario of this number in the series of that seed."""
    source = random.Random(f"{seed} {number}")
    return RandomScenario(source, kind_of(number)).text()


def decimal(source: random.Random, low: float, high: float) -> str:
    """A number between the limits, written in one of many ways."""
    value = source.uniform(low, high)
    form = source.choice(
        ["{!r}", "{:.3f}", "{:+.17e}", "{:.25f}", "{:.0f}.", "{:.40g}", "{:E}"]
    )
    text = form.format(value)
    return text if low <= float(text) <= high else repr(value)


def beside(value: float) -> list[str]:
    """A number and its two neighbours."""
    return [
        repr(math.nextafter(value, -math.inf)),
        repr(value),
        repr(math.nextafter(value, math.inf)),
    ]


class RandomScenario:
    """Draws a scenario: first the grid, then its parameters, walls and scans."""

    def __init__(self, source: random.Random, kind: str) -> None:
        self.source = source
        self.kind = kind
        choice, randint = self.source.choice, self.source.randint
        self.width, self.height = randint(1, 70), randint(1, 70)
        self.resolution = choice(
            [0.05, 0.1, 0.25, 1.0, self.source.uniform(0.01, 2.0)]
        )
        if self.kind == "limits":
            self.resolution = choice([0.001, 1000.0])
        self.extent = max(self.width, self.height) * self.resolution
        reaches = [self.extent / 2, self.extent, 3 * self.extent]
        reaches.append(round(self.extent + 1))  # often on a cell edge
        self.max_range = float(choice(reaches))
        self.x0, self.y0 = choice(
            [(-self.extent / 2, -self.extent / 2), (576.3, -0.1), (0.0, 0.0)]
        )
        if self.kind == "far":
            self.x0 = choice([FARTHEST - self.extent, -FARTHEST, 0.0, 456e3])
            self.y0 = choice([FARTHEST - self.extent, -FARTHEST, 5.4e6])
        if self.kind == "limits":
            steps = choice([1.0, 300.0, 1e6])  # 1e6 is the most
            self.max_range = min(10_000.0, steps * self.resolution)
        self.min_range = self.source.uniform(0, self.max_range / 2)

    def text(self) -> str:
        """The scenario as the text of its file."""
        choice, randint = self.source.choice, self.source.randint
        lines = ["# a random scenario", "PARAM robot_width 0.4", ""]
        for name, value in self.parameters():
            lines.append(self.gap().join(["PARAM", f"occgrid_{name}", value]))
        for _ in range(randint(0, 7)):
            comment = choice([[], ["#", "x"]])
            lines.append(self.gap().join(["WALL", *self.wall(), *comment]))
        scans = randint(1, 3 if self.kind == "limits" else 12)
        for _ in range(scans):
            before, after = choice(["", "", " ", "\t"]), choice(["", " "])
            fields = self.gap().join(self.scan())
            lines.append(before + fields + after)
        if self.kind == "far":  # from there no beam reaches the grid
            lines.append(f"POSE {-FARTHEST!r} {FARTHEST!r} -1")
        lines.append(
            self.gap().join(["POSE", self.x(), self.y(), "0.5", "# the last"])
        )
        end = choice(["\n", "\n", "\r\n"])
        return end.join(lines) + choice([end, ""])

    def gap(self) -> str:
        """What may stand between two fields."""
        return self.source.choice([" ", " ", "\t", "  ", " \t "])

    # --- parameters ---

    def parameters(self) -> list[tuple[str, str]]:
        """Names and values in any order; the optional ones not always."""
        source = self.source
        required = {
            "width": source.choice([str(self.width), f"00{self.width}"]),
            "height": str(self.height),
            "resolution": repr(self.resolution),
            "origin_x": repr(self.x0),
            "origin_y": repr(self.y0),
            "max_range": repr(self.max_range),
        }
        further = {
            "p0": decimal(source, 0.2, 0.8),
            "p_occ": decimal(source, 0.4, 0.9999999999),
            "p_free": decimal(source, 1e-12, 0.6),
            "l_min": decimal(source, -20, -2),
            "l_max": decimal(source, 2, 20),
            "no_return": source.choice(["free", "ignore"]),
            "fov": decimal(source, 0, 6.28),
            "beams": str(source.randint(1, 90)),
            "noise_std": decimal(source, 0, 4 * self.resolution),
            "min_range": repr(self.min_range),
        }
        names = source.sample(sorted(further), source.randint(0, len(further)))
        chosen = {name: further[name] for name in names}
        chosen |= self.emphasised()
        found = list((required | chosen).items())
        source.shuffle(found)
        return found

    def emphasised(self) -> dict[str, str]:
        """The parameters that the scenario is about."""
        source = self.source
        if self.kind == "reversed signs":
            return {
                "p_occ": decimal(source, 0.01, 0.25),
                "p0": decimal(source, 0.3, 0.6),
                "p_free": decimal(source, 0.7, 0.99),
            }
        if self.kind == "prior":
            p0 = source.choice([0.02, 0.1, 0.35, 0.7, 0.9, 0.98])
            odds = math.log(p0 / (1 - p0))
            return {
                "p0": repr(p0),
                "l_min": decimal(source, odds - 2, odds - 0.001),
                "l_max": decimal(source, odds + 0.001, odds + 2),
            }
        if self.kind == "least range":
            return {"min_range": repr(self.min_range)}
        if self.kind == "limits":
            sides = ["0.9999999999999999", "1e-300"]
            p_occ, p_free = source.sample(sides, 2)
            return {
                "p_occ": p_occ,
                "p_free": p_free,
                "l_min": source.choice(["-1000", "-1e3"]),
                "l_max": "1000",
                "fov": source.choice(["0", "6.283185307179586"]),
                "beams": source.choice(["1", "2"]),
                "noise_std": source.choice(["0", "1000", "1e-299"]),
                "min_range": "0",
                "no_return": "free",
            }
        return {}

    # --- places ---

    def x(self) -> str:
        return self._coordinate(self.x0, self.width)

    def y(self) -> str:
        return self._coordinate(self.y0, self.height)

    def _coordinate(self, origin: float, cells: int) -> str:
        """A coordinate in the grid or beside it, for some kinds on a cell's edge."""
        if self.kind == "cell edges" and self.source.random() < 0.8:
            at = self.source.randint(-2, cells + 2)
            return self.source.choice(beside(origin + at * self.resolution))
        if self.kind == "limits":  # few scans: each in the grid
            return decimal(
                self.source, origin, origin + cells * self.resolution
            )
        low = max(origin - 0.2 * self.extent, -FARTHEST)
        high = min(origin + 1.2 * self.extent, FARTHEST)
        return decimal(self.source, low, high)

    def theta(self) -> str:
        if self.kind == "cell edges" and self.source.random() < 0.7:
            return repr(self.source.randint(-4, 4) * math.pi / 4)
        if self.source.random() < 0.3:
            return decimal(self.source, -1e6, 1e6)
        return decimal(self.source, -1, 1)

    def wall(self) -> list[str]:
        wall = [self.x(), self.y(), self.x(), self.y()]
        if self.source.random() < 0.5:  # upright, on a cell edge
            column = self.source.randint(0, self.width)
            edge = min(self.x0 + column * self.resolution, FARTHEST)
            wall[0] = wall[2] = repr(edge)
        return wall

    # --- scans ---

    def scan(self) -> list[str]:
        """The fields of a scan, or of another program's line."""
        source = self.source
        n = source.choice([1, 2, source.randint(3, 40), 180, 181])
        if self.kind == "limits":
            n = source.choice([1, 2, 3])
        ranges = [self.range() for _ in range(n)]
        pose = [self.x(), self.y(), self.theta()]
        kinds = ["POSE", "FLASER", "ROBOTLASER1", "ODOM"]
        if self.kind in ("horizon", "least range"):
            kinds = ["FLASER", "ROBOTLASER1"]
        kind = source.choice(kinds)
        if kind == "POSE":
            return [kind, *pose]
        if kind == "FLASER":
            tail = "0 0 0 1e9 host x".split()
            return [kind, str(n), *ranges, *pose, *tail]
        if kind == "ROBOTLASER1":
            m = source.choice([0, 0, n, 3])
            start, step = decimal(source, -4, 4), decimal(source, -0.1, 0.1)
            head = ["0", start, "?", step, "?", "?", "#"]
            remissions = [str(m), *m * ["!"]]
            rest = 11 * ["-"]
            return [kind, *head, str(n), *ranges, *remissions, *pose, *rest]
        return [kind, "anything", "#", "1e5"]

    def range(self) -> str:
        """A recorded range, often one of those that are special."""
        source, max_range = self.source, self.max_range
        if self.kind == "horizon" and source.random() < 0.5:
            edges = beside(max_range) + beside(max_range - 1e-12)
            return source.choice(edges)
        if self.kind == "least range" and source.random() < 0.5:
            return source.choice([*beside(self.min_range), "0", "0.001"])
        if self.kind == "cell edges" and source.random() < 0.5:
            cells = source.randint(0, self.width)
            return source.choice(["0", repr(cells * self.resolution)])
        special = "nan +NaN inf Infinity 0 -0 -1e-301 1e300".split()
        return source.choice(
            [
                *3 * [decimal(source, 0.0, max_range)],
                decimal(source, 0.0, 2 * max_range),
                source.choice(special),
                repr(max_range),
                repr(max_range - 1e-12),
                repr(max_range - 1.1e-12),
                repr(round(source.uniform(0, max_range))),
                "81.91",
            ]
        )
