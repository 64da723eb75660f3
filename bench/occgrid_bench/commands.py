"""The ports' own commands, as their port.toml declares them, measured from outside: wall time and peak memory."""

from __future__ import annotations

import subprocess
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from occgrid_bench.folders import PROGRAMS, ROOT
from occgrid_parity.ports.declaration import Port, read_port
from occgrid_parity.ports.port_file import DECLARATION


@dataclass(frozen=True)
class Run:
    """One run of a command."""

    seconds: float
    peak: float  # resident memory, MiB


class CommandError(Exception):
    """A command that ended with another status than 0."""


def port_command(
    port: str, scenario: Path, options: Sequence[str] = ()
) -> list[str]:
    """The command that maps a scenario free of noise; {out} stands for the folder of the maps."""
    declared = _declared(port)
    words = [*options, str(scenario)]
    return declared.command(
        declared.run, mode=["--noise-free"], scenario=words, scenarios=words
    )


def missing(port: str) -> str:
    """What to install for a port's command, or nothing."""
    return _declared(port).skip_reason or ""


def _declared(port: str) -> Port:
    return read_port(ROOT / port / DECLARATION)


def run_command(command: Sequence[str]) -> Run:
    """Run a command; its maps go into a folder that is removed."""
    with tempfile.TemporaryDirectory(prefix="occgrid-bench-") as folder:
        out = Path(folder) / "maps"
        out.mkdir()
        report = Path(folder) / "report"
        words = [word.replace("{out}", str(out)) for word in command]
        done = subprocess.run(
            [str(PROGRAMS / "measure"), str(report), *words],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
        )
        if done.returncode != 0:
            raise CommandError(f"{' '.join(words)}\n{done.stdout}")
        seconds, peak, status = report.read_text(encoding="ascii").split()
        if status != "0":
            raise CommandError(f"{' '.join(words)}\n{done.stdout}")
        return Run(float(seconds), int(peak) / 1024)
