"""Rounding is told apart from error, exactly."""

from __future__ import annotations

import math

import numpy as np
import pytest

from occgrid.sensor import Scan
from occgrid_parity.check.whole_check import check
from occgrid_parity.check.wording import case_result
from occgrid_parity.explain.closeness import (
    compare_with_reference,
    grey_levels,
)
from occgrid_parity.model.arithmetic import PLATFORM
from occgrid_parity.model.array_types import Cells
from occgrid_parity.model.line_cells import contract_lines
from occgrid_parity.model.mapper_steps import Drawn, Mapper, Traced
from occgrid_parity.model.reference import reference_map
from occgrid_parity.model.rounding import beams_of
from occgrid_parity.model.worlds import world_of
from occgrid_parity.programs.observed_map import Observed
from occgrid_parity.suite.cases import TWIN, case
from occgrid_parity.suite.modes import NOISE_FREE, Mode

from ..check_helpers import MapperRunner, wrong_beam

CONDITIONED = (
    "one-beam",
    "octants",
    "asymmetric",
    "saturate",
    "prior",
    "outside",
    "robotlaser1",
    "slanting",
    "tips",
)


def as_observed(drawn: Drawn, log_odds: bool) -> Observed:
    return Observed(
        drawn.pixels.astype(np.uint16),
        drawn.log_odds if log_odds else None,
        "",
    )


@pytest.mark.parametrize("seed", [None, 0, 1])
@pytest.mark.parametrize(
    "name", ["lesson", "formats", "no-return-free", *CONDITIONED]
)
def test_the_contract_is_one_of_the_ways_of_each_beam(
    name: str, seed: int | None
) -> None:
    """And, way by way, draws the reference's map."""
    world = world_of(case(name))
    beams = beams_of(world, seed)
    ways = beams.ways
    mine = np.flatnonzero(ways.contract)
    assert (ways.beam[mine] == np.arange(beams.scan.size)).all()
    mine = mine[ways.used[mine]]
    lines = contract_lines(
        ways.gx0[mine], ways.gy0[mine], ways.gx1[mine], ways.gy1[mine]
    )
    mapper = Mapper(world, seed)
    log_odds = np.full(world.settings.width * world.settings.height, mapper.l0)
    occupied = lines.last & ways.hit[mine][lines.beam]
    mapper.apply(log_odds, Traced(lines.beam, lines.gx, lines.gy, occupied))
    expected = reference_map(case(name), Mode(seed)).log_odds
    assert log_odds.tobytes() == expected.tobytes()


@pytest.mark.parametrize("name", CONDITIONED)
def test_rounding_decides_no_beam_of_these(name: str) -> None:
    for seed in (None, 0, 1):
        assert beams_of(world_of(case(name)), seed).undecided.size == 0


def test_the_count_of_cells_is_that_of_the_page_and_says_what_rounding_explains() -> (
    None
):
    """Two cells differ: one grey value halfway between two levels that went the other way, and one that is wrong."""
    drawn = reference_map(case("asymmetric"), NOISE_FREE)
    pixels = drawn.pixels.astype(np.uint16)
    low, high = grey_levels(drawn.log_odds[::-1], 1)
    half = tuple(np.argwhere(low != high)[0])
    other = tuple(np.argwhere(low == high)[0])
    pixels[half] = low[half] + high[half] - pixels[half]
    pixels[other] = 255 - pixels[other]
    observed = Observed(pixels, None, "")
    compared = compare_with_reference(observed, case("asymmetric"), NOISE_FREE)
    result = case_result("asymmetric", "noise-free", compared, 0.0)
    assert result.cells == 2
    assert result.message == (
        f"2 of {pixels.size} cells differ; rounding can explain 1 of them, but not the other 1"
    )


def test_rounding_decides_most_beams_of_the_lesson() -> None:
    beams = beams_of(world_of(case("lesson")), None)
    on_edge = beams.hit & (beams.edge < 1e-12) & (beams.z > 0.0)
    assert on_edge.sum() > 17000
    assert np.isin(np.flatnonzero(on_edge), beams.undecided).all()
    assert beams.error.max() < 1e-11


