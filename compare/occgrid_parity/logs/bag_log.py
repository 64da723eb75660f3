"""The scans of a ROS bag."""

from __future__ import annotations

import math
from collections import Counter, deque
from collections.abc import Iterator
from decimal import Decimal
from typing import TYPE_CHECKING, Any, NamedTuple

from occgrid_parity.logs.bag_messages import (
    SCAN,
    Bag,
    frame_name,
    nanoseconds,
    open_bag,
)
from occgrid_parity.logs.bag_poses import BagPoses, PoseSource
from occgrid_parity.logs.conversion import (
    MAX_RANGE,
    ConversionError,
    Entry,
    Request,
)
from occgrid_parity.logs.laser_scans import (
    LARGEST_COORDINATE,
    MOST_TILT,
    LaserPose,
    entry_of,
    is_usable,
    laser_pose,
    shortest,
)
from occgrid_parity.logs.transforms import When

if TYPE_CHECKING:
    from rosbags.interfaces import Connection

LONGEST_WAIT = 10_000_000_000
"""Nanoseconds that a scan waits for the transform after it; as long as ROS itself remembers transforms."""
SHOWN_TILT = math.radians(1)

UNUSABLE = "without beams or bearings"
TILTED = f"tilted by more than {math.degrees(MOST_TILT):.0f} degrees"
FAR_AWAY = "too far away"
UNCONNECTED = "in a frame that nothing connects with the map's"


class _Waiting(NamedTuple):
    """A scan whose pose is not known yet."""

    message: Any
    time: int
    recorded: int


class BagLog:
    """A ROS bag as a Source."""

    def __init__(self, request: Request) -> None:
        self.request = request
        self.max_range = request.max_range or MAX_RANGE
        self.scans = 0
        self.skipped: Counter[str] = Counter()
        self.tilt = 0.0
        self.upside_down = 0
        self.said: list[str] = []
        self.warned: list[str] = []

    def entries(self) -> Iterator[Entry]:
        """The chosen scans whose pose is known, in the order of the bag."""
        with open_bag(self.request.log) as bag:
            scans = self._scan_connections(bag)
            first = next(m for _, _, m in bag.messages(scans))
            if self.request.max_range is None:
                self.max_range = min(MAX_RANGE, _stated_range(first))
            poses = BagPoses(bag)
            source = poses.choose(
                frame_name(first.header.frame_id), self.request.frame
            )
            self.said.append(source.note)
            self.warned += source.warnings
            yield from self._entries(bag, scans, poses, source)
        if sum(self.skipped.values()) == self.scans:
            raise ConversionError(
                f"{self.request.log}: none of its {self.scans:,} scans can be used: {self._skipped()}"
            )

    def total(self) -> int:
        """How many scans the topic has."""
        return self.scans

    def notes(self) -> list[str]:
        """The topic, and what gives the poses."""
        hangs = (
            f"; the laser hangs upside down in {self.upside_down:,}"
            if self.upside_down
            else ""
        )
        return [*self.said, f"scans: {self.scans:,} in the topic{hangs}"]

    def warnings(self) -> list[str]:
        """Scans that are skipped, and what is uncertain."""
        said = list(self.warned)
        if self.skipped:
            said.append(f"scans skipped: {self._skipped()}")
        if self.tilt > SHOWN_TILT:
            said.append(
                f"the laser is tilted by up to {math.degrees(self.tilt):.1f} degrees; its ranges are taken "
                "as they are"
            )
        return said

    def _scan_connections(self, bag: Bag) -> list[Connection]:
        """The connections of the topic with the scans."""
        found = bag.connections(SCAN)
        counts: Counter[str] = Counter()
        for connection in found:
            counts[connection.topic] += connection.msgcount
        listed = ", ".join(
            f"{topic} ({counts[topic]:,})" for topic in sorted(counts)
        )
        topic = self.request.topic
        if not found:
            others = sorted(
                {f"{c.topic} ({c.msgtype})" for c in bag.reader.connections}
            )
            raise ConversionError(
                f"{bag.path}: no topic of LaserScan; found {', '.join(others[:12]) or 'no topic'}"
            )
        if topic is None and len(counts) > 1:
            raise ConversionError(
                f"{bag.path}: several topics of LaserScan: choose one with --topic: {listed}"
            )
        chosen = [c for c in found if topic is None or c.topic == topic]
        if not chosen:
            raise ConversionError(
                f"{bag.path}: no LaserScan in {topic}; found {listed}"
            )
        self.said.append(f"topic: {chosen[0].topic}")
        return chosen

    def _entries(
        self,
        bag: Bag,
        scans: list[Connection],
        poses: BagPoses,
        source: PoseSource,
    ) -> Iterator[Entry]:
        """Scans wait until the transforms around their time are there; transforms go when no scan needs them."""
        waiting: deque[_Waiting] = deque()
        topics = {connection.topic for connection in scans}
        for connection, recorded, message in bag.messages(
            [*scans, *source.connections]
        ):
            if connection.topic in topics:
                chosen = self.request.selection.holds(self.scans)
                self.scans += 1
                time = nanoseconds(message.header.stamp)
                if not chosen:
                    pass
                elif is_usable(message):
                    waiting.append(_Waiting(message, time, recorded))
                else:
                    self.skipped[UNUSABLE] += 1
                oldest = waiting[0].time if waiting else time
                poses.tree.forget_before(oldest - LONGEST_WAIT)
            else:
                poses.take(connection, message)
            yield from self._ready(waiting, poses, source, recorded)
        yield from self._ready(waiting, poses, source, None)

    def _ready(
        self,
        waiting: deque[_Waiting],
        poses: BagPoses,
        source: PoseSource,
        now: int | None,
    ) -> Iterator[Entry]:
        """The scans at the head whose fate is known; ``now`` is None at the end of the bag."""
        while waiting:
            one = waiting[0]
            late = now is None or now - one.recorded > LONGEST_WAIT
            frame = frame_name(one.message.header.frame_id)
            chain = poses.tree.chain(frame, source.root)
            if chain is None:
                if not late:
                    return
                seen = frame in poses.tree.parents
                self.skipped[When.BEFORE.value if seen else UNCONNECTED] += 1
            else:
                when = poses.tree.when(chain, one.time)
                if when is When.AFTER and not late:
                    return
                if when is When.WITHIN:
                    pose = laser_pose(poses.tree.at(chain, one.time))
                    entry = self._entry(one, pose)
                    if entry is not None:
                        yield entry
                else:
                    self.skipped[when.value] += 1
            waiting.popleft()

    def _entry(self, one: _Waiting, pose: LaserPose) -> Entry | None:
        """The scan's line, unless its pose is of no use to a map."""
        if pose.tilt > MOST_TILT:
            self.skipped[TILTED] += 1
            return None
        if max(abs(pose.x), abs(pose.y)) > LARGEST_COORDINATE:
            self.skipped[FAR_AWAY] += 1
            return None
        self.tilt = max(self.tilt, pose.tilt)
        self.upside_down += pose.upside_down
        seconds = f"{one.time // 1_000_000_000}.{one.time % 1_000_000_000:09d}"
        return entry_of(one.message, pose, seconds)

    def _skipped(self) -> str:
        return ", ".join(
            f"{count:,} {why}" for why, count in self.skipped.most_common()
        )


def _stated_range(message: Any) -> Decimal:
    """The sensor's range_max; without limit where it says none."""
    stated = shortest(message.range_max)
    if not 0.0 < stated < math.inf:
        return MAX_RANGE
    return Decimal(repr(stated))
