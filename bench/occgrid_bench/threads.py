"""The C++ and Java ports on one thread and on several."""

from __future__ import annotations

from dataclasses import replace

from occgrid_bench.commands import port_command, run_command
from occgrid_bench.comparison import Effort, compare
from occgrid_bench.contestants import CONTESTANTS, Contestant
from occgrid_bench.folders import WORK
from occgrid_bench.record import Series
from occgrid_bench.work import Work

COUNTS = [1, 2]


def measure_threads(work: Work, effort: Effort) -> list[Series]:
    """Mapping only, scans in memory; then the whole command, which reads the log and writes the map."""
    return [*compare(work, _contestants(), effort), *_commands(work, effort)]


def _contestants() -> list[Contestant]:
    known = {c.name: c for c in CONTESTANTS}
    return [
        replace(
            known[name],
            name=f"{name}-{count}",
            title=f"{title}, mapping, {count} thread{'s'[: count > 1]}",
            command=(*known[name].command, str(count)),
            warm_up=2.0,
        )
        for name, title in (("cpp", "C++"), ("java", "Java"))
        for count in COUNTS
    ]


def _commands(work: Work, effort: Effort) -> list[Series]:
    log = work.write_log(WORK)
    series = [
        Series(
            f"{port}-command-{count}",
            f"{title}, command, {count} thread{'s'[: count > 1]}",
            what="from its start to its end: reads the log, writes the map",
        )
        for port, title in (("cpp", "C++"), ("java", "Java"))
        for count in COUNTS
    ]
    for number in range(effort.rounds):
        for one in series:
            effort.say(f"threads: round {number + 1}: {one.title}")
            port, _, count = one.name.split("-")
            command = port_command(port, log, ["--threads", count])
            one.seconds.append(run_command(command).seconds)
    return series
