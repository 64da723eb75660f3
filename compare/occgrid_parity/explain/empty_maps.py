"""Maps that show no scan: whether a program leaves out all scans of one kind."""

from __future__ import annotations

from collections.abc import Sequence

from occgrid_parity.explain.mistaken_maps import Evidence
from occgrid_parity.explain.shorter_scenarios import SCAN_KEYWORDS
from occgrid_parity.model.reference import reference_map
from occgrid_parity.suite.cases import Case

EMPTY = "all cells have the same grey level, as if no scan had been read"
NAMED = 3


def is_empty(one: Evidence) -> bool:
    """Whether all cells of the map are alike, and should not be."""
    found, right = one.observed.pixels, reference_map(one.case, one.mode)
    return bool(
        (found == found[0, 0]).all()
        and (right.pixels != right.pixels[0, 0]).any()
    )


def empty_maps(maps: Sequence[Evidence]) -> str:
    """That every map is empty, or every map of scans of one kind; else nothing, in a sentence."""
    empty = [one for one in maps if is_empty(one)]
    if not empty:
        return ""
    names = list(dict.fromkeys(one.case.name for one in empty))
    shown = ", ".join(names[:NAMED])
    if len(names) > NAMED:
        shown += f" and {len(names) - NAMED} more"
    which = f"your map of {shown} is empty: {EMPTY}"
    if len(names) > 1:
        which = f"your maps of {shown} are empty: {EMPTY}"
    if len(empty) == len(maps):
        return which
    kinds = {kind for one in empty for kind in scan_kinds(one.case)}
    alike = [one for one in maps if scan_kinds(one.case) == kinds]
    if len(kinds) != 1 or len(alike) != len(empty):
        return ""
    return (
        f"{which}. Their scans are all {kinds.pop()} lines: your program draws nothing from these "
        "(SPEC.md section 5.3)"
    )


def scan_kinds(case: Case) -> set[str]:
    """The keywords of a scenario's scans."""
    words = (line.split()[:1] for line in case.data.splitlines())
    return {
        word.decode()
        for words_of_line in words
        for word in words_of_line
        if word in SCAN_KEYWORDS
    }
