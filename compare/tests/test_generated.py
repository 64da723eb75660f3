"""Random scenarios that use the whole of the contract: all ports map them alike."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from pathlib import Path

import pytest

from occgrid_parity.campaign.random_scenarios import (
    KINDS,
    kind_of,
    scenario_text,
)
from occgrid_parity.compare.matrix_run import Plan, run
from occgrid_parity.compare.run_record import RunRecord
from occgrid_parity.ports.building import Built
from occgrid_parity.ports.declaration import Port
from occgrid_parity.report.run_table import explain_result
from occgrid_parity.suite.modes import Mode
from occgrid_parity.suite.scenarios import scenario_from

from .conftest import JOBS, PORTS

COUNT = 6 * len(KINDS)
MODE = Mode(4294967295)


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


def test_the_scenarios_differ_and_are_the_same_in_every_run() -> None:
    texts = [scenario_text(seed) for seed in range(COUNT)]
    assert len(set(texts)) == COUNT
    assert texts == [scenario_text(seed) for seed in range(COUNT)]
    for word in (
        "POSE",
        "FLASER",
        "ROBOTLASER1",
        "WALL",
        "ignore",
        "min_range",
        "\r\n",
        "nan",
        "1e300",
    ):
        assert sum(word in text for text in texts) > 4, word


@pytest.mark.parametrize("kind", KINDS)
def test_the_scenarios_reach_the_grid(maps: RunRecord, kind: str) -> None:
    """Of each kind, most maps have several values; at the limits a cell is known for certain or not at all."""
    least = 2 if kind == "limits" else 3
    changed = 0
    seeds = [seed for seed in range(COUNT) if kind_of(seed) == kind]
    for seed in seeds:
        result = maps.result("python", f"random-{seed}", MODE.name)
        picture = Path(maps.folder) / str(result.picture)
        changed += len(set(picture.read_text().split()[4:])) >= least
    assert changed >= len(seeds) / 2


def values_of(text: str) -> dict[str, str]:
    """The parameters of a scenario."""
    lines = [line.split() for line in text.splitlines()]
    return {
        fields[1].removeprefix("occgrid_"): fields[2]
        for fields in lines
        if fields[:1] == ["PARAM"]
    }


def test_the_scenarios_have_what_their_kinds_say() -> None:
    fields: dict[str, set[float]] = {kind: set() for kind in KINDS}
    for seed in range(COUNT):
        text, kind = scenario_text(seed), kind_of(seed)
        values = values_of(text)
        numbers = {
            float(word)
            for line in text.splitlines()
            if line.split()[:1] in (["FLASER"], ["POSE"], ["ROBOTLASER1"])
            for word in line.split()[1:]
            if re.fullmatch(r"[-+.0-9eE]+", word) and word not in "-+"
        }
        fields[kind] |= numbers
        if kind == "reversed signs":
            p_occ, p0, p_free = (
                float(values[name]) for name in ("p_occ", "p0", "p_free")
            )
            assert p_free > p0 > p_occ
        if kind == "prior":
            assert abs(float(values["p0"]) - 0.5) > 0.1
        if kind == "horizon":
            edge = float(values["max_range"])
            assert {
                edge,
                math.nextafter(edge, 0),
                math.nextafter(edge, math.inf),
            } <= numbers
        if kind == "least range":
            edge = float(values["min_range"])
            assert {edge, math.nextafter(edge, 0)} & numbers
    assert {1e7, -1e7} <= fields["far"]
