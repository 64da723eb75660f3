"""The vectors that all ports share: scenarios/vectors/NAME.csv holds what the probe's function NAME answers."""

from __future__ import annotations

from pathlib import Path

import probe
import pytest

from occgrid.sensor import beam_endpoints
from occgrid.world import Pose

VECTORS = Path(__file__).parents[2] / "scenarios" / "vectors"

# how many of a file's columns are input
INPUTS = {
    "sin": 1, "cos": 1, "exp": 1, "log": 1, "logit": 1, "sigmoid": 1,
    "world_to_grid": 5, "bresenham": 4, "clip_ray": 6, "flaser_angles": 2,
    "read_ranges": 3, "beam_endpoints": 5, "update_cell": 6, "pixel": 1,
    "philox": 6, "normal_deviate": 3,
}  # fmt: skip


def vectors(function: str) -> tuple[list[list[str]], list[str]]:
    """The inputs of a file, and the answers to them."""
    text = (VECTORS / f"{function}.csv").read_text(encoding="ascii")
    lines = [line.split(",") for line in text.splitlines()[1:]]
    n = INPUTS[function]
    return [line[:n] for line in lines], [" ".join(line[n:]) for line in lines]


def test_every_file_is_looked_at() -> None:
    assert {file.stem for file in VECTORS.glob("*.csv")} == set(INPUTS)
    assert set(INPUTS) == set(probe.ANSWERS)


@pytest.mark.parametrize("function", INPUTS)
def test_vectors(function: str) -> None:
    rows, expected = vectors(function)
    assert rows
    assert list(probe.ANSWERS[function](rows)) == expected


def test_a_pose_for_each_beam() -> None:
    """beam_endpoints of all rows at once, with poses that are arrays."""
    rows, expected = vectors("beam_endpoints")
    x, y, theta, angles, z = (
        probe.doubles(column) for column in zip(*rows, strict=True)
    )
    ex, ey = beam_endpoints(Pose(x, y, theta), angles, z)  # type: ignore[arg-type]
    found = zip(probe.double_words(ex), probe.double_words(ey), strict=True)
    assert [" ".join(pair) for pair in found] == expected


def test_the_probe(tmp_path: Path) -> None:
    source, target = tmp_path / "in", tmp_path / "out"
    source.write_text("0 0 4 2 9 9\n-5 -5 -1 -1 9 9\n-2 0 12 0 9 9\n")
    probe.main("clip_ray", str(source), str(target))
    assert target.read_bytes() == b"0 4\n0 -1\n2 10\n"
    source.write_text("1 1 -1 0\n")
    probe.main("bresenham", str(source), str(target))
    assert target.read_bytes() == b"1:1 0:1 -1:0\n"
    # SPEC 3.3's known answer
    source.write_text(
        "243f6a88 85a308d3 13198a2e 03707344 a4093822 299f31d0\n"
    )
    probe.main("philox", str(source), str(target))
    assert target.read_text() == "d16cfe09 94fdcceb 5001e420 24126ea1\n"
