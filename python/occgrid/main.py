"""The command line (SPEC.md section 6)."""

from __future__ import annotations

import errno
import os
import signal
import sys
import threading
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from types import FrameType
from typing import TextIO

import numpy as np

from occgrid import __version__
from occgrid.fast import map_scenario_fast
from occgrid.lesson import lesson_scenario
from occgrid.map_writer import map_pgm, remove_unfinished_maps, write_map
from occgrid.mapper import map_scenario
from occgrid.scenario import (
    ScenarioError,
    on_one_line,
    read_scenario,
    scenario_name,
)

USAGE = """\
usage: occgrid [--noise-free | --seed N] [--plain] [--out DIR] [--plot FILE] [SCENARIO...]
"""
HELP = f"""\
{USAGE}
Maps range scans into an occupancy grid.

  SCENARIO      scenario files (CARMEN logs); without any: the built-in lesson
  --noise-free  simulate ranges without noise
  --seed N      the seed of the noise, 0 to 4294967295 (default: 0)
  --plain       map beam by beam, with the program as the handouts print it
  --out DIR     write NAME.pgm, NAME.yaml and NAME.logodds into DIR;
                without it: the PGM on standard output
  --plot FILE   draw the map, with axes in metres and a colour bar
  --version     print the version
  --help        print this
"""
MAX_SEED = 4294967295


class UsageError(Exception):
    """Arguments that make no sense; its text is the reason."""


class MissingExtra(Exception):
    """A package that is not installed; its text names what brings it."""


