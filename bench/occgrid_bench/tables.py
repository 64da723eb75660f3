"""Tables for the terminal."""

from __future__ import annotations

from collections.abc import Sequence

from rich.table import Table

from occgrid_bench.contestants import REFERENCE
from occgrid_bench.goals import Goal
from occgrid_bench.record import Part, Series
from occgrid_bench.statistics import ratio


def duration(seconds: float) -> str:
    """Three digits and a unit."""
    if seconds < 1.0:
        return f"{seconds * 1000:.3g} ms"
    return f"{seconds:.3g} s" if seconds < 100 else f"{seconds:.0f} s"


def times(value: float) -> str:
    """A ratio."""
    if value < 0.995:
        return f"{value:.2g}"
    return f"{value:.2f}" if value < 9.95 else f"{value:,.0f}"


def part_table(part: Part) -> Table:
    """Medians with spread, of whatever part."""
    table = Table(title=f"{part.title} ({part.rounds} rounds)")
    table.add_column("")
    for head in ("median", "±", "least", "ratio", "cells that differ", "peak"):
        table.add_column(head, justify="right")
    reference = part.find(REFERENCE)
    for series in part.series:
        table.add_row(*_row(series, reference))
    return table


def _row(series: Series, reference: Series | None) -> list[str]:
    title = series.title
    if series.name.count("/"):
        title = (
            f"{series.name.split('/')[0]} {series.extra['value']:g}: {title}"
        )
    if not series.seconds:
        return [title, f"not measured: {series.skipped}"]
    if series.every > 1:
        title += f" (1 scan in {series.every}, scaled)"
    over = times(ratio(series.seconds, reference.seconds)) if reference else ""
    peak = series.extra.get("peak_mib")
    return [
        title,
        duration(series.median),
        duration(series.spread),
        duration(min(series.seconds)),
        over,
        "" if series.differing is None else str(series.differing),
        "" if peak is None else f"{peak:.0f} MiB",
    ]


def goals_table(goals: Sequence[Goal]) -> Table:
    """What was aimed at, reached or not."""
    table = Table(title="goals")
    table.add_column("")
    for head in ("measured", "goal", ""):
        table.add_column(head, justify="right")
    for goal in goals:
        sign = "at least" if goal.at_least else "at most"
        table.add_row(
            goal.text,
            f"{goal.value:.2f}",
            f"{sign} {goal.bound:g}",
            "met" if goal.met else "[red]missed[/red]",
        )
    return table