def endpoints(name: str, bearings: str) -> tuple[np.ndarray, np.ndarray]:
    """Where the beams of a scenario end in 80-bit arithmetic, with another formula for the bearings."""
    real = np.longdouble
    world = world_of(case(name))
    s = world.settings
    columns = []
    for scan in world.scans:
        pose, ranges = (
            (scan.pose, scan.ranges)
            if isinstance(scan, Scan)
            else (scan, None)
        )
        x, y, theta = (real(value) for value in pose)
        if isinstance(scan, Scan):
            angles = scan.angles.astype(real)
        elif bearings == "linspace":  # in double precision, as NumPy has it
            angles = np.linspace(-s.fov / 2, s.fov / 2, s.beams).astype(real)
        else:
            angles = -real(s.fov) / 2 + real(s.fov) * np.arange(s.beams) / (
                s.beams - 1
            )
        cos, sin = np.cos(theta + angles), np.sin(theta + angles)
        if ranges is None:
            found = np.full(angles.shape, real(np.inf))
            for x0, y0, x1, y1 in world.walls:
                sx, sy, qx, qy = real(x1) - x0, real(y1) - y0, x0 - x, y0 - y
                with np.errstate(all="ignore"):
                    rxs = cos * sy - sin * sx
                    t, u = (
                        (qx * sy - qy * sx) / rxs,
                        (qx * sin - qy * cos) / rxs,
                    )
                meets = (
                    (np.abs(rxs) >= 1e-12)
                    & (t >= 0)
                    & (u >= 0)
                    & (u <= 1)
                    & (t < found)
                )
                found = np.where(meets, t, found)
            z = np.minimum(found, real(s.max_range))
        else:
            z = np.where(
                ranges < s.max_range - 1e-12, ranges, s.max_range
            ).astype(real)
        columns.append((x + z * cos, y + z * sin))
    return np.concatenate([c[0] for c in columns]), np.concatenate(
        [c[1] for c in columns]
    )


@pytest.mark.skipif(
    np.finfo(np.longdouble).nmant < 63, reason="long doubles are doubles here"
)
@pytest.mark.parametrize("bearings", ["exact", "linspace"])
@pytest.mark.parametrize(
    "name", ["lesson", "asymmetric", "robotlaser1", "flaser"]
)
def test_no_endpoint_is_farther_off_than_the_bound_says(
    name: str, bearings: str
) -> None:
    beams = beams_of(world_of(case(name)), None)
    ex, ey = endpoints(name, bearings)
    ways = np.bincount(beams.ways.beam)
    ends = (
        beams.used
        & (ways <= 4)
        & (np.hypot(ex - beams.ex, ey - beams.ey) < 1e-6)
    )
    assert ends.sum() >= beams.used.sum() - 2, (
        "all but those that pass the end of a wall"
    )
    off = np.maximum(np.abs(ex - beams.ex), np.abs(ey - beams.ey))[
        ends
    ].astype(float)
    assert (off <= beams.error[ends]).all()
    # and the bound is no excuse: it is not much farther than what is seen
    assert off.max() > beams.error[ends].max() / 1000


def test_beams_at_the_end_of_a_wall_are_all_that_is_open_on_the_twin() -> None:
    beams = beams_of(world_of(case(TWIN)), None)
    found = [
        (int(beams.scan[i]), int(beams.number[i])) for i in beams.undecided
    ]
    assert found == [(30, 45), (30, 135)]
    corner, tip = beams.undecided
    assert (beams.ex[corner], beams.ey[corner]) == pytest.approx((-10, 8))
    # the beam through (-8, 2), where the horizontal wall ends, may stop there
    ways = beams.ways.beam == tip
    s = world_of(case(TWIN)).settings
    ends = [(math.floor((x - s.origin_x) / s.resolution), math.floor((y - s.origin_y) / s.resolution))
            for x, y in ((-8.0, 2.0), (-10.0, 0.0))]  # fmt: skip
    assert set(
        zip(
            beams.ways.gx1[ways].tolist(),
            beams.ways.gy1[ways].tolist(),
            strict=True,
        )
    ) == set(ends)


