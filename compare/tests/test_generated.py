"""Random scenarios that use the whole of the contract: all ports map them alike."""

from __future__ import annotations

import random
from collections.abc import Callable
from pathlib import Path

import pytest

from occgrid_parity.compare.matrix_run import Plan, run
from occgrid_parity.compare.run_record import RunRecord
from occgrid_parity.ports.building import Built
from occgrid_parity.ports.declaration import Port
from occgrid_parity.report.run_table import explain_result
from occgrid_parity.suite.modes import Mode
from occgrid_parity.suite.scenarios import scenario_from

from .conftest import JOBS, PORTS

COUNT = 40
MODE = Mode(4294967295)


def number(source: random.Random, low: float, high: float) -> str:
    """A number between the limits, written in one of many ways."""
    value = source.uniform(low, high)
    form = source.choice(
        ["{!r}", "{:.3f}", "{:+.17e}", "{:.25f}", "{:.0f}.", "{:.40g}", "{:E}"]
    )
    text = form.format(value)
    return text if low <= float(text) <= high else repr(value)


def a_range(source: random.Random, max_range: float) -> str:
    """A recorded range, often one of those that are special."""
    return source.choice(
        [
            *3 * [number(source, 0.0, max_range)],
            number(source, 0.0, 2 * max_range),
            *source.choices(
                [
                    "nan",
                    "+NaN",
                    "inf",
                    "Infinity",
                    "0",
                    "-0",
                    "-1e-301",
                    "1e300",
                ],
                k=1,
            ),
            repr(max_range),
            repr(max_range - 1e-12),
            repr(max_range - 1.1e-12),
            repr(round(source.uniform(0, max_range))),  # often on a cell edge
            "81.91",
        ]
    )


def scenario_text(seed: int) -> str:
    """A scenario; the same for the same seed."""
    source = random.Random(seed)

    def gap() -> str:
        return source.choice([" ", " ", "\t", "  ", " \t "])

    width, height = source.randint(1, 70), source.randint(1, 70)
    resolution = source.choice(
        [0.05, 0.1, 0.25, 1.0, source.uniform(0.01, 2.0)]
    )
    extent = max(width, height) * resolution
    max_range = source.choice(
        [extent / 2, extent, 3 * extent, round(extent + 1)]
    )
    x0, y0 = source.choice(
        [(-extent / 2, -extent / 2), (576.3, -0.1), (0.0, 0.0)]
    )
    parameters = {
        "width": source.choice([str(width), f"00{width}"]),
        "height": str(height),
        "resolution": repr(resolution),
        "origin_x": repr(x0),
        "origin_y": repr(y0),
        "max_range": repr(float(max_range)),
    }
    further = {
        "p0": number(source, 0.2, 0.8),
        "p_occ": number(source, 0.4, 0.9999999999),
        "p_free": number(source, 1e-12, 0.6),
        "l_min": number(source, -20, -2),
        "l_max": number(source, 2, 20),
        "no_return": source.choice(["free", "ignore"]),
        "fov": number(source, 0, 6.28),
        "beams": str(source.randint(1, 90)),
        "noise_std": number(source, 0, 0.4 * resolution * 10),
    }
    for name in source.sample(
        sorted(further), source.randint(0, len(further))
    ):
        parameters[name] = further[name]
    names = list(parameters)
    source.shuffle(names)

    def x() -> str:
        return number(source, x0 - 0.2 * extent, x0 + 1.2 * extent)

    def y() -> str:
        return number(source, y0 - 0.2 * extent, y0 + 1.2 * extent)

    lines = ["# a random scenario", "PARAM robot_width 0.4", ""]
    lines += [
        gap().join(["PARAM", f"occgrid_{n}", parameters[n]]) for n in names
    ]
    for _ in range(source.randint(0, 7)):
        wall = [x(), y(), x(), y()]
        if source.random() < 0.5:  # upright, on a cell edge
            edge = repr(x0 + source.randint(0, width) * resolution)
            wall[0] = wall[2] = edge
        lines.append(
            gap().join(["WALL", *wall, *source.choice([[], ["#", "x"]])])
        )
    for _ in range(source.randint(1, 12)):
        theta = number(source, -1, 1)
        if source.random() < 0.3:
            theta = number(source, -1e6, 1e6)
        n = source.choice([1, 2, source.randint(3, 40), 180, 181])
        ranges = [a_range(source, max_range) for _ in range(n)]
        kind = source.choice(["POSE", "FLASER", "ROBOTLASER1", "ODOM"])
        if kind == "POSE":
            fields = [x(), y(), theta]
        elif kind == "FLASER":
            fields = [
                str(n),
                *ranges,
                x(),
                y(),
                theta,
                *"0 0 0 1e9 host x".split(),
            ]
        elif kind == "ROBOTLASER1":
            m = source.choice([0, 0, n, 3])
            start, step = number(source, -4, 4), number(source, -0.1, 0.1)
            fields = ["0", start, "?", step, "?", "?", "#", str(n), *ranges]
            fields += [str(m), *m * ["!"], x(), y(), theta, *11 * ["-"]]
        else:
            fields = ["anything", "#", "1e5"]
        before, after = (
            source.choice(["", "", " ", "\t"]),
            source.choice(["", " "]),
        )
        lines.append(before + kind + gap() + gap().join(fields) + after)
    lines.append(gap().join(["POSE", x(), y(), "0.5", "# the last"]))
    end = source.choice(["\n", "\n", "\r\n"])
    return end.join(lines) + source.choice([end, ""])


@pytest.fixture(scope="session")
def maps(
    built: dict[str, Built], tmp_path_factory: pytest.TempPathFactory
) -> RunRecord:
    """All ports over all random scenarios."""
    folder = tmp_path_factory.mktemp("generated")
    scenarios = []
    for seed in range(COUNT):
        path = folder / f"random-{seed}.log"
        path.write_bytes(scenario_text(seed).encode("ascii"))
        scenarios.append(scenario_from(path))
    plan = Plan(
        ports=PORTS,
        scenarios=scenarios,
        modes=[MODE],
        folder=folder / "maps",
        jobs=JOBS,
        built=list(built.values()),
    )
    plan.folder.mkdir()
    return run(plan)


@pytest.mark.parametrize("seed", range(COUNT))
@pytest.mark.parametrize("port", [port.name for port in PORTS])
def test_maps_it_as_the_reference_does(
    maps: RunRecord, need: Callable[[str], Port], port: str, seed: int
) -> None:
    need(port)
    result = maps.result(port, f"random-{seed}", MODE.name)
    if result.status != "identical":
        path = next(
            s.file for s in maps.scenarios if s.name == f"random-{seed}"
        )
        text = Path(str(path)).read_bytes().decode("ascii")
        pytest.fail(
            "\n".join([*explain_result(result), "", text[:3000]]),
            pytrace=False,
        )


def test_the_scenarios_differ_and_reach_the_grid(maps: RunRecord) -> None:
    texts = [scenario_text(seed) for seed in range(COUNT)]
    assert len(set(texts)) == COUNT
    assert texts == [scenario_text(seed) for seed in range(COUNT)]
    for word in (
        "POSE",
        "FLASER",
        "ROBOTLASER1",
        "WALL",
        "ignore",
        "\r\n",
        "nan",
        "1e300",
    ):
        assert sum(word in text for text in texts) > 4, word
    changed = 0
    for result in maps.results:
        if result.port == "python":
            picture = (
                (Path(maps.folder) / str(result.picture))
                .read_text()
                .split()[4:]
            )
            changed += len(set(picture)) > 2
    assert changed > COUNT / 2
