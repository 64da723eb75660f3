"""Draws the cells of a beam around a difference, the expected and the found ones side by side."""

from __future__ import annotations

from collections.abc import Mapping

Cell = tuple[int, int]

SIGNS = {"free": "o", "occupied": "#"}
HALF_WIDTH, HALF_HEIGHT = 6, 4


def draw_patch(
    expected: Mapping[Cell, str],
    found: Mapping[Cell, str],
    wrong: set[Cell],
    centre: Cell,
    robot: Cell,
    size: tuple[int, int],
) -> list[str]:
    """Text lines: the row with the largest y first, ``o`` free, ``#`` occupied, ``R`` the robot's cell.

    Cells that are wrong stand in brackets. ``size`` is the grid's width and height.
    """
    (cx, cy), (width, height) = centre, size
    columns = range(max(0, cx - HALF_WIDTH), min(width, cx + HALF_WIDTH + 1))
    rows = range(max(0, cy - HALF_HEIGHT), min(height, cy + HALF_HEIGHT + 1))
    span = 3 * len(columns)
    label = max(len(str(gy)) for gy in rows)
    left, right = columns[0], columns[-1]
    head = f"{'':{label}}  {'expected':<{span}}   found"
    lines = [head.rstrip()]
    for gy in reversed(rows):
        panels = [
            "".join(_sign(cells, wrong, robot, (gx, gy)) for gx in columns)
            for cells in (expected, found)
        ]
        lines.append(f"{gy:>{label}}  {panels[0]}   {panels[1]}".rstrip())
    axis = f"{left:<{max(1, span - len(str(right)))}}{right}"
    lines.append(f"{'':{label}}  {axis}   {axis}")
    return lines


def _sign(
    cells: Mapping[Cell, str], wrong: set[Cell], robot: Cell, cell: Cell
) -> str:
    sign = SIGNS.get(cells.get(cell, ""), ".")
    if cell == robot:
        sign = "R" if sign == "o" else {".": "r", "#": "#"}[sign]
    return f"[{sign}]" if cell in wrong else f" {sign} "
