"""What makes the search of a cause quick changes nothing: each shortcut finds what the long way finds, bit for bit."""

from __future__ import annotations

from inspect import getattr_static

import numpy as np
import pytest

from occgrid.mapper import simulated_scans
from occgrid.scenario import Scenario
from occgrid_parity.explain.cell_histories import CellHistories
from occgrid_parity.explain.chosen_ways import (
    FREE,
    NOTHING,
    OCCUPIED,
    ChosenWays,
    TracedWays,
    UpdateModel,
)
from occgrid_parity.explain.mistaken_maps import (
    ARRANGING,
    TRACING,
    UPDATING,
)
from occgrid_parity.explain.wrong_cells import wrong_cells
from occgrid_parity.mistakes.catalogue import MISTAKES
from occgrid_parity.model.array_types import Cells
from occgrid_parity.model.known_scans import known_scans
from occgrid_parity.model.mapper_steps import Ends, Mapper, Window
from occgrid_parity.model.reference import lowest_rows, reference_map
from occgrid_parity.model.rounding import beams_of
from occgrid_parity.model.worlds import world_of
from occgrid_parity.programs.observed_map import Observed
from occgrid_parity.suite.cases import case
from occgrid_parity.suite.modes import NOISE_FREE

# the others exchange cells, and are drawn as a whole only
WINDOWED = [
    name
    for name, mistake in MISTAKES.items()
    if all(getattr(mistake, x) is getattr(Mapper, x) for x in ARRANGING)
]
NAMES = ("one-beam", "mixed", "outside", "no-return-free", "lesson")


@pytest.mark.parametrize("seed", [None, 3])
@pytest.mark.parametrize("name", NAMES)
def test_ranges_of_all_scans_at_once_are_those_of_the_port(
    name: str, seed: int | None
) -> None:
    world = world_of(case(name))
    scenario = Scenario(name, world.settings, [*world.walls], world.scans)
    expected = list(simulated_scans(scenario, seed))
    found = known_scans(world, seed)
    assert len(found) == len(expected)
    for one, other in zip(found, expected, strict=True):
        assert one.pose == other.pose
        assert one.angles.tobytes() == other.angles.tobytes()
        assert one.ranges.tobytes() == other.ranges.tobytes()


