"""The parts that can be measured, each by itself."""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from decimal import Decimal
from pathlib import Path

from occgrid_bench import growth, long_log
from occgrid_bench.commands import (
    CommandError,
    missing,
    port_command,
    run_command,
)
from occgrid_bench.comparison import Effort, compare
from occgrid_bench.contestants import CONTESTANTS, Contestant
from occgrid_bench.folders import ROOT, WORK, find_log
from occgrid_bench.record import Part, Series
from occgrid_bench.threads import measure_threads
from occgrid_bench.work import (
    Work,
    lesson_work,
    log_work,
    open_lesson_work,
)
from occgrid_parity.logs.conversion import Request, Selection
from occgrid_parity.logs.making import make_scenario

PORTS = ["cpp", "java", "python", "matlab", "mathematica", "web"]


@dataclass(frozen=True)
class Options:
    """What the command line asks for."""

    quick: bool
    rounds: int | None
    only: Sequence[str]
    log: Path | None
    command: str
    say: Callable[[str], None]

    def effort(self, quick: int, full: int) -> Effort:
        """So many rounds, if no number was given."""
        rounds = self.rounds or (quick if self.quick else full)
        if self.quick:
            return Effort(rounds, 0.4, 0.8, False, self.say)
        return Effort(rounds, 20.0, 2.0, True, self.say)

    def contestants(self) -> list[Contestant]:
        """Those who were asked for; the lesson's C++ always."""
        known = [c.name for c in CONTESTANTS]
        for name in self.only:
            if name not in known:
                raise ValueError(f"{name!r} is none of {', '.join(known)}")
        chosen = {known[0], *(self.only or known)}
        return [c for c in CONTESTANTS if c.name in chosen]


def lesson(options: Options) -> Part:
    return _comparison(lesson_work(), options, 3, 11)


def open_lesson(options: Options) -> Part:
    return _comparison(open_lesson_work(), options, 2, 11)


def real_log(options: Options) -> Part | None:
    """None where there is no log."""
    work = find_log_work(options)
    if work is None:
        options.say("log: no folder with logs (OCCGRID_DATA): not measured")
        return None
    return _comparison(work, options, 1, 7)


def find_log_work(options: Options) -> Work | None:
    """The scans of a real log on the grid that occgrid-parity scenario makes for them."""
    log = options.log or find_log()
    if log is None:
        return None
    WORK.mkdir(parents=True, exist_ok=True)
    scenario = WORK / f"{log.stem}.scenario.log"
    make_scenario(
        Request(
            log=log,
            output=scenario,
            resolution=Decimal("0.1"),
            max_range=Decimal("30"),
            margin=Decimal("1"),
            selection=Selection(0, None, 1),
            max_cells=25_000_000,
            all_lines=False,
            parameters={},
        )
    )
    return log_work(scenario, log.name)


def _comparison(work: Work, options: Options, quick: int, full: int) -> Part:
    effort = options.effort(quick, full)
    part = Part(
        work.name, work.title, options.command, effort.rounds, options.quick
    )
    part.cells = work.cells
    part.series = compare(work, options.contestants(), effort)
    return part


def commands(options: Options) -> Part:
    """Each port's command at the lesson, from its start to its end."""
    effort = options.effort(1, 7)
    part = Part(
        "commands",
        "the command at the lesson, reading, simulating and writing included",
        options.command,
        effort.rounds,
        options.quick,
    )
    scenario = ROOT / "scenarios" / "lesson.log"
    for port in PORTS:
        part.series.append(
            Series(port, f"{port}: occgrid", skipped=missing(port))
        )
    for number in range(effort.rounds):
        for series in part.series:
            if series.skipped:
                continue
            options.say(f"commands: round {number + 1}: {series.name}")
            try:
                run = run_command(port_command(series.name, scenario))
            except CommandError as error:
                series.skipped = str(error)
                continue
            series.seconds.append(run.seconds)
            peak = max(run.peak, series.extra.get("peak_mib", 0.0))
            series.extra["peak_mib"] = peak
    return part


def threads(options: Options) -> Part:
    """One thread and several, on a large log."""
    effort = options.effort(2, 9)
    work = growth.scans(16 if options.quick else 64)
    part = Part(
        "threads",
        f"threads, {work.title}",
        options.command,
        effort.rounds,
        options.quick,
    )
    part.series = measure_threads(work, effort)
    return part


def growth_part(options: Options) -> Part:
    """Time and memory against scans, beams, resolution and grid."""
    effort = options.effort(1, 3)
    part = Part(
        "growth",
        "growth of time and memory",
        options.command,
        effort.rounds,
        options.quick,
    )
    part.series = growth.measure_growth(effort, options.quick)
    return part


def long_part(options: Options) -> Part:
    """A log of 100,000 scans."""
    part = Part("long", "a long log, C++", options.command, 1, options.quick)
    counts = [1000, 5000] if options.quick else [1000, 10_000, 100_000]
    with tempfile.TemporaryDirectory(prefix="occgrid-bench-") as folder:
        part.series = long_log.measure_long_log(
            Path(folder), counts, options.say
        )
    return part


PARTS: dict[str, Callable[[Options], Part | None]] = {
    "lesson": lesson,
    "open": open_lesson,
    "log": real_log,
    "commands": commands,
    "threads": threads,
    "growth": growth_part,
    "long": long_part,
}
