"""map_writer: the three files, to the letter."""

from __future__ import annotations

import itertools
import os
import re
import sys
import time
import tracemalloc
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest

from occgrid import map_writer
from occgrid.grid import GridSpec, OccupancyGrid
from occgrid.map_writer import (
    map_log_odds,
    map_pgm,
    map_yaml,
    pixel,
    write_map,
)


@pytest.fixture
def grid() -> OccupancyGrid:
    grid = OccupancyGrid(GridSpec(3, 2, 0.1, -11.0, 1e6 / 3))
    grid.log_odds[:] = [
        [-8.0, 0.0, 8.0],
        [0.1 + 0.2, -1e-17, 1.0986122886681098],
    ]
    return grid


def test_pgm(grid: OccupancyGrid) -> None:
    assert "".join(map_pgm(grid)) == "P2\n3 2\n255\n109 128 64\n255 128 0\n"


def test_log_odds_read_back(grid: OccupancyGrid) -> None:
    text = "".join(map_log_odds(grid))
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
    assert (folder / "map.pgm").read_bytes() == "".join(map_pgm(grid)).encode()


@pytest.mark.parametrize(
    ("width", "height"), [(1, 40000), (40000, 1), (300, 260)]
)
def test_the_pieces_of_a_picture(width: int, height: int) -> None:
    """Rows that are computed together, or one by one."""
    grid = OccupancyGrid(GridSpec(width, height, 0.1, 0.0, 0.0))
    rng = np.random.default_rng(width)
    grid.log_odds[:] = rng.uniform(-8.0, 8.0, (height, width))
    _, _, _, *rows = "".join(map_pgm(grid)).splitlines()
    found = np.array([row.split(" ") for row in rows], dtype=np.int64)
    assert (found == pixel(grid.log_odds)[::-1]).all()


@pytest.mark.parametrize("shape", [(3000, 1000), (1000, 3000)])
def test_memory_of_the_texts(shape: tuple[int, int]) -> None:
    """Less than a twentieth of the grid's own, which is 24 MB."""
    height, width = shape
    grid = OccupancyGrid(GridSpec(width, height, 0.1, 0.0, 0.0))
    for text in (map_pgm, map_log_odds):
        tracemalloc.start()
        for _ in itertools.islice(text(grid), 200):
            pass
        _, most = tracemalloc.get_traced_memory()
        tracemalloc.stop()
        assert most < grid.log_odds.nbytes / 8, text.__name__


# --- YAML ---


@pytest.mark.parametrize(
    ("name", "shown"),
    [
        ("intel.gfs_2-b", "intel.gfs_2-b.pgm"),
        ("yes", "yes.pgm"),  # with its ending it is no truth value,
        ("1", "1.pgm"),  # and no number
        ("run #2", '"run #2.pgm"'),
        ("lab: monday", '"lab: monday.pgm"'),
        ("[x]", '"[x].pgm"'),
        ("@x", '"@x.pgm"'),
        ("'q'", "\"'q'.pgm\""),
        ("%x", '"%x.pgm"'),
        ("*x", '"*x.pgm"'),
        ("- x", '"- x.pgm"'),
        ("-x", '"-x.pgm"'),
        (".x", '".x.pgm"'),
        ("", '".pgm"'),
        ('a"b\\c', '"a\\"b\\\\c.pgm"'),
        ("a\tb\nc\x7f", '"a\\x09b\\x0Ac\\x7F.pgm"'),
        ("gr\u00fc\u00df", '"gr\u00fc\u00df.pgm"'),
    ],
)
def test_yaml_quotes_what_needs_it(
    grid: OccupancyGrid, name: str, shown: str
) -> None:
    text = map_yaml(grid, f"{name}.pgm")
    assert text.startswith(f"image: {shown}\nmode:")
    assert unquoted(shown) == f"{name}.pgm"


