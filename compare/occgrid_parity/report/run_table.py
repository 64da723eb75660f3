"""A run's record for people: the table, the differences, the summary."""

from __future__ import annotations

from collections import Counter

from rich.box import SIMPLE
from rich.table import Table
from rich.text import Text

from occgrid_parity.compare.cell_values import CellValue
from occgrid_parity.compare.run_record import Difference, Result, RunRecord

STYLES = {
    "reference": "dim",
    "identical": "green",
    "differs": "bold red",
    "error": "bold red",
    "timeout": "bold red",
    "skipped": "yellow",
    "left out": "dim",
}


def matrix_table(record: RunRecord) -> Table:
    """Scenarios and modes downwards, ports across, the seconds of each at the foot."""
    # as narrow as it goes: many ports stand side by side
    table = Table(show_footer=True, box=SIMPLE, padding=0, show_edge=False)
    table.add_column("scenario", footer="seconds", overflow="fold")
    table.add_column("mode", no_wrap=True)
    for port in record.ports:
        seconds = sum(
            p.seconds for p in record.processes if p.port == port.name
        )
        footer = f"{seconds:.1f}" if seconds else ""
        title = f"{port.name} *" if port.reference else port.name
        table.add_column(title, footer=footer, no_wrap=True)
    for scenario in record.scenarios:
        for mode in record.modes:
            cells = []
            for port in record.ports:
                result = record.result(port.name, scenario.name, mode)
                shown = shown_status(result)
                cells.append(Text(shown, style=STYLES[shown]))
            first = scenario.name if mode == record.modes[0] else ""
            table.add_row(first, mode, *cells)
    return table


def shown_status(result: Result) -> str:
    """The status; of the reference, ``reference`` where nothing was there to compare."""
    if result.status == "identical" and not result.compared_with:
        return "reference"
    return result.status


def footnotes(record: RunRecord) -> list[str]:
    """What the table's marks mean, and which ports are skipped for which reason."""
    notes = [
        f"* {record.reference} is the reference that the others are compared with"
    ]
    golden = sum("golden" in r.compared_with for r in record.results)
    if golden:
        notes.append(
            f"{golden} maps were compared with a golden result as well"
        )
    if not any(result.compared_with for result in record.results):
        notes.append("nothing was compared: choose another port as well")
    notes += [
        f"{p.name}: skipped: {p.problem}" for p in record.ports if p.skipped
    ]
    notes += [
        f"{r.port}: left out: {r.reason}"
        for r in record.results
        if r.status == "left out"
    ]
    return list(dict.fromkeys(notes))


def summary(record: RunRecord) -> str:
    """How many maps there are of each status, in one line."""
    counts = Counter(map(shown_status, record.results))
    said = ", ".join(f"{n} {status}" for status, n in counts.most_common())
    return f"{len(record.results)} maps: {said} ({record.seconds:.1f} s)"


def explanations(record: RunRecord) -> list[str]:
    """Everything that is not identical and not skipped, explained."""
    lines: list[str] = []
    for result in record.results:
        if result.status not in ("identical", "skipped", "left out"):
            lines += ["", *explain_result(result)]
    return lines


def explain_result(result: Result) -> list[str]:
    """One result in words: status, reason, and where its files differ."""
    head = f"{result.port}, {result.scenario}, {result.mode}: {result.status}"
    if result.status != "differs":
        return [f"{head}: {result.reason}" if result.reason else head]
    lines = [head]
    for difference in result.differences:
        lines += [f"  {line}" for line in explain_difference(difference)]
    return lines


def explain_difference(difference: Difference) -> list[str]:
    """The first cells of a file that differ, and how many do."""
    d = difference
    other = "" if d.expected_file == d.file else f" {d.expected_file}"
    lines = [
        f"{d.file}: {d.count} of {d.total} {d.unit} differ from {d.against}{other}",
    ]
    lines += [f"  {line}" for line in d.detail]
    for cell in d.cells:
        lines += [
            f"  cell gx={cell.gx} gy={cell.gy}",
            f"    found    {_value(cell.found)}",
            f"    expected {_value(cell.expected)}",
        ]
    if d.cells and d.count > len(d.cells):
        lines.append(f"  and {d.count - len(d.cells)} more")
    return lines


def _value(value: CellValue) -> str:
    parts = []
    if value.log_odds is not None:
        parts.append(f"log-odds {value.log_odds} (0x{value.bits})")
        parts.append(f"p {value.probability}")
    if value.pixel is not None:
        parts.append(f"pixel {value.pixel}")
    return ", ".join(parts)
