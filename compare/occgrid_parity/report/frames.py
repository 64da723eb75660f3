"""The reference's picture as the scans come in, for the scrubber of the page."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from occgrid.grid import OccupancyGrid
from occgrid.lesson import lesson_scenario
from occgrid.map_writer import pixel
from occgrid.scenario import Scenario, read_scenario
from occgrid.sensor import Scan
from occgrid.world import Pose
from occgrid_parity.model.map_history import maps_after_scans
from occgrid_parity.report.packing import pack_frames

Picture = NDArray[np.uint8]

MOST_FRAMES = 64
MOST_BYTES = 1 << 24  # of all frames of a case, before they are packed


@dataclass(frozen=True)
class Frames:
    """Pictures after some of the scans.

    ``scans``: the number of scans mapped in each; ``total``: scans there are; ``poses``: x, y, theta of the last of
    them; ``pixels``: the pictures packed, as pack_frames does it.
    """

    scans: list[int]
    total: int
    poses: list[Pose]
    pixels: str


def lesson_or_file(path: Path | None) -> Scenario:
    """The scenario of a file, or the built-in lesson."""
    return lesson_scenario() if path is None else read_scenario(path)


def record_frames(
    scenario: Scenario, seed: int | None, wanted: Collection[int] = ()
) -> Frames:
    """Map a scenario with the reference and keep pictures, evenly spread.

    The picture after the first scan is always kept, and those after the ``wanted`` numbers of scans. Raises
    ScenarioError where a scan breaks a rule.
    """
    settings = scenario.settings
    limit = MOST_BYTES // (settings.width * settings.height)
    kept = _Kept(max(2, min(MOST_FRAMES, limit)), {1, *wanted})
    poses: list[Pose] = []

    def watched() -> Iterator[Pose | Scan]:
        for scan in scenario.scans:
            poses.append(scan.pose if isinstance(scan, Scan) else scan)
            yield scan

    seen = Scenario(scenario.name, settings, scenario.walls, watched())
    for grid in maps_after_scans(seen, seed):
        kept.after_scan(grid, poses[-1])
        del poses[:-1]
    return kept.frames()


class _Kept:
    """Keeps every n-th picture, and twice n as soon as there are too many; those that are ``always`` kept, too."""

    def __init__(self, most: int, always: set[int]) -> None:
        self.most = most
        self.always = always
        self.every = 1
        self.total = 0
        self.pictures: dict[int, Picture] = {}
        self.poses: dict[int, Pose] = {}
        self.log_odds: NDArray[np.float64] | None = None
        self.picture = np.zeros((0, 0), dtype=np.uint8)

    def after_scan(self, grid: OccupancyGrid, pose: Pose) -> None:
        """Takes the picture of a scan, if it is its turn."""
        self.total += 1
        self.grid = grid
        self.pose = pose
        if self.total % self.every == 0 or self.total in self.always:
            self.take()
        if len(self.pictures) > self.most + len(self.always):
            self.every *= 2
            self.pictures = {
                n: picture
                for n, picture in self.pictures.items()
                if n % self.every == 0 or n in self.always
            }

    def take(self) -> None:
        """Takes a picture: only the cells that changed since the last one are computed."""
        log_odds = self.grid.log_odds
        if self.log_odds is None:
            self.picture = pixel(log_odds).astype(np.uint8)
        else:
            changed = log_odds != self.log_odds
            self.picture = self.picture.copy()
            self.picture[changed] = pixel(log_odds[changed])
        self.log_odds = log_odds.copy()
        self.pictures[self.total] = self.picture[::-1]
        self.poses[self.total] = self.pose

    def frames(self) -> Frames:
        """All kept pictures, the one after the last scan among them."""
        if self.total not in self.pictures:
            self.take()
        return Frames(
            list(self.pictures),
            self.total,
            [self.poses[n] for n in self.pictures],
            pack_frames(np.stack(list(self.pictures.values()))),
        )
