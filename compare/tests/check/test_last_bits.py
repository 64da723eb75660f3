"""What hangs on last bits is for the ports, which owe them, and not for a check."""

from __future__ import annotations

from occgrid_parity.check.levels import EVIDENCE, LEVELS
from occgrid_parity.suite.cases import LAST_BITS, scenario_folder


def test_the_marked_scenarios_are_there() -> None:
    names = {path.stem for path in scenario_folder().glob("*.log")}
    assert names >= LAST_BITS


def test_no_level_asks_for_last_bits() -> None:
    asked = {name for level in LEVELS for name in level.scenarios}
    assert not LAST_BITS & (asked | set(EVIDENCE))
