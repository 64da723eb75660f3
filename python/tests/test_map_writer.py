"""map_writer: the three files, to the letter."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from occgrid.grid import GridSpec, OccupancyGrid
from occgrid.map_writer import map_log_odds, map_pgm, map_yaml, write_map


@pytest.fixture
def grid() -> OccupancyGrid:
    grid = OccupancyGrid(GridSpec(3, 2, 0.1, -11.0, 1e6 / 3))
    grid.log_odds[:] = [
        [-8.0, 0.0, 8.0],
        [0.1 + 0.2, -1e-17, 1.0986122886681098],
    ]
    return grid


def test_pgm(grid: OccupancyGrid) -> None:
    assert map_pgm(grid) == "P2\n3 2\n255\n109 128 64\n255 128 0\n"


def test_log_odds_read_back(grid: OccupancyGrid) -> None:
    text = map_log_odds(grid)
    head, *rows = text.splitlines()
    assert head == "# logodds 3 2"
    assert text.endswith("\n")
    values = np.array([row.split(" ") for row in rows], dtype=np.float64)
    assert values.tobytes() == grid.log_odds.tobytes()


def test_yaml(grid: OccupancyGrid) -> None:
    assert map_yaml(grid, "a.pgm") == (
        "image: a.pgm\nmode: trinary\nresolution: 0.1\n"
        "origin: [-11.0, 333333.333333333, 0.0]\n"
        "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n"
    )


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.0, "0.0"),
        (-1e-10, "0.0"),
        (0.05, "0.05"),
        (1000000.0, "1000000.0"),
        (-0.1234567896, "-0.12345679"),
        # 0.0009765625 and 0.0029296875 exactly: ties go to even
        (2.0**-10, "0.000976562"),
        (3.0 * 2.0**-10, "0.002929688"),
    ],
)
def test_fixed_point(value: float, text: str) -> None:
    yaml = map_yaml(OccupancyGrid(GridSpec(1, 1, 1.0, value, 0.0)), "a.pgm")
    assert f"origin: [{text}, 0.0, 0.0]" in yaml


def test_write_map(grid: OccupancyGrid, tmp_path: Path) -> None:
    folder = tmp_path / "made" / "here"
    write_map(folder, "map", grid)
    write_map(folder, "map", grid)
    names = sorted(file.name for file in folder.iterdir())
    assert names == ["map.logodds", "map.pgm", "map.yaml"]
    assert (folder / "map.pgm").read_bytes() == map_pgm(grid).encode()


def test_nothing_half_written(
    grid: OccupancyGrid, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "map.pgm").write_text("the old map")
    monkeypatch.setattr(OccupancyGrid, "log_odds", None, raising=False)
    writing = Path.write_text

    def full_disk(self: Path, *args: str, **kwargs: str) -> int:
        if "logodds" in self.name:
            raise OSError(28, "No space left on device")
        return writing(self, *args, **kwargs)

    monkeypatch.setattr(Path, "write_text", full_disk)
    with pytest.raises(OSError, match="No space") as caught:
        write_map(tmp_path, "map", grid)
    assert caught.value.filename == str(tmp_path / "map.logodds")
    assert [file.name for file in tmp_path.iterdir()] == ["map.pgm"]
    assert (tmp_path / "map.pgm").read_text() == "the old map"
