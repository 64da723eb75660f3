"""Long logs, mapped by the C++ port's command: memory must not grow with them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

from occgrid_bench.commands import port_command, run_command
from occgrid_bench.record import Series
from occgrid_bench.work import lesson_work, parameters, robotlaser


def measure_long_log(
    folder: Path, counts: Sequence[int], say: Callable[[str], None]
) -> list[Series]:
    """The lesson's scans again and again, ranges to the centimetre, as logs of so many scans."""
    work = lesson_work()
    lines = []
    for pose, ranges in zip(work.poses, work.ranges, strict=True):
        text = " ".join(f"{z:.2f}" for z in ranges.tolist())
        lines.append(robotlaser(pose, work.angles, text))
    found = []
    for count in counts:
        say(f"long: writing {count} scans")
        log = folder / "long.log"
        with log.open("w", encoding="ascii") as file:
            file.write(parameters(work.spec, work.max_range))
            for i in range(count):
                file.write(lines[i % len(lines)])
        for threads in (1, 2):
            say(f"long: {count} scans, {threads} threads")
            options = ["--threads", str(threads)]
            run = run_command(port_command("cpp", log, options))
            series = Series(
                f"long-{count}-{threads}",
                f"{count:,} scans, {threads} thread{'s'[: threads > 1]}",
                what="the command: reads the log, maps, writes the map",
                seconds=[run.seconds],
                extra={
                    "peak_mib": run.peak,
                    "scans": count,
                    "log_mib": log.stat().st_size / 2**20,
                },
            )
            found.append(series)
        log.unlink()
    return found
