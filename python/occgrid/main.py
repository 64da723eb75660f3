"""The command line (SPEC.md section 6)."""

from __future__ import annotations

import argparse
import errno
import os
import sys
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from occgrid import __version__
from occgrid.fast import map_scenario_fast
from occgrid.lesson import lesson_scenario
from occgrid.map_writer import map_pgm, write_map
from occgrid.mapper import map_scenario
from occgrid.scenario import ScenarioError, read_scenario, scenario_name

MAX_SEED = 4294967295


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command; returns its exit status."""
    options = _options(arguments)
    try:
        for file in options.scenarios or [None]:
            _map_one(file, options)
    except ScenarioError as error:
        print(error, file=sys.stderr)
        return 1
    except OSError as error:
        target = error.filename or "standard output"
        print(f"{target}: cannot be written", file=sys.stderr)
        return 1
    return 0


def _map_one(file: str | None, options: argparse.Namespace) -> None:
    """Map one scenario, or the built-in lesson, and write what was asked for."""
    with (
        lesson_scenario() if file is None else read_scenario(file) as scenario
    ):
        mapping = map_scenario if options.plain else map_scenario_fast
        grid = mapping(scenario, options.seed)
    if options.out is None:
        _print(map_pgm(grid))
    else:
        write_map(options.out, scenario.name, grid)
    if options.plot is not None:
        # matplotlib takes longer to load than the lesson takes to map
        from occgrid.picture import draw_map

        draw_map(grid, options.plot)


def _print(text: str) -> None:
    """Write to standard output. Raises OSError where that fails."""
    if sys.stdout is None:  # closed from the start: print would say nothing
        raise OSError(errno.EBADF, os.strerror(errno.EBADF))
    try:
        print(text, end="", flush=True)
    except OSError:
        # what is left in the buffer would be tried again, and end the program with another status
        with Path(os.devnull).open("w") as nowhere:
            os.dup2(nowhere.fileno(), sys.stdout.fileno())
        raise


def _options(arguments: Sequence[str] | None) -> argparse.Namespace:
    """The options; ends the program with status 2 and the usage where they are wrong."""
    parser = argparse.ArgumentParser(
        prog="occgrid",
        description="Map range scans into an occupancy grid. Without a scenario: the built-in lesson.",
        allow_abbrev=False,
    )
    parser.add_argument(
        "scenarios",
        nargs="*",
        metavar="SCENARIO",
        help="scenario files (CARMEN logs)",
    )
    noise = parser.add_mutually_exclusive_group()
    noise.add_argument(
        "--noise-free",
        action="store_true",
        help="simulate ranges without noise",
    )
    noise.add_argument(
        "--seed",
        type=_seed,
        metavar="N",
        help="seed of the noise (default: 0)",
    )
    parser.add_argument(
        "--plain",
        action="store_true",
        help="map beam by beam, as the handouts print it",
    )
    parser.add_argument(
        "--out",
        type=Path,
        metavar="DIR",
        help="write NAME.pgm, NAME.yaml, NAME.logodds there",
    )
    parser.add_argument(
        "--plot",
        type=Path,
        metavar="FILE",
        help="draw the map with axes and colour bar",
    )
    version = f"occgrid {__version__} (Python {sys.version.split()[0]}, NumPy {np.__version__})"
    parser.add_argument("--version", action="version", version=version)
    options = parser.parse_intermixed_args(arguments)

    names = [scenario_name(file) for file in options.scenarios]
    if len(names) > 1 and options.out is None:
        parser.error("several scenarios need --out")
    if len(names) > 1 and options.plot is not None:
        parser.error("--plot draws one scenario")
    for name in names:
        if names.count(name) > 1:
            parser.error(f"two scenarios are named {name}")
    if options.noise_free:
        options.seed = None
    elif options.seed is None:
        options.seed = 0
    return options


def _seed(text: str) -> int:
    """A seed, as argparse wants it."""
    if not (
        text.isascii()
        and text.isdigit()
        and len(text) < 20
        and int(text) <= MAX_SEED
    ):
        raise argparse.ArgumentTypeError(
            f"a whole number from 0 to {MAX_SEED} is needed, not '{text}'"
        )
    return int(text)
