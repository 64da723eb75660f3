"""The three files of one map: where a port wrote them, and what is in them."""

from __future__ import annotations

import filecmp
from dataclasses import dataclass
from pathlib import Path

from occgrid_parity.formats.errors import OutputError
from occgrid_parity.formats.log_odds import LogOdds, read_log_odds
from occgrid_parity.formats.pgm import Pixels, read_pgm

SUFFIXES = (".pgm", ".yaml", ".logodds")
YAML_LIMIT = 2**16


@dataclass(frozen=True)
class MapOutput:
    """A map as it was written.

    ``log_odds`` has shape (height, width), smallest y first; ``pixels`` the same
    shape, largest y first, as in the file.
    """

    name: str
    log_odds: LogOdds
    pixels: Pixels
    yaml: bytes


def scenario_name(file: str) -> str:
    """NAME of SPEC section 7: no folder, and nothing from the last dot on."""
    base = file.rsplit("/", 1)[-1]
    dot = base.rfind(".")
    return base[:dot] if dot > 0 else base


def missing_files(folder: Path, name: str) -> list[str]:
    """Which of a map's files the folder does not have."""
    files = [name + suffix for suffix in SUFFIXES]
    return [file for file in files if not (folder / file).is_file()]


def same_files(folder: Path, other: Path, name: str) -> bool:
    """Whether both folders have all files of the map, equal byte for byte."""
    if missing_files(folder, name) or missing_files(other, name):
        return False
    return all(
        filecmp.cmp(folder / file, other / file, shallow=False)
        for file in (name + suffix for suffix in SUFFIXES)
    )


def read_map(folder: Path, name: str) -> MapOutput:
    """Reads a map's files.

    Raises OutputError where one is missing, cannot be read or is not written as
    SPEC section 7 says, or where the sizes of the two grids differ.
    """
    missing = missing_files(folder, name)
    if missing:
        raise OutputError(folder / missing[0], "is missing")
    try:
        pixels = read_pgm(folder / f"{name}.pgm")
        log_odds = read_log_odds(folder / f"{name}.logodds")
        yaml = _read_yaml(folder / f"{name}.yaml")
    except OSError as error:
        path = Path(error.filename or folder)
        raise OutputError(path, error.strerror or "cannot be read") from error
    if pixels.shape != log_odds.shape:
        raise OutputError(
            folder / f"{name}.logodds",
            f"{log_odds.shape[1]} x {log_odds.shape[0]} cells beside a picture of "
            f"{pixels.shape[1]} x {pixels.shape[0]}",
        )
    return MapOutput(name, log_odds, pixels, yaml)


def _read_yaml(path: Path) -> bytes:
    with path.open("rb") as file:
        data = file.read(YAML_LIMIT + 1)
    if len(data) > YAML_LIMIT:
        raise OutputError(path, f"more than {YAML_LIMIT} bytes")
    return data
