"""python -m occgrid_mutants: `make mutants`."""

from __future__ import annotations

import argparse
import hashlib
import random
import shutil
import tempfile
import time
from functools import partial
from pathlib import Path

from occgrid_mutants.campaign import Campaign, Result
from occgrid_mutants.report import Run, read, summary, write

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
        "--resume",
        action="store_true",
        help="go on with the run in --out that was interrupted",
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
            shutil.copytree(
                ROOT / name,
                Path(folder) / name,
                ignore=shutil.ignore_patterns("__pycache__"),
            )
        sources = _fingerprint([Path(folder), Path(__file__).parent])
        campaign = Campaign(Path(folder), partial(print, flush=True))
        try:
            _run(options, campaign, sources)
        except ValueError as error:
            parser.exit(1, f"{error}\n")


def _fingerprint(folders: list[Path]) -> str:
    """A hash of the files that decide what a run finds."""
    total = hashlib.sha256()
    for folder in folders:
        for file in sorted(folder.rglob("*")):
            if file.is_file() and file.suffix != ".pyc":
                total.update(f"{file.relative_to(folder)}\n".encode())
                total.update(hashlib.sha256(file.read_bytes()).digest())
    return total.hexdigest()


def _run(
    options: argparse.Namespace, campaign: Campaign, sources: str
) -> None:
    chosen = [
        (number, site)
        for number, site in enumerate(campaign.sites)
        if options.only in site.name and site.module not in options.without
    ]
    # at random, so that what has been tried when a run is stopped is a fair sample
    random.Random(options.seed).shuffle(chosen)
    of = len(chosen)
    chosen = chosen[: options.count]
    results: dict[int, Result] = {}
    before = 0.0
    if options.resume:
        results, before = read(options.out, campaign.sites, sources)
        for result in results.values():
            campaign.learn(result)
    numbers = {id(site): number for number, site in chosen}
    left = [site for number, site in chosen if number not in results]
    start = time.monotonic()

    def keep() -> None:
        seconds = before + time.monotonic() - start
        write(options.out, results, Run(sources, of, seconds))

    def done(result: Result) -> None:
        results[numbers[id(result.site)]] = result
        if not result.seen_by:
            print(f"nothing sees {result.site.name}", flush=True)
        if len(results) % 25 == 0:  # what is found stays, however a run ends
            keep()
            minutes = (time.monotonic() - start) / 60.0
            print(
                f"{len(results)} of {len(chosen)}, {minutes:.0f} minutes",
                flush=True,
            )

    until = None if options.minutes is None else start + 60 * options.minutes
    try:
        campaign.run(left, options.jobs, done, until)
    finally:
        keep()
    seconds = before + time.monotonic() - start
    print("\n".join(summary(list(results.values()), of, seconds)))


if __name__ == "__main__":
    main()