@pytest.mark.parametrize("name", NAMES)
def test_the_lowest_rows_alone_are_those_of_the_whole_map(name: str) -> None:
    whole = reference_map(case(name), NOISE_FREE)
    height = len(whole.log_odds)
    for rows in {1, height // 8, height // 2, height} - {0}:
        part = lowest_rows(case(name), NOISE_FREE, rows)
        assert part.log_odds.tobytes() == whole.log_odds[:rows].tobytes()
        assert (part.pixels == whole.pixels[height - rows :]).all()


@pytest.mark.parametrize("lowest", [True, False])
def test_wrong_cells_are_counted_until_there_are_enough(lowest: bool) -> None:
    drawn = reference_map(case("lesson"), NOISE_FREE)
    pixels = drawn.pixels.astype(np.uint16)
    rows = slice(-9, None) if lowest else slice(9)
    pixels[rows] ^= 1
    wrong = pixels[rows].size
    observed = Observed(pixels, None, "")

    def found(enough: int) -> int:
        return wrong_cells(observed, case("lesson"), NOISE_FREE, enough)

    assert found(wrong + 1) == wrong
    assert found(wrong) >= wrong
    assert found(1) >= 1


@pytest.mark.parametrize("seed", [None, 0])
@pytest.mark.parametrize("name", WINDOWED)
def test_a_window_is_drawn_as_in_the_whole_map(
    name: str, seed: int | None
) -> None:
    mistake = MISTAKES[name]
    for scenario in ("asymmetric", "outside"):
        mapper = mistake.of(case(scenario), seed)
        whole = mapper.log_odds(mapper.batches())
        height, width = whole.shape
        for left, bottom in ((0, 0), (width // 3, height // 2)):
            window = Window(left, bottom, left + 5, bottom + 4)
            part = mapper.log_odds(mapper.batches(window))
            cells = slice(bottom, bottom + 4), slice(left, left + 5)
            assert part[cells].tobytes() == whole[cells].tobytes()


@pytest.mark.parametrize("name", MISTAKES)
def test_every_step_in_which_a_mistake_lies_is_known_to_those_who_share(
    name: str,
) -> None:
    """Otherwise the mistake would be given what the contract has made."""
    steps = {
        step
        for step, own in vars(Mapper).items()
        if callable(getattr(Mapper, step)) and not step.startswith("__")
        if getattr_static(MISTAKES[name], step) is not own
    }
    pictures = {"reads", "probability", "pixel"}
    assert steps <= {*TRACING, *UPDATING, *ARRANGING} | pictures
    assert steps


@pytest.mark.parametrize("name", WINDOWED)
def test_beams_far_from_a_window_do_not_come_into_it(name: str) -> None:
    mapper = MISTAKES[name](world_of(case("asymmetric")), None)
    rng = np.random.default_rng(11)
    columns = rng.integers(-30, 30, (4, 3000))
    gx0, gy0, gx1, gy1 = columns
    ends = Ends(gx0, gy0, gx1, gy1, rng.random(3000) < 0.5)
    lines, _ = mapper.evidence(mapper.lines(gx0, gy0, gx1, gy1), ends.hit)
    for left, bottom in ((0, 0), (-7, 12), (20, -25)):
        window = Window(left, bottom, left + 3, bottom + 2)
        inside = (lines.gx >= left) & (lines.gx < left + 3)
        inside &= (lines.gy >= bottom) & (lines.gy < bottom + 2)
        near = ends.near(window)
        assert near[lines.beam[inside]].all()
        assert near.mean() < 0.5


def ways_of(name: str) -> tuple[ChosenWays, Cells]:
    """All ways of a scenario's beams, and the contract's."""
    world = world_of(case(name))
    s, beams = world.settings, beams_of(world, None)
    mapper = Mapper(world, None)
    every = np.arange(beams.ways.beam.size)
    ways = ChosenWays(
        TracedWays(beams, s.width, s.height, every),
        UpdateModel(mapper.start(), *mapper.steps(), s.l_min, s.l_max),
    )
    return ways, np.flatnonzero(beams.ways.contract)


@pytest.mark.parametrize("name", ["lesson", "saturate"])
def test_a_cell_with_one_beam_otherwise(name: str) -> None:
    ways, chosen = ways_of(name)
    histories = CellHistories(ways, chosen)
    rng = np.random.default_rng(5)
    cells = rng.choice(np.unique(ways.by_cell), 40).tolist()
    for cell in cells:
        visits = ways.visits(cell)
        for place in rng.choice(visits.beam.size, 10).tolist():
            beam = int(visits.beam[place])
            for kind in (NOTHING, FREE, OCCUPIED):
                of = visits.way[
                    (visits.beam == beam) & (visits.kind == kind)
                ].tolist()
                if kind != NOTHING and not of:
                    continue
                turned = chosen.copy()
                turned[beam] = of[0] if of else -1
                expected = ways.value(cell, turned)
                assert histories.value(cell, beam, kind) == expected


def test_another_way_is_seen_once_the_cell_is_forgotten() -> None:
    ways, chosen = ways_of("lesson")
    mine = chosen[ways.beam] == ways.way
    cells, counts = np.unique(ways.by_cell[mine], return_counts=True)
    cell = int(cells[counts == 2][0])
    one, other = ways.beam[mine & (ways.by_cell == cell)].tolist()
    histories = CellHistories(ways, chosen)
    both = histories.value(cell, other, FREE)
    chosen[one] = -1
    histories.forget(cell)
    assert histories.value(cell, other, FREE) != both
    assert histories.value(cell, other, NOTHING) == ways.model.start
