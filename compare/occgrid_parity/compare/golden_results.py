"""Makes the golden results anew with the Python port; writes them or says what changed."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from occgrid.map_writer import map_pgm
from occgrid.mapper import map_scenario
from occgrid.scenario import read_scenario
from occgrid_parity.formats.errors import OutputError
from occgrid_parity.formats.log_odds import hash_log_odds
from occgrid_parity.formats.text_files import write_text
from occgrid_parity.model.map_history import maps_after_scans
from occgrid_parity.suite.golden import golden_files, hashes_text, read_golden
from occgrid_parity.suite.modes import DEFAULT_MODES, Mode
from occgrid_parity.suite.scenarios import ScenarioFile


@dataclass(frozen=True)
class Fresh:
    """A golden result as the Python port makes it now."""

    name: str
    mode: Mode
    scans: list[str]
    pgm: str


def make_golden(scenario: ScenarioFile, mode: Mode) -> Fresh:
    """Maps a scenario and hashes the log-odds after each scan.

    Raises occgrid.scenario.ScenarioError where the scenario breaks a rule.
    """
    assert scenario.path is not None
    with read_scenario(scenario.path) as opened:
        scans = [
            hash_log_odds(grid.log_odds)
            for grid in maps_after_scans(opened, mode.seed)
        ]
        grid = map_scenario(opened, mode.seed)
    if hash_log_odds(grid.log_odds) != scans[-1]:
        raise AssertionError(
            f"{scenario.name}: the map is not that of the last scan"
        )
    return Fresh(scenario.map, mode, scans, "".join(map_pgm(grid)))


def write_golden(folder: Path, fresh: Fresh) -> None:
    """Writes a result's two files."""
    hash_file, picture_file = golden_files(folder, fresh.name, fresh.mode)
    folder.mkdir(parents=True, exist_ok=True)
    write_text(hash_file, hashes_text(fresh.scans))
    write_text(picture_file, fresh.pgm)


def changes(folder: Path, fresh: Fresh) -> list[str]:
    """How a result differs from the committed one, in words; nothing where it does not."""
    try:
        golden = read_golden(folder, fresh.name, fresh.mode)
    except OutputError as error:
        return [str(error)]
    if golden is None:
        return ["is not there"]
    said = []
    if len(golden.scans) != len(fresh.scans):
        said.append(f"{len(fresh.scans)} scans, committed {len(golden.scans)}")
    pairs = zip(fresh.scans, golden.scans, strict=False)
    wrong = [scan for scan, (new, old) in enumerate(pairs) if new != old]
    if wrong:
        said.append(
            f"the log-odds differ after {len(wrong)} of {len(golden.scans)} scans, "
            f"first after scan {wrong[0]}"
        )
    said += _picture_changes(golden.pixels, fresh)
    return said


def _picture_changes(committed: np.ndarray, fresh: Fresh) -> list[str]:
    rows = [line.split() for line in fresh.pgm.splitlines()[3:]]
    pixels = np.array(rows, dtype=np.uint16)
    if pixels.shape != committed.shape:
        (h, w), (rows_old, columns) = pixels.shape, committed.shape
        return [f"the picture is {w} x {h}, committed {columns} x {rows_old}"]
    wrong = np.flatnonzero((pixels != committed)[::-1])
    if not wrong.size:
        return []
    gy, gx = divmod(int(wrong[0]), pixels.shape[1])
    new, old = pixels[::-1][gy, gx], committed[::-1][gy, gx]
    return [
        f"{wrong.size} of {pixels.size} pixels differ, first at gx={gx} gy={gy}: "
        f"{new}, committed {old}"
    ]


def strays(folder: Path, scenarios: list[ScenarioFile]) -> Iterator[Path]:
    """Files in the golden folder that belong to no scenario and mode."""
    expected = {
        path
        for scenario in scenarios
        for mode in DEFAULT_MODES
        for path in golden_files(folder, scenario.map, mode)
    }
    for path in sorted(folder.glob("*")):
        if path not in expected:
            yield path
