"""A port that travels to another machine as the archive of its sources, and is built there once."""

from __future__ import annotations

import threading
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

from occgrid_parity.formats.archive import Archive, pack, unpack
from occgrid_parity.ports.building import Built, as_it_is, build_port
from occgrid_parity.ports.declaration import Port
from occgrid_parity.processes.cluster import folder_here

BUILT = ("build", "build-*", "target", "node_modules", "__pycache__", ".*")
"""What builds and tools leave in a port's folder: no sources."""

MOST_BYTES = 64 * 2**20
PLACE = "occgrid-ports"

_settled: dict[str, Built] = {}
_lock = threading.Lock()


@dataclass(frozen=True)
class Parcel:
    """A port and its sources."""

    port: Port
    archive: Archive = field(repr=False)


Traveller = Port | Parcel
"""A port that is here, built, or one that comes as a parcel."""


def parcel(port: Port) -> Parcel:
    """The port with its sources. Raises ArchiveError where they cannot be read or are too large."""
    return Parcel(port, pack(port.folder, MOST_BYTES, BUILT))


def port_of(one: Traveller) -> Port:
    """The port, wherever it is."""
    return one if isinstance(one, Port) else one.port


def ready(travellers: Sequence[Traveller]) -> list[Built]:
    """The ports as they can be run here; what comes as a parcel is built, if it has not been yet."""
    return [
        as_it_is(one) if isinstance(one, Port) else _settle(one, folder_here())
        for one in travellers
    ]


def _settle(one: Parcel, place: Path) -> Built:
    folder = place / PLACE / one.archive.digest[:16] / one.port.name
    with _lock:
        known = _settled.get(str(folder))
        if known is not None:
            return known
        if not folder.exists():
            unpack(one.archive.data, folder)
        port = replace(one.port, folder=folder)
        built = build_port(port, folder.parent / "logs")
        _settled[str(folder)] = built
        return built