def unquoted(text: str) -> str:
    """What YAML reads: the rules of section 5.7 of its specification, as far as they are used here."""
    if not text.startswith('"'):
        assert re.fullmatch(r"[A-Za-z0-9_][A-Za-z0-9_.-]*", text)
        return text
    body = re.fullmatch(r'"((?:[^"\\\x00-\x1f\x7f]|\\.)*)"', text)
    assert body is not None
    return re.sub(
        r"\\(x[0-9A-F]{2}|.)",
        lambda m: chr(int(m[1][1:], 16)) if len(m[1]) > 1 else m[1],
        body[1],
    )


def thresholds(p0: float) -> tuple[float, float]:
    grid = OccupancyGrid(GridSpec(1, 1, 0.1, 0.0, 0.0), p0, 0.9, 0.1, -30, 30)
    lines = dict(
        line.split(": ") for line in map_yaml(grid, "a.pgm").splitlines()
    )
    return float(lines["occupied_thresh"]), float(lines["free_thresh"])


@pytest.mark.parametrize("p0", np.linspace(0.002, 0.998, 167).tolist())
def test_a_cell_at_the_prior_loads_as_unknown(p0: float) -> None:
    """By map_server's rule: its occupancy is (255 - pixel) / 255."""
    occupied, free = thresholds(p0)
    grid = OccupancyGrid(GridSpec(1, 1, 0.1, 0.0, 0.0), p0)
    occupancy = (255 - int(pixel(grid.log_odds)[0, 0])) / 255.0
    assert free < occupancy < occupied


@pytest.mark.parametrize(
    ("p0", "expected"),
    [
        (0.5, (0.65, 0.196)),
        (0.7, (13 / 16, 343 / 946)),  # odds 7/3, times 13/7 and times 49/201
        (0.15, (39 / 158, 147 / 3564)),
        (0.001, (0.001960784, 0.0)),  # pixel 255: nothing is free
        (0.999, (1.0, 48951 / 49152)),  # pixel 0: nothing is occupied
        (0.5 + 1e-12, (0.65, 0.196)),
    ],
)
def test_thresholds_follow_the_prior(
    p0: float, expected: tuple[float, float]
) -> None:
    assert thresholds(p0) == pytest.approx(expected, abs=6e-10)


# --- Files ---


def full_disk(
    monkeypatch: pytest.MonkeyPatch, which: Callable[..., Iterator[str]]
) -> None:
    """Have the writing of one text fail in the midst of it."""

    def text(grid: OccupancyGrid) -> Iterator[str]:
        yield from itertools.islice(which(grid), 2)
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(map_writer, which.__name__, text)


@pytest.mark.parametrize("which", [map_pgm, map_log_odds])
def test_nothing_half_written(
    grid: OccupancyGrid,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    which: Callable[..., Iterator[str]],
) -> None:
    (tmp_path / "map.pgm").write_text("the old map")
    full_disk(monkeypatch, which)
    with pytest.raises(OSError, match="No space") as caught:
        write_map(tmp_path, "map", grid)
    kind = {"map_pgm": "pgm", "map_log_odds": "logodds"}[which.__name__]
    assert caught.value.filename == f"{tmp_path}/map.{kind}"
    assert [file.name for file in tmp_path.iterdir()] == ["map.pgm"]
    assert (tmp_path / "map.pgm").read_text() == "the old map"


@pytest.mark.parametrize("kind", ["pgm", "yaml", "logodds"])
def test_a_folder_in_the_way(
    grid: OccupancyGrid, tmp_path: Path, kind: str
) -> None:
    (tmp_path / f"map.{kind}").mkdir()
    with pytest.raises(OSError) as caught:
        write_map(tmp_path, "map", grid)
    assert caught.value.filename == f"{tmp_path}/map.{kind}"
    assert [file.name for file in tmp_path.iterdir()] == [f"map.{kind}"]


