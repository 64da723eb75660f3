"""Holds one map against another, bit for bit, and says where they differ."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from occgrid_parity.compare.cell_values import CellValue, cell_value
from occgrid_parity.compare.run_record import CellDifference, Difference
from occgrid_parity.formats.log_odds import bits, hash_log_odds
from occgrid_parity.formats.map_files import MapOutput
from occgrid_parity.formats.pgm import Pixels
from occgrid_parity.suite.golden import GoldenMap

SHOWN_CELLS = 5


def compare_maps(
    found: MapOutput, expected: MapOutput, against: str
) -> list[Difference]:
    """How ``found`` differs from ``expected``: nothing, or a record for each file."""
    differences = []
    name = found.name
    size = _compare_size(found.pixels, expected.pixels, f"{name}.pgm", against)
    if size is not None:
        return [size]
    wrong = bits(found.log_odds) != bits(expected.log_odds)
    if wrong.any():
        cells = [_cell(gx, gy, found, expected) for gx, gy in _first(wrong)]
        differences.append(
            _of_cells(f"{name}.logodds", against, "cells", wrong, cells)
        )
    wrong = (found.pixels != expected.pixels)[::-1]
    if wrong.any():
        cells = [_cell(gx, gy, found, expected) for gx, gy in _first(wrong)]
        differences.append(
            _of_cells(f"{name}.pgm", against, "pixels", wrong, cells)
        )
    if found.yaml != expected.yaml:
        differences.append(_compare_yaml(found, expected, against))
    return differences


def compare_golden(found: MapOutput, golden: GoldenMap) -> list[Difference]:
    """How ``found`` differs from a committed result: picture and hash of the log-odds."""
    against = "golden"
    size = _compare_size(
        found.pixels, golden.pixels, f"{found.name}.pgm", against
    )
    if size is not None:
        return [size]
    differences = []
    digest = hash_log_odds(found.log_odds)
    if digest != golden.scans[-1]:
        differences.append(
            Difference(
                file=f"{found.name}.logodds",
                against=against,
                expected_file=golden.hash_file.name,
                unit="hashes",
                count=1,
                total=1,
                detail=[
                    f"SHA-256 of the log-odds after scan {len(golden.scans) - 1}:",
                    f"found    {digest}",
                    f"expected {golden.scans[-1]}",
                ],
            )
        )
    wrong = (found.pixels != golden.pixels)[::-1]
    if wrong.any():
        height = wrong.shape[0]
        cells = []
        for gx, gy in _first(wrong):
            pixel = int(golden.pixels[height - 1 - gy, gx])
            cells.append(
                CellDifference(gx, gy, _value(gx, gy, found), CellValue(pixel))
            )
        differences.append(
            _of_cells(
                f"{found.name}.pgm", against, "pixels", wrong, cells,
                golden.picture_file.name,
            )
        )  # fmt: skip
    return differences


def _of_cells(
    file: str,
    against: str,
    unit: str,
    wrong: NDArray[np.bool_],
    cells: list[CellDifference],
    expected_file: str | None = None,
) -> Difference:
    count = int(np.count_nonzero(wrong))
    return Difference(
        file,
        against,
        expected_file or file,
        unit,
        count,
        int(wrong.size),
        cells,
    )


def _compare_size(
    found: Pixels, expected: Pixels, file: str, against: str
) -> Difference | None:
    if found.shape == expected.shape:
        return None
    (height, width), (rows, columns) = found.shape, expected.shape
    detail = [f"{width} x {height} cells, expected {columns} x {rows}"]
    return Difference(file, against, file, "sizes", 1, 1, detail=detail)


def _compare_yaml(
    found: MapOutput, expected: MapOutput, against: str
) -> Difference:
    lines = found.yaml.splitlines(keepends=True)
    others = expected.yaml.splitlines(keepends=True)
    total = max(len(lines), len(others))
    lines += [b""] * (total - len(lines))
    others += [b""] * (total - len(others))
    detail = []
    for number, (line, other) in enumerate(zip(lines, others, strict=True), 1):
        if line != other:
            detail += [
                f"line {number}: found    {_quoted(line)}",
                f"line {number}: expected {_quoted(other)}",
            ]
    file = f"{found.name}.yaml"
    shown = detail[: 2 * SHOWN_CELLS]
    count = len(detail) // 2
    return Difference(file, against, file, "lines", count, total, detail=shown)


def _quoted(line: bytes) -> str:
    return (
        repr(line.decode("ascii", "backslashreplace")) if line else "no line"
    )


def _first(wrong: NDArray[np.bool_]) -> Iterator[tuple[int, int]]:
    """gx, gy of the first cells that differ; ``wrong`` has the smallest y first."""
    for index in np.flatnonzero(wrong)[:SHOWN_CELLS]:
        gy, gx = divmod(int(index), wrong.shape[1])
        yield gx, gy


def _cell(
    gx: int, gy: int, found: MapOutput, expected: MapOutput
) -> CellDifference:
    return CellDifference(
        gx, gy, _value(gx, gy, found), _value(gx, gy, expected)
    )


def _value(gx: int, gy: int, output: MapOutput) -> CellValue:
    pixel = int(output.pixels[output.pixels.shape[0] - 1 - gy, gx])
    return cell_value(pixel, float(output.log_odds[gy, gx]))
