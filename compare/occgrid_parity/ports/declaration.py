"""Ports as ``port.toml`` declares them, and their command templates."""

from __future__ import annotations

import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import msgspec

from occgrid_parity.ports.port_file import (
    BUILD_TIMEOUT,
    Need,
    PortFile,
    read_port_file,
)


@dataclass(frozen=True)
class Port:
    """One port, or a student's program.

    ``timeout`` and ``build_timeout`` are seconds: for one run of one scenario and
    for each build command. ``log_scans`` and ``probe_lines`` say how much of a real
    log and of a probe's input the tests give to a slow port (None: all), ``plain_scans``
    up to how many scans it maps a scenario by its plain program, ``scenarios_at_once`` how
    many scenarios one process of it takes, so that several processes share the work.
    """

    name: str
    language: str
    folder: Path
    run: tuple[str, ...]
    timeout: float
    build: tuple[tuple[str, ...], ...] = ()
    version: tuple[str, ...] = ()
    probe: tuple[str, ...] = ()
    needs: tuple[Need, ...] = ()
    build_timeout: float = BUILD_TIMEOUT
    log_scans: int | None = None
    plain_scans: int | None = None
    scenarios_at_once: int | None = None
    probe_lines: int | None = None

    @property
    def takes_many(self) -> bool:
        """Whether one process maps several scenarios."""
        return "{scenarios}" in self.run

    @property
    def skip_reason(self) -> str | None:
        """``install octave`` where something it needs is missing, else None."""
        missing = [n.install for n in self.needs if n.is_missing()]
        return (
            "install " + ", ".join(dict.fromkeys(missing)) if missing else None
        )

    def command(
        self,
        template: Sequence[str],
        **values: str | Path | Sequence[str | Path],
    ) -> list[str]:
        """``template`` with ``{port}``, ``{python}`` and the values filled in."""
        known = {"port": self.folder, "python": sys.executable, **values}
        return expand(template, known)


def expand(
    template: Sequence[str],
    values: Mapping[str, str | Path | Sequence[str | Path]],
) -> list[str]:
    """Fills in a command template.

    A value that is a list takes the place of an argument that is its placeholder
    and nothing else, with as many arguments as the list has. Text in braces that is
    no placeholder stays as it is.
    """
    command: list[str] = []
    for argument in template:
        whole = values.get(argument[1:-1]) if argument[:1] == "{" else None
        if whole is not None and not isinstance(whole, str | Path):
            command += [str(value) for value in whole]
            continue
        for name, value in values.items():
            if isinstance(value, str | Path):
                argument = argument.replace("{" + name + "}", str(value))
        command.append(argument)
    return command


def read_port(path: Path) -> Port:
    """The port that the file declares. Raises PortError where it cannot be used."""
    file = read_port_file(path, PortFile)
    keys = msgspec.structs.asdict(file)
    return Port(folder=path.resolve().parent, **keys)
