"""The README's table, made from what was measured."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from occgrid_bench.contestants import CONTESTANTS, REFERENCE
from occgrid_bench.goals import goals
from occgrid_bench.record import Part, Series
from occgrid_bench.statistics import ratio
from occgrid_bench.tables import duration, times

WORKS = {
    "lesson": "lesson grid",
    "open": "grid that holds every beam",
    "log": "real log",
}


def markdown(parts: Mapping[str, Part]) -> str:
    """All that the parts say."""
    lines = [*_machine(parts), *_comparison(parts)]
    for name in ("commands", "threads", "long"):
        if name in parts:
            lines += _plain(parts[name])
    lines += _goals(parts)
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
    yield "Time as a multiple of the lesson's C++ on the same work (median; median absolute deviation):"
    yield ""
    yield (
        "| | "
        + " | ".join(WORKS[name] for name in works)
        + " | cells that differ |"
    )
    yield "|---|" + "---:|" * (len(works) + 1)
    for contestant in CONTESTANTS:
        cells = [_cell(part, contestant.name) for part in works.values()]
        if any(cells):
            differ = [_differing(p, contestant.name) for p in works.values()]
            differing = next(filter(None, differ), "")
            row = [contestant.title, *cells, differing]
            yield f"| {' | '.join(row)} |"
    yield ""
    for name, part in works.items():
        rounds = f"{part.rounds} rounds"
        load = f"load {part.load_before:.1f} to {part.load_after:.1f}"
        yield f"- {WORKS[name]}: {part.title}; {rounds}, {load}: `{part.command}`"
    yield ""


def _cell(part: Part, name: str) -> str:
    series, reference = part.find(name), part.find(REFERENCE)
    if series is None or reference is None:
        skipped = next((s for s in part.series if s.name == name), None)
        if skipped is None or not skipped.skipped:
            return ""
        return f"not measured: {skipped.skipped.splitlines()[0]}"
    mark = "~" if series.every > 1 else ""
    return f"**{mark}{times(ratio(series.seconds, reference.seconds))}** {_spread(series)}"


def _spread(series: Series) -> str:
    return f"({duration(series.median)} ± {duration(series.spread)})"


def _differing(part: Part, name: str) -> str:
    series = part.find(name)
    if series is None or series.differing is None or part.name != "lesson":
        return ""
    return str(series.differing)


def _plain(part: Part) -> Iterator[str]:
    yield f"{part.title[0].upper()}{part.title[1:]} (`{part.command}`):"
    yield ""
    with_peak = any("peak_mib" in s.extra for s in part.series)
    yield "| | median |" + (" peak memory |" if with_peak else "")
    yield "|---|---:|" + ("---:|" if with_peak else "")
    for series in part.series:
        if not series.seconds:
            continue
        row = f"| {series.title} | {duration(series.median)} ± {duration(series.spread)} |"
        if with_peak:
            row += f" {series.extra['peak_mib']:.1f} MiB |"
        yield row
    yield ""


def _goals(parts: Mapping[str, Part]) -> Iterator[str]:
    found = goals(parts)
    if not found:
        return
    yield "| goal | | measured | |"
    yield "|---|---|---:|---|"
    for goal in found:
        sign = "at least" if goal.at_least else "at most"
        said = "met" if goal.met else "**missed**"
        yield f"| {goal.text} | {sign} {goal.bound:g} | {goal.value:.2f} | {said} |"
