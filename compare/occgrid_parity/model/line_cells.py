"""The cells of many lines at once: the contract's way, and other ways that people take."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from occgrid_parity.model.array_types import Array, Cells, Mask

Minor = Callable[[Cells, Cells, Cells], Cells]
"""minor(k, a, b): cells gone along the shorter axis after k along the longer."""


class Lines(NamedTuple):
    """Cells of lines, line after line, each in order; all (n,). ``last`` marks the end of each."""

    beam: Cells
    gx: Cells
    gy: Cells
    last: Mask

    def where(self, chosen: Mask | Cells) -> Lines:
        """Some of the cells, or all of them in another order or number."""
        return Lines(
            self.beam[chosen],
            self.gx[chosen],
            self.gy[chosen],
            self.last[chosen],
        )


def _steps(lengths: Cells) -> tuple[Cells, Cells]:
    """For lines of so many cells: the line of each cell, and its number in the line."""
    line = np.repeat(np.arange(lengths.size), lengths)
    before = np.cumsum(lengths) - lengths
    return line, np.arange(line.size) - before[line]


def contract_minor(k: Cells, a: Cells, b: Cells) -> Cells:
    """The closed form of SPEC.md section 2.4."""
    return (2 * k * b + a - 1) // (2 * a)


def contract_lines(gx0: Cells, gy0: Cells, gx1: Cells, gy1: Cells) -> Lines:
    """SPEC.md section 2.4."""
    return lines_with(contract_minor, gx0, gy0, gx1, gy1)


def lines_with(
    minor: Minor, gx0: Cells, gy0: Cells, gx1: Cells, gy1: Cells
) -> Lines:
    """Lines that go one cell along the longer axis at each step, and ``minor`` along the other."""
    dx, dy = np.abs(gx1 - gx0), np.abs(gy1 - gy0)
    sx, sy = np.where(gx0 < gx1, 1, -1), np.where(gy0 < gy1, 1, -1)
    a, b = np.maximum(dx, dy), np.minimum(dx, dy)
    line, k = _steps(a + 1)
    m = minor(k, np.maximum(a, 1)[line], b[line])
    along_x = (dx >= dy)[line]
    gx = gx0[line] + sx[line] * np.where(along_x, k, m)
    gy = gy0[line] + sy[line] * np.where(along_x, m, k)
    return Lines(line, gx, gy, k == a[line])


def straight_lines(
    rounded: Callable[[Array], Array],
    gx0: Cells,
    gy0: Cells,
    gx1: Cells,
    gy1: Cells,
) -> Lines:
    """Points of the straight line, one for each step along the longer axis, ``rounded`` to cells."""
    dx, dy = gx1 - gx0, gy1 - gy0
    a = np.maximum(np.abs(dx), np.abs(dy))
    line, k = _steps(a + 1)
    most = np.maximum(a, 1)[line]
    gx = rounded(gx0[line] + dx[line] * k / most)
    gy = rounded(gy0[line] + dy[line] * k / most)
    return Lines(line, gx.astype(np.int64), gy.astype(np.int64), k == a[line])


Step = Callable[[Cells, Cells, Cells], tuple[Mask, Mask]]
"""step(e2, dx, dy): whether to go along x, and along y."""


def walked_lines(
    step: Step, gx0: Cells, gy0: Cells, gx1: Cells, gy1: Cells
) -> Lines:
    """The loop of SPEC.md section 2.4 with other conditions; all lines take a step at once.

    A line that misses its end is given up after twice as many steps as it should need.
    """
    dx, dy = np.abs(gx1 - gx0), np.abs(gy1 - gy0)
    sx, sy = np.where(gx0 < gx1, 1, -1), np.where(gy0 < gy1, 1, -1)
    gx, gy, err = gx0.copy(), gy0.copy(), dx - dy
    going = np.arange(gx0.size)
    found: list[tuple[Cells, Cells, Cells, Mask]] = []
    for _ in range(2 * int(np.max(dx + dy, initial=0)) + 1):
        ended = (gx[going] == gx1[going]) & (gy[going] == gy1[going])
        found.append((going, gx[going], gy[going], ended))
        going = going[~ended]
        if not going.size:
            break
        e2 = 2 * err[going]
        along_x, along_y = step(e2, dx[going], dy[going])
        err[going] += np.where(along_x, -dy[going], 0)
        err[going] += np.where(along_y, dx[going], 0)
        gx[going] += np.where(along_x, sx[going], 0)
        gy[going] += np.where(along_y, sy[going], 0)
    columns = [np.concatenate(column) for column in zip(*found, strict=True)]
    lines = Lines(columns[0], columns[1], columns[2], columns[3].astype(bool))
    return lines.where(np.argsort(lines.beam, kind="stable"))


def reversed_lines(
    turned: Mask, gx0: Cells, gy0: Cells, gx1: Cells, gy1: Cells
) -> Lines:
    """The contract's lines, those that are ``turned`` computed from their far end."""
    lines = contract_lines(
        np.where(turned, gx1, gx0),
        np.where(turned, gy1, gy0),
        np.where(turned, gx0, gx1),
        np.where(turned, gy0, gy1),
    )
    at_end = (lines.gx == gx1[lines.beam]) & (lines.gy == gy1[lines.beam])
    number = np.arange(lines.beam.size)
    key = np.where(turned[lines.beam], -number, number)
    order = np.lexsort((key, lines.beam))
    return lines._replace(last=at_end).where(order)


def supercover_lines(
    gx0: Cells, gy0: Cells, gx1: Cells, gy1: Cells, corners: bool
) -> Lines:
    """Every cell that the line between the two cells' centres passes through.

    Where it passes exactly through a corner, with ``corners`` both cells beside the corner
    belong to it, the one along x first.
    """
    dx, dy = np.abs(gx1 - gx0), np.abs(gy1 - gy0)
    sx, sy = np.where(gx0 < gx1, 1, -1), np.where(gy0 < gy1, 1, -1)
    gx, gy = gx0.copy(), gy0.copy()
    gone_x, gone_y = np.zeros_like(dx), np.zeros_like(dy)
    going = np.arange(gx0.size)
    found: list[tuple[Cells, Cells, Cells, Mask]] = []
    while True:
        ended = (gone_x[going] == dx[going]) & (gone_y[going] == dy[going])
        found.append((going, gx[going], gy[going], ended))
        going = going[~ended]
        if not going.size:
            break
        # which border comes first: (2 i + 1) / (2 dx) against (2 j + 1) / (2 dy)
        along_x = (2 * gone_x[going] + 1) * dy[going]
        along_y = (2 * gone_y[going] + 1) * dx[going]
        if corners:
            tie = going[along_x == along_y]
            no = np.zeros(tie.size, dtype=bool)
            found.append((tie, gx[tie] + sx[tie], gy[tie], no))
            found.append((tie, gx[tie], gy[tie] + sy[tie], no))
        go_x, go_y = going[along_x <= along_y], going[along_y <= along_x]
        gx[go_x] += sx[go_x]
        gone_x[go_x] += 1
        gy[go_y] += sy[go_y]
        gone_y[go_y] += 1
    columns = [np.concatenate(column) for column in zip(*found, strict=True)]
    lines = Lines(columns[0], columns[1], columns[2], columns[3].astype(bool))
    return lines.where(np.argsort(lines.beam, kind="stable"))
