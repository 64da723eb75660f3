"""What the readings of a log look like, so that a user sees what they will do to the map."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from occgrid.sensor import Scan
from occgrid_parity.logs.conversion import Request

BINS_PER_METRE = 100
BINS = 1000 * BINS_PER_METRE + 1
"""Readings are counted to the centimetre, up to a kilometre: a table instead of all readings."""
FLUSH = 1 << 16
SHOWN_VALUES = 3
FREQUENT = 0.05
SUSPECT_LARGEST = 0.01
SUSPECT_TIMES = 10
SUSPECT_ZEROS = 0.001


class Readings:
    """Counts the readings of scans."""

    def __init__(self) -> None:
        self.scans = self.beams = self.nan = self.infinite = self.zeros = 0
        self.fewest, self.most = 0, 0
        self.least, self.largest = np.inf, -np.inf
        self.table = np.zeros(BINS, dtype=np.int64)
        self.waiting: list[npt.NDArray[np.float64]] = []
        self.waiting_beams = 0

    def add(self, scan: Scan) -> None:
        """Takes in a scan."""
        size = int(scan.ranges.size)
        self.fewest = size if self.scans == 0 else min(self.fewest, size)
        self.most = max(self.most, size)
        self.scans += 1
        self.beams += size
        self.waiting.append(scan.ranges)
        self.waiting_beams += size
        if self.waiting_beams >= FLUSH:
            self._count()

    def notes(self, max_range: float, min_range: float) -> list[str]:
        """Scans, beams, ranges, and what is no return, a line each."""
        self._count()
        per_scan = (
            f"{self.most}"
            if self.fewest == self.most
            else f"{self.fewest} to {self.most}"
        )
        text = f"readings: {self.beams:,} in {self.scans:,} scans of {per_scan} beams"
        if self.table.any():
            text += (
                f"; least {self.least:.2f} m, median {self._median():.2f} m, largest "
                f"{self.largest:.2f} m"
            )
        lines = [text]
        first = self._bin(max_range)
        beyond = int(self.table[first:].sum()) + self.infinite
        if beyond:
            values = ", ".join(
                f"{self._share(count)} at {where}"
                for where, count in self._most_frequent(first)
                if count >= FREQUENT * beyond
            )
            lines.append(
                f"no return, {max_range:g} m or more: {self._share(beyond)}"
                + (f" ({values})" if values else "")
            )
        dropped = [
            f"{self._share(count)} {what}"
            for count, what in (
                (self.zeros, "0"),
                (self.nan, "not a number (NaN)"),
                (self._below(min_range), f"below {min_range:g} m"),
            )
            if count
        ]
        if dropped:
            lines.append(f"of all readings: {', '.join(dropped)}")
        return lines

    def warnings(self, request: Request, max_range: float) -> list[str]:
        """Readings that probably do not mean what the mapper will take them for."""
        self._count()
        said = []
        first = self._bin(max_range)
        if not self.table[first:].any() and self.table.any():
            largest = int(np.flatnonzero(self.table)[-1])
            count = int(self.table[largest])
            if largest and count >= max(
                SUSPECT_LARGEST * self.beams, SUSPECT_TIMES
            ):
                value = largest / BINS_PER_METRE
                below = max(value - 0.02, 0.01)
                said.append(
                    f"{self._share(count)} of the readings are {value:.2f}, the largest that there is: "
                    f"if that means no return, give --max-range {below:g}"
                )
        zeros_count = request.min_range == 0
        if zeros_count and self.zeros >= max(SUSPECT_ZEROS * self.beams, 1):
            said.append(
                f"{self._share(self.zeros)} of the readings are 0: they are taken as hits at the laser; "
                "--min-range 0.01 drops them"
            )
        if (
            request.parameters.get("no_return") != "ignore"
            and self.table[first:].any()
        ):
            said.append(
                f"with no_return free these beams clear the map up to {max_range:g} m, through walls "
                "that they did not see"
            )
        return said

    def _count(self) -> None:
        """Counts the readings that wait."""
        if not self.waiting:
            return
        ranges = np.concatenate(self.waiting)
        self.waiting, self.waiting_beams = [], 0
        self.nan += int(np.isnan(ranges).sum())
        self.infinite += int(np.isposinf(ranges).sum())
        ranges = ranges[np.isfinite(ranges)]
        self.zeros += int((ranges == 0.0).sum())
        if not ranges.size:
            return
        self.least = min(self.least, float(ranges.min()))
        self.largest = max(self.largest, float(ranges.max()))
        bins = np.rint(np.minimum(ranges, 1000.0) * BINS_PER_METRE)
        self.table += np.bincount(bins.astype(np.int64), minlength=BINS)

    def _median(self) -> float:
        half = (int(self.table.sum()) + 1) // 2
        return (
            int(np.searchsorted(np.cumsum(self.table), half)) / BINS_PER_METRE
        )

    def _most_frequent(self, first: int) -> list[tuple[str, int]]:
        """The most frequent values of the bins from ``first`` on."""
        found = [
            (
                f"{index / BINS_PER_METRE:.2f}"
                if index < BINS - 1
                else "1000 or more",
                int(self.table[index]),
            )
            for index in first + np.argsort(-self.table[first:])[:SHOWN_VALUES]
        ]
        found.append(("infinity", self.infinite))
        found.sort(key=lambda one: -one[1])
        return [one for one in found if one[1]][:SHOWN_VALUES]

    def _below(self, min_range: float) -> int:
        return int(self.table[: self._bin(min_range)].sum())

    def _bin(self, value: float) -> int:
        return min(int(np.ceil(value * BINS_PER_METRE - 1e-9)), BINS - 1)

    def _share(self, count: int) -> str:
        percent = 100 * count / max(self.beams, 1)
        return f"{percent:.2g} %" if percent < 10 else f"{percent:.0f} %"
