"""python -m occgrid_mutants: `make mutants`."""

from __future__ import annotations

import argparse
import random
import shutil
import tempfile
import time
from functools import partial
from pathlib import Path

from occgrid_mutants.campaign import Campaign, Result
from occgrid_mutants.report import summary, write

ROOT = Path(__file__).resolve().parents[2]


def main() -> None:
    """Runs all changes, or a sample."""
    parser = argparse.ArgumentParser(
        prog="occgrid_mutants",
        description="Change the Python port one small thing at a time, and see whether the scenarios notice.",
    )
    parser.add_argument(
        "--minutes",
        type=float,
        help="take changes at random for so many minutes (default: all changes)",
    )
    parser.add_argument(
        "--count", type=int, help="take so many changes at random"
    )
    parser.add_argument(
        "--seed", type=int, default=1, help="which sample (default: 1)"
    )
    parser.add_argument(
        "--only", default="", help="only changes whose name contains this"
    )
    parser.add_argument(
        "--without",
        metavar="MODULE",
        action="append",
        default=[],
        help="leave out the changes of this module; can be repeated",
    )
    parser.add_argument(
        "--jobs", type=int, default=2, help="side by side (default: 2)"
    )
    parser.add_argument(
        "--out",
        type=Path,
        default=ROOT / "build" / "mutants",
        help="folder for report.md and results.json (default: build/mutants)",
    )
    options = parser.parse_args()
    # a run takes long, and the files may be edited meanwhile
    with tempfile.TemporaryDirectory() as folder:
        for name in ("python", "scenarios"):
            shutil.copytree(ROOT / name, Path(folder) / name)
        _run(options, Campaign(Path(folder), partial(print, flush=True)))


def _run(options: argparse.Namespace, campaign: Campaign) -> None:
    chosen = [
        s
        for s in campaign.sites
        if options.only in s.name and s.module not in options.without
    ]
    of = len(chosen)
    if options.minutes is not None or options.count is not None:
        random.Random(options.seed).shuffle(chosen)
        chosen = chosen[: options.count]
    results: list[Result] = []
    start = time.monotonic()

    def done(result: Result) -> None:
        results.append(result)
        if not result.seen_by:
            print(
                f"{len(results)}: nothing sees {result.site.name}", flush=True
            )
        if (
            len(results) % 10 == 0
        ):  # what is found so far stays, however the run ends
            write(options.out, results, of, time.monotonic() - start)

    until = None if options.minutes is None else start + 60 * options.minutes
    campaign.run(chosen, options.jobs, done, until)
    seconds = time.monotonic() - start
    write(options.out, results, of, seconds)
    print("\n".join(summary(results, of, seconds)))


if __name__ == "__main__":
    main()
