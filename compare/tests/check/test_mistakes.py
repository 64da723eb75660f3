"""The catalogue: without a mistake it is the reference, and every mistake is caught and named."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest

from occgrid_parity.check.check_options import Options
from occgrid_parity.check.levels import SEEDS
from occgrid_parity.check.verdict_text import verdict_text
from occgrid_parity.check.whole_check import check
from occgrid_parity.check.wording import LESSON_ONLY, OWN_NOISE
from occgrid_parity.formats.log_odds import bits
from occgrid_parity.mistakes.catalogue import MISTAKES, only_noise
from occgrid_parity.model.arithmetic import PLATFORM, PORTABLE, Arithmetic
from occgrid_parity.model.array_types import Array
from occgrid_parity.model.mapper_steps import Mapper
from occgrid_parity.model.reference import reference_map
from occgrid_parity.model.worlds import world_of
from occgrid_parity.report.mistakes_page import COLUMNS, PAGE, page, table
from occgrid_parity.suite.cases import case, scenario_folder
from occgrid_parity.suite.modes import Mode
from occgrid_parity.suite.repository import find_root

from ..check_helpers import MapperRunner, check_mapper, names

SCENARIOS = sorted(path.stem for path in scenario_folder().glob("*.log"))

# the levels before the noise take time, and these mistakes pass them all
NOISY = Options(
    [
        case("asymmetric"),
        case("mixed"),
        case("noise-half"),
        case("noise-clamp"),
    ],
    SEEDS,
)

# it looks like last bits
HALF_EVEN = "pixel-half-even"

# the same cells in whatever order: nothing can tell these apart
SAME = [{"ties-up", "ties-with-equality", "line-from-the-end"}]


@pytest.mark.parametrize("seed", [None, 7])
@pytest.mark.parametrize("name", SCENARIOS)
def test_without_a_mistake_the_mapper_draws_the_reference(
    name: str, seed: int | None
) -> None:
    one = case(name)
    drawn = Mapper(world_of(one), seed).draw()
    expected = reference_map(one, Mode(seed))
    assert (bits(drawn.log_odds) == bits(expected.log_odds)).all()
    assert (drawn.pixels == expected.pixels).all()


@pytest.fixture(scope="module")
def caught() -> dict[str, list[str]]:
    return table()


@pytest.mark.long
def test_every_mistake_is_caught_by_a_scenario(
    caught: dict[str, list[str]],
) -> None:
    assert [name for name, marks in caught.items() if not any(marks)] == []


@pytest.mark.long
def test_some_mistakes_are_caught_by_one_scenario_only(
    caught: dict[str, list[str]],
) -> None:
    """What each scenario is there for."""
    titles = [name for name, _ in COLUMNS]
    only = {
        name: titles[next(i for i, mark in enumerate(marks) if mark)]
        for name, marks in caught.items()
        if sum(map(bool, marks)) == 1
    }
    assert only == {
        "index-by-reciprocal": "flaser",
        "min-range-for-all": "min-range",
        "min-range-unread": "min-range",
        "p0-unread": "prior",
        "noise-not-clamped": "noise-clamp",
        "exp-of-reduced-argument": "powers",
        "flaser-step-n-minus-1": "flaser",
        "noise-on-recorded-scans": "mixed",
        "simulated-scans-numbered-apart": "mixed",
        "no-return-ignore-unknown": "no-return-ignore",
        "prior-not-subtracted": "prior",
        "starts-at-zero": "prior",
        "noise-seed-ignored": "asymmetric",
        "noise-of-whole-words": "noise-half",
    }


@pytest.mark.long
def test_the_page_is_what_the_code_says(caught: dict[str, list[str]]) -> None:
    assert (find_root() / PAGE).read_text(encoding="utf-8") == page(caught), (
        "run occgrid-parity mistakes --write"
    )


@pytest.mark.long
@pytest.mark.parametrize(
    "name", [name for name in MISTAKES if name != HALF_EVEN]
)
def test_every_mistake_fails_the_check_and_is_named(name: str) -> None:
    verdict = check(
        MapperRunner(MISTAKES[name]),
        NOISY if only_noise(MISTAKES[name]) else None,
    )
    assert verdict.overall == "differs"
    assert verdict.exit_status == 1
    expected = next((same for same in SAME if name in same), {name})
    assert set(names(verdict)) == expected
    assert verdict.cause is not None
    assert all(
        one.lesson and one.where and one.title
        for one in verdict.cause.candidates
    )


@pytest.mark.parametrize("log_odds", [False, True])
def test_a_transposed_picture_costs_one_level(log_odds: bool) -> None:
    """Its log-odds are written column by column, too."""
    verdict = check(MapperRunner(MISTAKES["picture-transposed"], log_odds))
    lost = [x.name for x in verdict.levels if x.counts and not x.good]
    assert lost == ["orientation"]
    assert names(verdict) == ["picture-transposed"]


@pytest.mark.parametrize("log_odds", [False, True])
def test_a_second_mistake_in_a_transposed_picture(log_odds: bool) -> None:
    """Where a map of another size first differs is worked out from the map turned back."""
    both = MISTAKES["picture-transposed"], MISTAKES["no-clamp"]
    verdict = check(MapperRunner(type("Both", both, {}), log_odds))
    lost = {x.name for x in verdict.levels if x.counts and not x.good}
    assert {"orientation", "clamping"} <= lost
    first = verdict.first_difference
    assert first is not None
    if first.scenario == "octants":  # which is a square
        assert first.how == "runs"
        return
    assert first.how == "deduced"
    assert "turned back" in first.undetermined[0]


@pytest.mark.parametrize("reads_scenarios", [False, True])
def test_halves_to_even_numbers_are_mentioned_and_cost_nothing(
    reads_scenarios: bool,
) -> None:
    """No map tells them from last bits: the one half, which no last bit decides, goes to 128 in either way."""
    verdict = check(
        MapperRunner(MISTAKES[HALF_EVEN], reads_scenarios=reads_scenarios)
    )
    assert verdict.exit_status == 0
    assert verdict.score == verdict.maximum
    assert verdict.cause is None
    assert any(HALF_EVEN in said for said in verdict.observations)
    assert "costs no point" in verdict_text(verdict)


@pytest.mark.parametrize("numbers", [PORTABLE, PLATFORM])
def test_one_half_rounded_down_costs_one_point(numbers: Arithmetic) -> None:
    """Every map has such cells, but one level is about them."""
    name = "pixel-half-down"
    runner = MapperRunner(
        MISTAKES[name], False, numbers, reads_scenarios=False
    )
    verdict = check(runner)
    assert verdict.exit_status == 1
    lost = [x.name for x in verdict.levels if x.counts and not x.good]
    assert lost == ["rounding"]
    assert verdict.summary.startswith("rounding: cells that no beam")
    assert "last bit of exp or log decides" not in verdict_text(verdict)
    if numbers is PORTABLE:
        assert names(verdict) == [name]


@pytest.mark.long
@pytest.mark.parametrize(
    "name",
    [
        "no-clamp",
        "hit-also-free",
        "ties-with-equality-in-y",
        "prior-not-subtracted",
        "y-axis-down",
    ],
)
def test_a_mistake_is_named_from_pixels_and_other_arithmetic(
    name: str,
) -> None:
    verdict = check(
        MapperRunner(MISTAKES[name], log_odds=False, numbers=PLATFORM)
    )
    assert verdict.compared == "pixels only"
    found = names(verdict)
    assert name in found
    assert set(found) <= {name, "y-flipped"}, (
        "the picture alone cannot tell the axis from the file's order"
    )


class ShiftedHits(Mapper):
    """A mistake that the catalogue does not have."""

    name = "shifted"

    def read(
        self, ranges: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        z, hit, used = super().read(ranges)
        return np.where(hit, z + 0.3, z), hit, used


def test_nothing_is_guessed_where_no_mistake_fits() -> None:
    verdict = check_mapper(ShiftedHits)
    assert verdict.overall == "differs"
    assert names(verdict) == []
    assert verdict.cause is not None
    assert verdict.cause.message.startswith(
        f"None of the {len(MISTAKES)} mistakes in our catalogue draws these maps"
    )


def test_a_program_with_only_the_lesson_is_checked_on_it() -> None:
    runner = MapperRunner(
        MISTAKES["max-range-occupied"],
        log_odds=False,
        reads_scenarios=False,
        takes_seeds=False,
    )
    verdict = check(runner)
    assert verdict.overall == "differs"
    assert names(verdict) == ["max-range-occupied"]
    assert LESSON_ONLY in verdict.not_checked
    difference = verdict.first_difference
    assert difference is not None and difference.how == "deduced"
    assert difference.undetermined
    assert {x.name for x in verdict.levels if x.status == "not checked"} >= {
        "octants",
        "twin",
    }
    assert OWN_NOISE not in verdict.notes, "it has been explained already"


def test_noise_of_another_generator_is_thought_of() -> None:
    """The lesson's own programs draw it; it is named as a possibility, not as the cause."""

    class Noisy(Mapper):
        name = "noise-of-its-own"

        def simulated(self, angles: Array) -> Iterator[Array]:
            generator = np.random.default_rng(1)
            for ranges in super().simulated(angles):
                noise = generator.normal(0.0, 0.02, angles.size)
                yield self.clip_range(ranges + noise)

    runner = MapperRunner(
        Noisy, log_odds=False, reads_scenarios=False, takes_seeds=False
    )
    verdict = check(runner)
    assert verdict.overall == "differs"
    assert names(verdict) == []
    assert OWN_NOISE in verdict.notes


def test_a_right_program_with_only_the_lesson_passes() -> None:
    runner = MapperRunner(
        Mapper,
        log_odds=False,
        numbers=PLATFORM,
        reads_scenarios=False,
        takes_seeds=False,
    )
    verdict = check(runner, Options())
    assert verdict.overall == "edges"
    assert verdict.exit_status == 0
    assert verdict.summary.startswith(
        "on the lesson it differs only at cell edges"
    )
