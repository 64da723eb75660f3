"""The messages of a ROS bag that mapping needs, read by ``rosbags``.

Nothing here is known of how a bag is stored: the library reads ROS 1 (.bag) and ROS 2 (sqlite3, mcap).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from occgrid_parity.logs.conversion import ConversionError
from occgrid_parity.logs.transforms import Transform, unit

if TYPE_CHECKING:
    from rosbags.highlevel import AnyReader
    from rosbags.interfaces import Connection

SCAN = "sensor_msgs/msg/LaserScan"
TRANSFORMS = ("tf2_msgs/msg/TFMessage", "tf/msg/tfMessage")
ODOMETRY = "nav_msgs/msg/Odometry"
SUFFIXES = (".bag", ".mcap", ".db3")


def is_bag(path: Path) -> bool:
    """Whether that is the name of a bag, or a folder as ROS 2 writes it."""
    return path.suffix.lower() in SUFFIXES or path.is_dir()


class Bag:
    """An open bag."""

    def __init__(self, path: Path, reader: AnyReader) -> None:
        self.path, self.reader = path, reader

    def connections(self, *types: str) -> list[Connection]:
        """The connections with messages of these types, by topic."""
        found = [
            c
            for c in self.reader.connections
            if c.msgtype in types and c.msgcount
        ]
        return sorted(found, key=lambda c: (c.topic, c.id))

    def messages(
        self, connections: Sequence[Connection]
    ) -> Iterator[tuple[Connection, int, Any]]:
        """Connection, time of recording in nanoseconds, and content; nothing for no connection."""
        if not connections:
            return
        with bag_errors(self.path):
            for connection, time, raw in self.reader.messages(connections):
                yield (
                    connection,
                    time,
                    self.reader.deserialize(raw, connection.msgtype),
                )


@contextmanager
def open_bag(path: Path) -> Iterator[Bag]:
    """Opens a bag. Raises ConversionError where it is none, or the library is not there."""
    if path.is_dir() and not (path / "metadata.yaml").is_file():
        raise ConversionError(
            f"{path}: a folder without metadata.yaml is no ROS 2 bag"
        )
    try:
        from rosbags.highlevel import AnyReader
        from rosbags.typesys import Stores, get_typestore
    except ModuleNotFoundError as error:
        raise ConversionError(
            f"{path}: a ROS bag is read by the package rosbags: pip install 'occgrid-parity[ros]'"
        ) from error
    with bag_errors(path):
        # for bags of older ROS 2 versions, which do not say what their messages look like
        store = get_typestore(Stores.LATEST)
        reader = AnyReader([path], default_typestore=store)
        reader.open()
    try:
        yield Bag(path, reader)
    finally:
        reader.close()


@contextmanager
def bag_errors(path: Path) -> Iterator[None]:
    """Errors of the library as ConversionError, in one line."""
    try:
        yield
    except (ConversionError, GeneratorExit):
        raise
    except OSError as error:
        if error.filename is not None and error.strerror:
            raise
        raise ConversionError(f"{path}: {_one_line(error)}") from error
    except Exception as error:  # whatever a damaged bag makes of the library
        raise ConversionError(
            f"{path}: not a bag that can be read: {_one_line(error)}"
        ) from error


def frame_name(text: str) -> str:
    """A frame's name; ROS 1 writes some with a slash in front."""
    return text.lstrip("/")


def nanoseconds(stamp: Any) -> int:
    """The time of a header."""
    return int(stamp.sec) * 1_000_000_000 + int(stamp.nanosec)


def transform_of(translation: Any, rotation: Any) -> Transform | None:
    """A transform as messages write it; None where it is no number or no turn."""
    place = (float(translation.x), float(translation.y), float(translation.z))
    turn = unit(
        (
            float(rotation.x),
            float(rotation.y),
            float(rotation.z),
            float(rotation.w),
        )
    )
    if turn is None or not all(abs(value) < 1e12 for value in place):
        return None
    return Transform(place, turn)


def _one_line(error: Exception) -> str:
    text = " ".join(str(error).split()) or type(error).__name__
    return text[:300]
