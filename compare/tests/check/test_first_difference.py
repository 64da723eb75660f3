"""The first difference: the right scan and beam, in few runs, with a scenario that shows it again."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from occgrid_parity.check.check_options import Options
from occgrid_parity.check.verdict_text import verdict_text
from occgrid_parity.check.whole_check import check
from occgrid_parity.explain.cell_drawing import draw_patch
from occgrid_parity.explain.first_difference import find_first_difference
from occgrid_parity.explain.shorter_scenarios import Shortener
from occgrid_parity.formats.log_odds import bits
from occgrid_parity.mistakes.catalogue import MISTAKES
from occgrid_parity.model.mapper_steps import Mapper
from occgrid_parity.model.reference import reference_map
from occgrid_parity.model.rounding import beams_of
from occgrid_parity.model.worlds import world_of
from occgrid_parity.suite.cases import Case, case
from occgrid_parity.suite.modes import NOISE_FREE, Mode

from ..check_helpers import MapperRunner, wrong_beam


# a program that is given a part of a log knows nothing of numbers: its bad beam is known by where it ends
@pytest.mark.parametrize(
    ("name", "scan", "beam"),
    [("lesson-offset", 98, 21), ("asymmetric", 4, 38), ("flaser", 3, 200), ("robotlaser1", 4, 312),
     ("octants", 17, 0), ("one-beam", 0, 0)],
)  # fmt: skip
def test_finds_scan_and_beam(
    name: str, scan: int, beam: int, tmp_path: Path
) -> None:
    one = case(name)
    beams = beams_of(world_of(one), None)
    index = int(
        np.flatnonzero((beams.scan == scan) & (beams.number == beam))[0]
    )
    x, y = float(beams.ex[index]), float(beams.ey[index])
    assert ((beams.ex == x) & (beams.ey == y)).sum() == 1
    wrong = wrong_beam(x, y)
    runner = MapperRunner(wrong)
    observed = runner.run(one, NOISE_FREE).observed
    assert observed is not None
    difference, runs, short, partial = find_first_difference(
        runner, one, NOISE_FREE, observed, tmp_path
    )
    assert difference is not None and difference.runs == runs
    assert short is not None and short.differs
    assert (difference.scan, difference.beam) == (scan, beam)
    assert difference.how == "runs"
    assert difference.runs <= 16
    assert all(0 < scans <= len(world_of(one).scans) for scans in partial)
    end = difference.endpoint
    assert end is not None
    assert (float(end.x), float(end.y)) == (x, y)
    assert (float.fromhex(end.x_hex), float.fromhex(end.y_hex)) == (x, y)
    cell = difference.gx, difference.gy
    s = world_of(one).settings
    expected = [
        ((c.gx, c.gy), c.kind)
        for c in difference.expected_cells
        if 0 <= c.gx < s.width and 0 <= c.gy < s.height
    ]
    assert expected[-1] == (cell, "occupied")
    found = {(c.gx, c.gy): c.kind for c in difference.found_cells}
    assert found == {**dict(expected), cell: "free"}
    assert any("[#]" in line and "[o]" in line for line in difference.patch)
    # the minimal scenario is that one beam, and shows the difference again
    saved = tmp_path / "first-difference.log"
    assert (
        difference.scenario_file == str(saved)
        and str(saved) in difference.command
    )
    minimal = Case("first-difference", saved.read_bytes())
    assert len(world_of(minimal).scans) == 1
    verdict = check(runner, Options([minimal]))
    assert verdict.overall == "differs"
    assert "scan 0, beam 0, cell" in verdict_text(verdict)


def test_a_difference_that_needs_what_came_before_keeps_it() -> None:
    """Without a clamp, the map differs only when there has been enough evidence."""
    verdict = check(
        MapperRunner(MISTAKES["no-clamp"]), Options([case("saturate")])
    )
    difference = verdict.first_difference
    assert difference is not None
    drawn = [
        Mapper(world_of(Shortener(case("saturate")).prefix(n)), None).draw()
        for n in (difference.scan or 0, (difference.scan or 0) + 1)
    ]
    limits = world_of(case("saturate")).settings
    assert (
        not np.isin(drawn[0].log_odds, (limits.l_min,)).any()
        or difference.scan == 0
    )
    assert np.isin(drawn[1].log_odds, (limits.l_min, limits.l_max)).any()
    assert difference.beam is not None


@pytest.mark.parametrize("name", ["once-per-scan", "last-bearing-missing"])
def test_a_mistake_in_the_scan_as_a_whole_is_told_as_such(name: str) -> None:
    verdict = check(
        MapperRunner(MISTAKES[name]), Options([case("asymmetric")])
    )
    difference = verdict.first_difference
    assert difference is not None
    assert (difference.scan, difference.beam) == (0, None)
    assert difference.candidates
    assert (
        "look at how you compute the bearings" in (difference.undetermined[0])
    )


def test_noise_is_traced_to_its_scan() -> None:
    verdict = check(
        MapperRunner(MISTAKES["noise-of-one-scan"]),
        Options([case("asymmetric")], [Mode(3)]),
    )
    difference = verdict.first_difference
    assert difference is not None
    assert (difference.scan, difference.beam) == (1, None)


@pytest.mark.parametrize(
    "name",
    [
        "octants",
        "asymmetric",
        "no-return-ignore",
        "outside",
        "flaser",
        "robotlaser1",
        "formats",
    ],
)
def test_shortened_scenarios_map_the_same_bits(name: str) -> None:
    """All beams one by one, or cut from their scans, draw what the whole scenario draws."""
    one = case(name)
    shortener = Shortener(one)
    scans = len(world_of(one).scans)
    for scan in range(scans) if scans < 15 else (0, scans // 2, scans - 1):
        whole = reference_map(shortener.prefix(scan + 1), NOISE_FREE)
        beams = shortener.beams_in(scan)
        cut = reference_map(
            shortener.beams(scan, beams, history=True), NOISE_FREE
        )
        assert (bits(whole.log_odds) == bits(cut.log_odds)).all()
        alone = reference_map(shortener.alone(scan), NOISE_FREE)
        cut = reference_map(
            shortener.beams(scan, beams, history=False), NOISE_FREE
        )
        assert (bits(alone.log_odds) == bits(cut.log_odds)).all()
        last = reference_map(shortener.beam(scan, beams - 1), NOISE_FREE)
        if beams == 1:
            assert (bits(alone.log_odds) == bits(last.log_odds)).all()


def test_the_patch_is_drawn_with_the_largest_y_first() -> None:
    expected = {(0, 0): "free", (1, 0): "free", (2, 1): "occupied"}
    found = {(0, 0): "free", (1, 1): "free", (2, 1): "occupied"}
    assert draw_patch(
        expected, found, {(1, 0), (1, 1)}, (1, 0), (0, 0), (4, 3)
    ) == [
        "   expected       found",
        "2   .  .  .  .     .  .  .  .",
        "1   . [.] #  .     . [o] #  .",
        "0   R [o] .  .     R [.] .  .",
        "   0          3   0          3",
    ]