class Swerving(Mapper):
    """Turns the beams of one length by so many units in the last place of their endpoint."""

    length = 0.0
    by = 0.0

    def endpoint(
        self, pose: object, beam: np.ndarray, z: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        ex, ey = super().endpoint(pose, beam, z)  # type: ignore[arg-type]
        return np.where(z == self.length, ex + self.by, ex), ey


def drawn_with(name: str, ways: Cells) -> Drawn:
    """The map that one way for each beam draws."""
    world = world_of(case(name))
    mapper = Mapper(world, None)
    w = beams_of(world, None).ways
    ways = ways[w.used[ways]]
    lines = contract_lines(w.gx0[ways], w.gy0[ways], w.gx1[ways], w.gy1[ways])
    log_odds = np.full(world.settings.width * world.settings.height, mapper.l0)
    occupied = lines.last & w.hit[ways][lines.beam]
    mapper.apply(log_odds, Traced(lines.beam, lines.gx, lines.gy, occupied))
    rows = log_odds.reshape(world.settings.height, world.settings.width)
    return Drawn(rows, mapper.picture(rows))


@pytest.mark.parametrize("log_odds", [False, True])
@pytest.mark.parametrize(
    ("name", "turned"), [("lesson", 30), ("lesson", 90), ("formats", 8)]
)
def test_beams_on_the_other_side_of_an_edge_are_named(
    name: str, turned: int, log_odds: bool
) -> None:
    """Undecided beams, put on another side than the contract's: rounding explains the map, and these beams do."""
    beams = beams_of(world_of(case(name)), None)
    rng = np.random.default_rng(turned)
    ways = np.flatnonzero(beams.ways.contract)
    for beam in rng.choice(beams.undecided, turned, replace=False).tolist():
        others = (beams.ways.beam == beam) & ~beams.ways.contract
        ways[beam] = rng.choice(np.flatnonzero(others))
    drawn = drawn_with(name, ways)
    compared = compare_with_reference(
        as_observed(drawn, log_odds), case(name), NOISE_FREE
    )
    assert compared.status == "edges"
    assert compared.edge_beams
    assert len(compared.edge_beams) <= turned


def test_half_a_turn_is_an_error() -> None:
    """Each cell alone could come from rounding, but the beam cannot end on neither side of an edge."""
    one = case("lesson")
    beams = beams_of(world_of(one), None)
    index = int(np.flatnonzero((beams.scan == 60) & (beams.number == 105))[0])
    assert index in beams.undecided
    x, y = float(beams.ex[index]), float(beams.ey[index])
    drawn = wrong_beam(x, y)(world_of(one), None).draw()
    compared = compare_with_reference(
        as_observed(drawn, True), one, NOISE_FREE
    )
    assert compared.wrong.sum() == 1
    assert compared.status == "differs"
    assert not compared.together


@pytest.mark.parametrize("log_odds", [False, True])
def test_a_beam_that_rounding_does_not_decide_is_an_error(
    log_odds: bool,
) -> None:
    one = case(TWIN)
    beams = beams_of(world_of(one), None)
    index = int(
        np.flatnonzero(beams.hit & (beams.edge > 0.02) & (beams.z > 3.0))[0]
    )
    turned = type(
        "Turned", (Swerving,), {"length": float(beams.z[index]), "by": 0.1}
    )
    drawn = turned(world_of(one), None).draw()
    assert (
        compare_with_reference(
            as_observed(drawn, log_odds), one, NOISE_FREE
        ).status
        == "differs"
    )


@pytest.mark.parametrize("log_odds", [False, True])
def test_one_wrong_cell_among_rounded_ones_is_an_error(log_odds: bool) -> None:
    one = case("lesson")
    drawn = Mapper(world_of(one), None, PLATFORM).draw()
    good = as_observed(drawn, log_odds)
    assert compare_with_reference(good, one, NOISE_FREE).status in (
        "edges",
        "halves",
    )
    beams = beams_of(world_of(one), None)
    wall = int(
        np.flatnonzero(
            beams.hit & (np.abs(beams.ex) < 1e-12) & (beams.z > 1.0)
        )[0]
    )
    gx, gy = (
        int((beams.ex[wall] + 11.0) / 0.1),
        int((beams.ey[wall] + 9.0) / 0.1),
    )
    bad = drawn._replace(
        pixels=drawn.pixels.copy(), log_odds=drawn.log_odds.copy()
    )
    bad.log_odds[gy, gx] += 0.01
    bad.pixels[::-1][gy, gx] ^= 1
    assert (
        compare_with_reference(
            as_observed(bad, log_odds), one, NOISE_FREE
        ).status
        == "differs"
    )


@pytest.mark.parametrize("name", ["saturate", "prior", "outside", TWIN])
def test_another_logarithm_is_told_by_its_steps(name: str) -> None:
    one = case(name)
    drawn = Mapper(world_of(one), None, PLATFORM).draw()
    compared = compare_with_reference(
        as_observed(drawn, True), one, NOISE_FREE
    )
    assert compared.status == "identical"
    expected = Mapper(world_of(one), None, PLATFORM).steps()
    assert compared.steps == (
        None if expected == Mapper(world_of(one), None).steps() else expected
    )


def test_grey_values_halfway_between_two_levels() -> None:
    def levels(*odds: float) -> list[tuple[int, int]]:
        low, high = grey_levels(np.log(np.array(odds)), 0)
        return list(zip(low.tolist(), high.tolist(), strict=True))

    # 178.5, 52.5 and 25.5; 127.5; 63.75 and 255 * 0.3001
    assert levels(3 / 7, 27 / 7, 9.0) == [(178, 179), (52, 53), (25, 26)]
    assert levels(1.0) == [(127, 128)]
    assert levels(3.0, 0.6999 / 0.3001) == [(64, 64), (77, 77)]


@pytest.mark.parametrize("log_odds", [False, True])
def test_a_right_program_with_the_machines_own_functions_is_never_wrong(
    log_odds: bool,
) -> None:
    verdict = check(MapperRunner(Mapper, log_odds=log_odds, numbers=PLATFORM))
    assert verdict.overall == "edges"
    assert verdict.exit_status == 0
    assert verdict.summary.startswith(
        "identical on the well-conditioned scenario; on the lesson it differs only at cell edges"
    )
    assert {x.status for x in verdict.levels} <= {
        "passed",
        "identical",
        "halves",
        "edges",
        "not checked",  # the YAML file, which this program does not write
    }
    lesson = next(x for x in verdict.levels if x.name == "lesson")
    assert lesson.status == "edges" and lesson.cases[0].edge_beams