@dataclass
class Options:
    """What the arguments ask for."""

    scenarios: list[str] = field(default_factory=list)
    noise_free: bool = False
    seed: int | None = None
    plain: bool = False
    out: str | None = None
    plot: str | None = None
    text: str | None = None  # what to print in place of mapping


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command; returns its exit status."""
    try:
        options = read_arguments(
            sys.argv[1:] if arguments is None else arguments
        )
        with _signals_leave_no_files():
            _run(options)
    except UsageError as error:
        _print_error(f"occgrid: {on_one_line(str(error))}\n{USAGE}")
        return 2
    except (ScenarioError, MissingExtra) as error:
        _print_error(f"{error}\n")
        return 1
    except OSError as error:
        target = on_one_line(str(error.filename or "standard output"))
        _print_error(f"{target}: cannot be written\n")
        return 1
    return 0


# --- Arguments ---


def read_arguments(arguments: Sequence[str]) -> Options:
    """The options, read from left to right. Raises UsageError."""
    options = Options()
    rest = iter(arguments)
    for argument in rest:
        match argument:
            case "--noise-free":
                options.noise_free = True
            case "--seed":
                options.seed = _seed(_value(argument, rest))
            case "--plain":
                options.plain = True
            case "--out":
                options.out = _value(argument, rest)
            case "--plot":
                options.plot = _value(argument, rest)
            case "--help":
                options.text = HELP
                return options
            case "--version":
                options.text = _version()
                return options
            case _ if argument.startswith("-"):
                raise UsageError(f"unknown option {argument}")
            case _:
                options.scenarios.append(argument)
    _check_together(options)
    return options


def _value(option: str, rest: Iterator[str]) -> str:
    """The value of an option: the next argument."""
    value = next(rest, "")
    if value == "" or value.startswith("--"):
        raise UsageError(f"{option} needs a value")
    return value


def _seed(text: str) -> int:
    digits = text.lstrip("0")
    if (
        not (text.isascii() and text.isdigit())
        or len(digits) > len(str(MAX_SEED))
        or int(digits or "0") > MAX_SEED
    ):
        raise UsageError(
            f"--seed takes a whole number from 0 to {MAX_SEED}, not '{text}'"
        )
    return int(digits or "0")


def _version() -> str:
    python = sys.version.split()[0]
    return f"occgrid {__version__} (Python {python}, NumPy {np.__version__})\n"


def _check_together(options: Options) -> None:
    """What no argument alone can show."""
    if options.noise_free and options.seed is not None:
        raise UsageError("--noise-free and --seed exclude each other")
    if len(options.scenarios) > 1 and options.out is None:
        raise UsageError("several scenarios need --out")
    names: set[str] = set()
    for file in options.scenarios:
        name = scenario_name(file)
        if name in names:
            raise UsageError(f"two scenarios are named {name}")
        names.add(name)
    if len(options.scenarios) > 1 and options.plot is not None:
        raise UsageError("--plot draws one scenario")


# --- Work ---


def _run(options: Options) -> None:
    """Do what the options ask for."""
    if options.text is not None:
        _print([options.text])
        return
    if options.plot is not None:
        _check_plot(options.plot)
    files: list[str | None] = [*options.scenarios]
    for file in files or [None]:
        _map_one(file, options)


def _map_one(file: str | None, options: Options) -> None:
    """Map one scenario, or the built-in lesson, and write what was asked for."""
    seed = None if options.noise_free else options.seed or 0
    mapping = map_scenario if options.plain else map_scenario_fast
    with (
        lesson_scenario() if file is None else read_scenario(file) as scenario
    ):
        grid = mapping(scenario, seed)
    if options.out is None:
        _print(map_pgm(grid))
    else:
        write_map(options.out, scenario.name, grid)
    if options.plot is not None:
        from occgrid.picture import draw_map

        try:
            draw_map(grid, options.plot)
        except OSError as error:  # one from within names no file
            raise OSError(error.errno, error.strerror, options.plot) from error


def _check_plot(file: str) -> None:
    """See before the mapping whether it can be drawn. Raises MissingExtra and UsageError.

    matplotlib takes longer to load than the lesson takes to map: it is loaded only where it is needed.
    """
    try:
        from occgrid import picture
    except ImportError as error:
        raise MissingExtra(
            "occgrid: --plot needs matplotlib, which the extra 'plot' brings: pip install 'occgrid-parity[plot]'"
        ) from error
    kinds = picture.file_kinds()
    if Path(file).suffix.removeprefix(".").lower() not in kinds:
        raise UsageError(
            f"--plot takes a file name that ends with one of .{' .'.join(kinds)}"
        )


def _print(pieces: Iterable[str]) -> None:
    """Write to standard output, with LF line ends everywhere. Raises OSError where that fails."""
    if sys.stdout is None:  # closed from the start: print would do nothing
        raise OSError(errno.EBADF, os.strerror(errno.EBADF))
    output = sys.stdout.buffer
    try:
        output.writelines(piece.encode("ascii") for piece in pieces)
        output.flush()
    except OSError:
        _give_up(sys.stdout)
        raise


def _print_error(text: str) -> None:
    """Write to standard error, the bytes of file names as the system gave them."""
    if sys.stderr is not None:
        try:
            sys.stderr.buffer.write(os.fsencode(text))
            sys.stderr.flush()
        except OSError:
            _give_up(sys.stderr)


def _give_up(stream: TextIO) -> None:
    """Lead a stream that cannot be written to nowhere.

    Python would try again at its end to write what is left in the buffer, and end with another status.
    """
    with Path(os.devnull).open("w") as nowhere:
        os.dup2(nowhere.fileno(), stream.fileno())


@contextmanager
def _signals_leave_no_files() -> Iterator[None]:
    """Have SIGINT and SIGTERM remove what is half written, and then end the program as they do by default."""

    def end(number: int, frame: FrameType | None) -> None:
        remove_unfinished_maps()
        signal.signal(number, signal.SIG_DFL)
        signal.raise_signal(number)

    before = {}
    if threading.current_thread() is threading.main_thread():
        for number in (signal.SIGINT, signal.SIGTERM):
            # one that is ignored from the start, as by nohup, stays so
            if signal.getsignal(number) is not signal.SIG_IGN:
                before[number] = signal.signal(number, end)
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
