"""The README's table, made from what was measured."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from occgrid_bench.contestants import CONTESTANTS, REFERENCE
from occgrid_bench.goals import goals
from occgrid_bench.record import Part
from occgrid_bench.statistics import ratio
from occgrid_bench.tables import times

WORKS = {
    "lesson": "lesson grid",
    "open": "grid that holds every beam",
    "log": "real log",
}


def markdown(parts: Mapping[str, Part]) -> str:
    """What was measured, for the README."""
    lines = [*_machine(parts), *_comparison(parts), *_goals(parts)]
    return "\n".join(lines) + "\n"


def _machine(parts: Mapping[str, Part]) -> Iterator[str]:
    if not parts:
        return
    values = dict(next(iter(parts.values())).machine)
    head = [
        f"{values.pop('processor')}, {values.pop('cores')} cores",
        values.pop("memory", ""),
        values.pop("system"),
        f"Linux {values.pop('kernel')}",
    ]
    tools = [f"{name} {version}" for name, version in values.items()]
    yield f"Measured on: {'; '.join([*filter(None, head), *tools])}."
    yield ""


def _comparison(parts: Mapping[str, Part]) -> Iterator[str]:
    works = {n: parts[n] for n in WORKS if n in parts}
    if not works:
        return
    yield "Time of mapping as a multiple of the lesson's C++, same poses and ranges, one thread:"
    yield ""
    yield f"| | {' | '.join(WORKS[name] for name in works)} |"
    yield "|---|" + "---:|" * len(works)
    for contestant in CONTESTANTS:
        cells = [_cell(part, contestant.name) for part in works.values()]
        if any(cells):
            yield f"| {' | '.join([contestant.title, *cells])} |"
    yield ""
    for name, part in works.items():
        load = f"load {part.load_before:.1f} to {part.load_after:.1f}"
        yield (
            f"- {WORKS[name]}: {part.title}; median of {part.rounds} rounds, {load}: `{part.command}`"
        )
    yield ""


def _cell(part: Part, name: str) -> str:
    series, reference = part.find(name), part.find(REFERENCE)
    if series is None or reference is None:
        return ""
    mark = "~" if series.every > 1 else ""
    return mark + times(ratio(series.seconds, reference.seconds))


def _goals(parts: Mapping[str, Part]) -> Iterator[str]:
    found = goals(parts)
    if not found:
        return
    yield "| goal | | measured | | again with |"
    yield "|---|---|---:|---|---|"
    for goal in found:
        sign = "at least" if goal.at_least else "at most"
        said = "met" if goal.met else "**missed**"
        yield (
            f"| {goal.text} | {sign} {goal.bound:g} | {goal.value:.3g} | {said} | `{goal.command}` |"
        )
