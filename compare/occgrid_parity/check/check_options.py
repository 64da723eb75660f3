"""What a check is asked to look at, and how much it explains."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

from occgrid_parity.check.program_maps import ComparedMap, PartialMap
from occgrid_parity.suite.cases import Case
from occgrid_parity.suite.modes import Mode


@dataclass(frozen=True)
class Options:
    """What to check, and how much to explain.

    With ``cases`` only these scenarios are mapped, in ``modes`` (default: the program's plain one). ``save`` is the
    folder for the minimal scenario of the first difference. ``on_map`` is told of every map that was compared,
    ``on_partial`` of those of the first scans of a scenario.
    """

    cases: Sequence[Case] = ()
    modes: Sequence[Mode] = ()
    explain: bool = True
    save: Path | None = None
    on_map: Callable[[ComparedMap], None] | None = None
    on_partial: Callable[[PartialMap], None] | None = None
