"""Where the laser of a bag was at the time of a scan: by TF, else by an odometry topic."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from occgrid_parity.logs.bag_messages import (
    ODOMETRY,
    TRANSFORMS,
    Bag,
    frame_name,
    nanoseconds,
    transform_of,
)
from occgrid_parity.logs.conversion import ConversionError
from occgrid_parity.logs.transforms import IDENTITY, FrameTree, Transform

if TYPE_CHECKING:
    from rosbags.interfaces import Connection

FRAMES = ("map", "odom")
"""The frames that a map is drawn in where none is asked for, the better one first."""
SHOWN_FRAMES = 12


@dataclass(frozen=True)
class PoseSource:
    """What gives the poses: the frame of the map, its name for the user, and the connections to read."""

    root: str
    note: str
    warnings: list[str]
    connections: list[Connection]


class BagPoses:
    """The frames of a bag while it is read."""

    def __init__(self, bag: Bag) -> None:
        self.bag = bag
        self.tree = FrameTree()
        found = bag.connections(*TRANSFORMS)
        static = [c for c in found if _is_static(c)]
        self.moving = [c for c in found if not _is_static(c)]
        for connection, _, message in bag.messages(static):
            self.take(connection, message)

    def choose(self, laser: str, frame: str | None) -> PoseSource:
        """Finds what connects the laser with the frame that is asked for, or with the best there is.

        Raises ConversionError where nothing does.
        """
        wanted = FRAMES if frame is None else (frame_name(frame),)
        names = FrameTree()
        names.parents = dict(self.tree.parents)
        root = self._connected(names, laser, wanted)
        if root is not None:
            chain = names.chain(laser, root) or []
            path = " > ".join([root, *(child for _, child in chain)])
            return PoseSource(root, f"poses: TF, {path}", [], self.moving)
        source = self._odometry(names, laser, frame)
        if source is not None:
            return source
        frames = sorted({*names.parents, *names.parents.values()})
        shown = ", ".join(frames[:SHOWN_FRAMES]) or "none"
        more = " and more" if len(frames) > SHOWN_FRAMES else ""
        raise ConversionError(
            f"{self.bag.path}: nothing says where {laser} is in {' or '.join(wanted)}: no transform and no "
            f"odometry topic; frames: {shown}{more}"
        )

    def take(self, connection: Connection, message: Any) -> None:
        """Takes in a message of transforms or of odometry."""
        if connection.msgtype == ODOMETRY:
            pose = message.pose.pose
            self._add(
                message.header,
                message.child_frame_id or BASE,
                transform_of(pose.position, pose.orientation),
                static=False,
            )
            return
        static = _is_static(connection)
        for one in message.transforms:
            moved = transform_of(
                one.transform.translation, one.transform.rotation
            )
            self._add(one.header, one.child_frame_id, moved, static)

    def _add(
        self, header: Any, child: str, place: Transform | None, static: bool
    ) -> None:
        if place is not None:
            self.tree.add(
                frame_name(header.frame_id),
                frame_name(child),
                nanoseconds(header.stamp),
                place,
                static,
            )

    def _connected(
        self, names: FrameTree, laser: str, wanted: tuple[str, ...]
    ) -> str | None:
        """The best wanted frame that the laser is connected with; looks until it has the very best."""
        for _ in self._new_names(names):
            if names.chain(laser, wanted[0]) is not None:
                return wanted[0]
        return next(
            (root for root in wanted if names.chain(laser, root) is not None),
            None,
        )

    def _new_names(self, names: FrameTree) -> Iterator[None]:
        """Adds the names of the bag's transforms; a step at the start and after each new one."""
        yield
        for _, _, message in self.bag.messages(self.moving):
            for one in message.transforms:
                parent = frame_name(one.header.frame_id)
                if names.connect(parent, frame_name(one.child_frame_id)):
                    yield

    def _odometry(
        self, names: FrameTree, laser: str, frame: str | None
    ) -> PoseSource | None:
        """An odometry topic in place of TF, the one with the most messages."""
        found = sorted(
            self.bag.connections(ODOMETRY), key=lambda c: -c.msgcount
        )
        for connection in found:
            _, _, message = next(iter(self.bag.messages([connection])))
            root = frame_name(message.header.frame_id)
            child = frame_name(message.child_frame_id or BASE)
            if frame is not None and root != frame_name(frame):
                continue
            warnings = []
            if len(found) > 1:
                topics = ", ".join(sorted({c.topic for c in found}))
                warnings.append(f"there are several odometry topics: {topics}")
            if names.chain(laser, child) is None:
                self.tree.add(child, laser, 0, IDENTITY, static=True)
                warnings.append(
                    f"nothing says where {laser} is on {child}: it is taken to be at its origin"
                )
            note = (
                f"poses: odometry of {connection.topic} ({root} > {child}), because TF does not connect "
                f"{laser} with {frame or ' or '.join(FRAMES)}"
            )
            return PoseSource(root, note, warnings, [*self.moving, connection])
        return None


BASE = "base_link"
"""The robot's frame, where an odometry message does not name it."""


def _is_static(connection: Connection) -> bool:
    return connection.topic.rstrip("/").endswith("tf_static")
