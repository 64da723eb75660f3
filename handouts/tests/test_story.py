"""The measurements behind the story."""

from __future__ import annotations

import os
from dataclasses import replace
from pathlib import Path

import numpy as np
import numpy.typing as npt
import pytest

from occgrid import portable_math
from occgrid.lesson import lesson_scenario
from occgrid.mapper import map_scenario
from occgrid_handouts.languages import LANGUAGES
from occgrid_handouts.own_math import (
    draw,
    lesson_arguments,
    looked_up,
    swapped,
)
from occgrid_handouts.platform_math import PLATFORMS, measure, missing
from occgrid_handouts.port_maps import (
    count_differing,
    earlier_map,
    read_log_odds,
)
from occgrid_handouts.project import ROOT
from occgrid_handouts.story import differing
from occgrid_handouts.writings import contract_writing, numpy_writing

PROGRAMS = ROOT / "handouts" / "platform_math"


def test_drawn_with_the_contracts_functions_it_is_the_ports_map() -> None:
    expected = map_scenario(lesson_scenario(), None).log_odds
    drawn = draw("", contract_writing())
    assert not differing(drawn.log_odds, expected).any()


def test_switch_is_turned_back() -> None:
    before = portable_math.sin
    angles = contract_writing().angles()
    with pytest.raises(ZeroDivisionError):
        _fail_inside(angles)
    assert portable_math.sin is before


def _fail_inside(angles: npt.NDArray[np.float64]) -> None:
    with swapped(portable_math, {"sin": looked_up(angles, angles)}):
        assert portable_math.sin(angles[:1]) == angles[:1]
        raise ZeroDivisionError


def test_argument_that_was_not_measured_is_no_guess() -> None:
    function = looked_up(np.array([2.0, 1.0]), np.array([20.0, 10.0]))
    assert function([1.0, 2.0]).tolist() == [10.0, 20.0]
    with pytest.raises(KeyError):
        function(1.5)


def test_missing_toolchain_is_named_and_not_measured() -> None:
    absent = replace(PLATFORMS[0], needs=("no-such-tool",), install="it")
    assert missing(absent) == "not measured: install it"


def test_library_of_python_is_measured(tmp_path: Path) -> None:
    writing = contract_writing()
    arguments = lesson_arguments([writing, numpy_writing()], np.zeros(2))
    only = [p for p in PLATFORMS if p.id == "python"]
    (measured,) = measure(PROGRAMS, tmp_path, arguments, platforms=only)
    assert measured.problem == ""
    ours = portable_math.sin(arguments["sin"])
    # the same function, but not the same bits everywhere
    np.testing.assert_allclose(measured.results["sin"], ours, atol=1e-15)


def test_programs_that_disagree_are_counted(tmp_path: Path) -> None:
    file = tmp_path / "a.logodds"
    file.write_text("# logodds 2 1\n0.1 0.2\n")
    found = read_log_odds(file)
    assert found.tolist() == [[0.1, 0.2]]
    assert count_differing(found, np.array([[0.1, np.nextafter(0.2, 1)]])) == 1
    assert count_differing(found, np.zeros((2, 2))) == 4


def test_earlier_map_counts_only_if_it_is_newer(tmp_path: Path) -> None:
    source = tmp_path / "python" / "occgrid" / "a.py"
    earlier = tmp_path / "build/parity/python/seed-0/scenarios/lesson.logodds"
    for file in (source, earlier):
        file.parent.mkdir(parents=True)
        file.write_text("")
    os.utime(source, (1000, 1000))
    os.utime(earlier, (2000, 2000))
    assert earlier_map(tmp_path, LANGUAGES[0], "seed_0") == earlier
    assert earlier_map(tmp_path, LANGUAGES[0], "noise_free") is None
    os.utime(source, (3000, 3000))
    assert earlier_map(tmp_path, LANGUAGES[0], "seed_0") is None
