"""Finds the ports: those of the repository, or those that somebody names."""

from __future__ import annotations

import tomllib
from collections.abc import Sequence
from pathlib import Path

from occgrid_parity.ports.declaration import Port, read_port
from occgrid_parity.ports.port_file import DECLARATION, PortError


def find_ports(root: Path) -> list[Port]:
    """The ports declared by ``*/port.toml`` in ``root``, by name, python first.

    Raises PortError where there is none, where a declaration cannot be used and where
    two share a name.
    """
    ports = [read_port(path) for path in sorted(root.glob(f"*/{DECLARATION}"))]
    if not ports:
        raise PortError(f"{root}: no folder in it has a {DECLARATION}")
    for port in ports:
        twins = [
            other.folder.name for other in ports if other.name == port.name
        ]
        if len(twins) > 1:
            raise PortError(
                f"{' and '.join(twins)}: both ports are named {port.name}"
            )
    return sorted(ports, key=lambda port: (port.name != "python", port.name))


def is_program(folder: Path) -> bool:
    """Whether a folder holds a program that is no port: its port.toml does not say the language."""
    try:
        text = (folder / DECLARATION).read_text(encoding="utf-8")
        return "language" not in tomllib.loads(text)
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError):
        return False


def choose_ports(root: Path, words: Sequence[str]) -> list[Port]:
    """The ports that the words name (names, folders, port.toml files), or all.

    Raises PortError for a word that names none.
    """
    known = {port.name: port for port in find_ports(root)}
    if not words:
        return list(known.values())
    chosen = []
    for word in words:
        path = Path(word)
        if word in known:
            chosen.append(known[word])
        elif (path / DECLARATION).is_file():
            chosen.append(read_port(path / DECLARATION))
        elif path.name == DECLARATION and path.is_file():
            chosen.append(read_port(path))
        else:
            raise PortError(
                f"{word!r} is neither a port ({', '.join(known)}) nor a folder with "
                f"{DECLARATION}"
            )
    names = [port.name for port in chosen]
    for name in names:
        if names.count(name) > 1:
            raise PortError(f"two ports are named {name}")
    return chosen
