"""The verdict in one line, and what could not be checked."""

from __future__ import annotations

from collections.abc import Sequence

from occgrid_parity.check import wording
from occgrid_parity.check.verdict import Level, Overall
from occgrid_parity.programs.runner import Runner


def success(levels: Sequence[Level], halves: int) -> tuple[Overall, str]:
    """Overall and summary where no level has failed.

    ``halves``: grey values halfway between two levels that went the other way, over all maps.
    """
    status = {level.name: level.status for level in levels}
    edges = [
        level.title
        for level in levels
        if level.status == "edges" and level.name != "twin"
    ]
    greys = wording.plural(halves, "grey value")
    but = (
        f" (but for {greys} halfway between two levels, over all maps)"
        if halves
        else ""
    )
    if "edges" not in status.values():
        return ("edges" if halves else "identical"), f"identical{but}"
    where = f"on {wording.listed(edges)} it differs only at cell edges"
    twin = status.get("twin", "not checked")
    if twin == "not checked":
        return "edges", f"{where}{but}"
    told = "identical on the well-conditioned scenario"
    if twin == "edges":
        told += " except for beams that pass the end of a wall"
    return "edges", "; ".join([told, *([where] if edges else [])]) + but


def failure(levels: Sequence[Level]) -> str:
    """The summary where a level has failed: the first that did, and how many are right."""
    first = next((x for x in levels if x.status == "failed"), None)
    if first is None:
        first = next(x for x in levels if x.counts and not x.good)
    head = "" if first.word in ("", "differs") else f"{first.word}: "
    return f"{head}{first.message}"


def not_checked(
    runner: Runner, compared: str, levels: Sequence[Level]
) -> list[str]:
    """What the program could not be asked; ``compared`` is what was, in words."""
    said = []
    if not runner.reads_scenarios:
        said += [wording.LESSON_ONLY, wording.NO_TWIN]
    if not runner.takes_seeds:
        said.append(wording.NO_SEED)
    if compared == wording.ONLY_PIXELS:
        said.append(wording.PIXELS_ONLY)
    if any(x.name == "yaml" and not x.counts for x in levels):
        said.append(wording.NO_YAML)
    return said