@pytest.mark.parametrize("fails", ["pgm", "yaml", "logodds"])
def test_a_renaming_that_fails_undoes_the_others(
    grid: OccupancyGrid,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    fails: str,
) -> None:
    renaming = Path.replace

    def replace(self: Path, target: Path) -> Path:
        if target.suffix == f".{fails}":
            raise PermissionError(13, "Permission denied")
        return renaming(self, target)

    monkeypatch.setattr(Path, "replace", replace)
    (tmp_path / f"map.{fails}").write_text("the old one")
    with pytest.raises(PermissionError) as caught:
        write_map(tmp_path, "map", grid)
    assert caught.value.filename == f"{tmp_path}/map.{fails}"
    assert [file.name for file in tmp_path.iterdir()] == [f"map.{fails}"]
    assert (tmp_path / f"map.{fails}").read_text() == "the old one"


@pytest.mark.skipif(os.name == "nt", reason="the limit is asked by POSIX")
def test_long_names(grid: OccupancyGrid, tmp_path: Path) -> None:
    """As long as its files can be; one more is refused, and nothing is left."""
    longest = os.pathconf(tmp_path, "PC_NAME_MAX") - len(".logodds")
    write_map(tmp_path, "x" * longest, grid)
    assert len(list(tmp_path.iterdir())) == 3
    too_long = "y" * (longest + 1)
    with pytest.raises(OSError) as caught:
        write_map(tmp_path, too_long, grid)
    assert caught.value.filename == f"{tmp_path}/{too_long}.logodds"
    assert len(list(tmp_path.iterdir())) == 3


@pytest.mark.skipif(
    sys.platform in ("win32", "darwin"),
    reason="names are bytes on Linux; elsewhere they are Unicode",
)
@pytest.mark.parametrize(
    "name", ["a b", "-x", "\u00fc", "n\nl", "b\\c~*", "\udcff"]
)
def test_odd_names(grid: OccupancyGrid, tmp_path: Path, name: str) -> None:
    """What the system takes is written; \\udcff is the byte FF, which is no UTF-8."""
    write_map(tmp_path, name, grid)
    names = {file.name for file in tmp_path.iterdir()}
    assert names == {f"{name}.{kind}" for kind in ("pgm", "yaml", "logodds")}
    yaml = (tmp_path / f"{name}.yaml").read_bytes().splitlines()
    if name == "\udcff":
        assert yaml[0] == b'image: "\xff.pgm"'


@pytest.mark.parametrize("given", ["o", "o/", "./o//q/", "."])
def test_the_path_in_errors(
    grid: OccupancyGrid,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    given: str,
) -> None:
    """The folder as it was given, without slashes at its end."""
    monkeypatch.chdir(tmp_path)
    write_map(given, "map", grid)
    (tmp_path / given / "new.pgm").mkdir()
    with pytest.raises(OSError) as caught:
        write_map(given, "new", grid)
    assert caught.value.filename == f"{given.rstrip('/')}/new.pgm"
    (tmp_path / "file").touch()
    for folder in ("file//", "file/below/"):
        with pytest.raises(OSError) as caught:
            write_map(folder, "map", grid)
        assert caught.value.filename == folder.rstrip("/")


def test_leftovers_of_killed_runs(grid: OccupancyGrid, tmp_path: Path) -> None:
    """Those of the form that SPEC.md gives, when they are a day old; nothing else."""
    old = time.time() - 25 * 60 * 60
    leftovers = [".occgrid-1-a-Z9.part", f".occgrid-{'x' * 40}.part"]
    others = [".occgrid-new.part", ".occgrid-.part", ".occgrid-a_b.part",
              f".occgrid-{'x' * 41}.part", "occgrid-1.part", ".occgrid-1.part.gz"]  # fmt: skip
    for name in leftovers + others:
        file = tmp_path / name
        file.touch()
        if name != ".occgrid-new.part":
            os.utime(file, (old, old))
    folder = tmp_path / ".occgrid-folder.part"
    folder.mkdir()
    os.utime(folder, (old, old))
    write_map(tmp_path, "map", grid)
    hidden = {file.name for file in tmp_path.iterdir()} - {
        f"map.{kind}" for kind in ("pgm", "yaml", "logodds")
    }
    assert hidden == {*others, folder.name}
