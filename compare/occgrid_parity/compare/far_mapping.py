"""Builds and maps on a cluster: ports and scenarios travel there, maps come back."""

from __future__ import annotations

import shutil
import tempfile
import threading
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

from occgrid_parity.compare.mapping import Mapped, map_batch
from occgrid_parity.formats.archive import NOTHING, Archive, pack, unpack
from occgrid_parity.ports.building import Built
from occgrid_parity.ports.declaration import Port
from occgrid_parity.ports.parcels import Parcel, parcel, ready
from occgrid_parity.processes.cluster import Cluster
from occgrid_parity.processes.pool import side_by_side
from occgrid_parity.processes.process_group import Finished
from occgrid_parity.processes.progress import Progress
from occgrid_parity.suite.modes import Mode
from occgrid_parity.suite.scenarios import ScenarioFile

MOST_BYTES = 2**31
MAPS = "maps"


@dataclass(frozen=True)
class FarBatch:
    """Scenarios for a port in one mode; the text of the lesson that is built in is None."""

    port: Parcel
    mode: Mode
    batch: tuple[ScenarioFile, ...]
    texts: tuple[bytes | None, ...] = field(repr=False)


@dataclass(frozen=True)
class FarMaps:
    """The processes, as they were there below ``folder``, and the files in it; or why there is none."""

    mapped: list[Mapped]
    folder: str
    files: Archive = field(repr=False)
    problem: str = ""


class FarPorts:
    """Ports that are built and run on a cluster."""

    def __init__(self, cluster: Cluster, ports: Sequence[Port]) -> None:
        self.cluster = cluster
        self.parcels = {port.name: parcel(port) for port in ports}

    def build(self, progress: Progress) -> list[Built]:
        """Whether the ports can be built on some machine."""

        def one(name: str, stop: threading.Event) -> Built:
            there = self.parcels[name]
            built = self.cluster.run(
                build_there, there, stop, lambda built: bool(built.problem)
            )
            progress.step(f"{name}: {built.problem or 'built'}")
            return replace(built, port=there.port, log=None)

        return side_by_side(one, list(self.parcels), self.cluster.jobs)

    def map_batch(
        self,
        port: Port,
        mode: Mode,
        batch: Sequence[ScenarioFile],
        folder: Path,
        stop: threading.Event,
    ) -> list[Mapped]:
        """Maps on some machine; the files come into ``folder``."""
        texts = [
            None if one.path is None else one.path.read_bytes()
            for one in batch
        ]
        task = FarBatch(
            self.parcels[port.name], mode, tuple(batch), tuple(texts)
        )
        maps = self.cluster.run(
            map_there, task, stop, lambda maps: bool(maps.problem)
        )
        if maps.problem:
            return [_not_run(port, mode, batch, folder, maps.problem)]
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=folder) as place:
            arrived = Path(place) / MAPS
            unpack(maps.files.data, arrived)
            for path in arrived.iterdir():
                path.rename(folder / path.name)
        return [
            _moved(one, maps.folder, folder, port, batch)
            for one in maps.mapped
        ]


def build_there(port: Parcel) -> Built:
    """On a machine of the cluster: builds a port."""
    return ready([port])[0]


def map_there(task: FarBatch) -> FarMaps:
    """On a machine of the cluster: maps scenarios."""
    built = build_there(task.port)
    if built.problem:
        return FarMaps([], "", NOTHING, built.problem)
    with tempfile.TemporaryDirectory(prefix="occgrid-parity-") as place:
        files = []
        for one, text in zip(task.batch, task.texts, strict=True):
            path = Path(place) / f"{one.name}.log"
            if text is not None:
                path.write_bytes(text)
            files.append(replace(one, path=None if text is None else path))
        folder = Path(place) / MAPS
        folder.mkdir()
        mapped = map_batch(built.port, task.mode, files, folder)
        return FarMaps(mapped, str(folder), pack(folder, MOST_BYTES))


def _moved(
    one: Mapped,
    there: str,
    here: Path,
    port: Port,
    batch: Sequence[ScenarioFile],
) -> Mapped:
    """A process as if it had run here."""
    known = {scenario.name: scenario for scenario in batch}

    def path(old: Path) -> Path:
        return here / old.relative_to(there)

    finished = replace(
        one.finished,
        stdout=path(one.finished.stdout),
        stderr=path(one.finished.stderr),
    )
    return Mapped(
        port,
        one.mode,
        tuple(known[scenario.name] for scenario in one.scenarios),
        path(one.folder),
        finished,
    )


def _not_run(
    port: Port,
    mode: Mode,
    batch: Sequence[ScenarioFile],
    folder: Path,
    problem: str,
) -> Mapped:
    """No machine of the cluster could run the port."""
    place = folder / f"not-run-{batch[0].name}"
    shutil.rmtree(place, ignore_errors=True)
    place.mkdir(parents=True)
    printed = place.with_name(f"{place.name}.stdout")
    printed.write_bytes(b"")
    finished = Finished(
        port.run, None, False, port.timeout, 0.0, printed, printed, problem
    )
    return Mapped(port, mode, tuple(batch), place, finished)
