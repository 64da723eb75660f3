"""Writes ROS bags of a known world, for tests."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from rosbags.rosbag1 import Writer as Writer1
from rosbags.rosbag2 import StoragePlugin
from rosbags.rosbag2 import Writer as Writer2
from rosbags.typesys import Stores, get_types_from_msg, get_typestore
from rosbags.typesys.store import Typestore

KINDS = ("bag", "db3", "mcap")
SECOND = 1_000_000_000
START = 1_700_000_000 * SECOND
TF_MESSAGE = "geometry_msgs/TransformStamped[] transforms\n"


@dataclass(frozen=True)
class Stamped:
    """A message, its topic and the time when it was recorded."""

    topic: str
    time: int
    message: Any


def typestore(kind: str) -> Typestore:
    """The messages of ROS 1 or ROS 2."""
    if kind != "bag":
        return get_typestore(Stores.ROS2_HUMBLE)
    store = get_typestore(Stores.ROS1_NOETIC)
    store.register(get_types_from_msg(TF_MESSAGE, "tf2_msgs/msg/TFMessage"))
    return store


def write_bag(
    path: Path, kind: str, messages: Callable[[Messages], Iterable[Stamped]]
) -> Path:
    """A bag of one of the KINDS at the path, which gets its ending; returns it."""
    make = Messages(typestore(kind), kind)
    path = path.with_suffix(".bag" if kind == "bag" else "")
    if kind == "bag":
        with Writer1(path) as writer1:
            _write(make, writer1, messages(make))
    else:
        plugin = StoragePlugin.SQLITE3 if kind == "db3" else StoragePlugin.MCAP
        with Writer2(path, version=9, storage_plugin=plugin) as writer2:
            _write(make, writer2, messages(make))
    return path


def _write(make: Messages, writer: Any, messages: Iterable[Stamped]) -> None:
    connections: dict[str, Any] = {}
    for one in messages:
        name = one.message.__msgtype__
        if one.topic not in connections:
            connections[one.topic] = writer.add_connection(
                one.topic, name, typestore=make.store
            )
        raw = (
            make.store.serialize_ros1(one.message, name)
            if make.kind == "bag"
            else make.store.serialize_cdr(one.message, name)
        )
        writer.write(connections[one.topic], one.time, raw)


class Messages:
    """Makes messages of one kind of bag."""

    def __init__(self, store: Typestore, kind: str) -> None:
        self.store, self.kind, self.number = store, kind, 0

    def make(self, name: str, **fields: Any) -> Any:
        """A message by its type's name."""
        return self.store.types[name](**fields)

    def header(self, frame: str, time: int) -> Any:
        """A header; ROS 1 has a number in it."""
        stamp = self.make(
            "builtin_interfaces/msg/Time",
            sec=time // SECOND,
            nanosec=time % SECOND,
        )
        fields = {"stamp": stamp, "frame_id": frame}
        if self.kind == "bag":
            self.number += 1
            fields["seq"] = self.number
        return self.make("std_msgs/msg/Header", **fields)

    def scan(
        self,
        time: int,
        angles: tuple[float, float],
        ranges: Iterable[float],
        limits: tuple[float, float] = (0.05, 12.0),
        frame: str = "laser",
    ) -> Any:
        """A LaserScan with angle_min and angle_increment, range_min and range_max."""
        values = np.array(list(ranges), dtype=np.float32)
        return self.make(
            "sensor_msgs/msg/LaserScan",
            header=self.header(frame, time),
            angle_min=angles[0],
            angle_max=angles[0] + (values.size - 1) * angles[1],
            angle_increment=angles[1],
            time_increment=0.0,
            scan_time=0.1,
            range_min=limits[0],
            range_max=limits[1],
            ranges=values,
            intensities=np.zeros(0, dtype=np.float32),
        )

    def transform(
        self,
        time: int,
        parent: str,
        child: str,
        place: tuple[float, float, float],
        rotation: tuple[float, float, float, float],
    ) -> Any:
        """A TFMessage with one transform."""
        stamped = self.make(
            "geometry_msgs/msg/TransformStamped",
            header=self.header(parent, time),
            child_frame_id=child,
            transform=self.make(
                "geometry_msgs/msg/Transform",
                translation=self.make(
                    "geometry_msgs/msg/Vector3",
                    **dict(zip("xyz", place, strict=True)),
                ),
                rotation=self._quaternion(rotation),
            ),
        )
        return self.make("tf2_msgs/msg/TFMessage", transforms=[stamped])

    def odometry(
        self,
        time: int,
        frames: tuple[str, str],
        place: tuple[float, float, float],
        rotation: tuple[float, float, float, float],
    ) -> Any:
        """An Odometry message from the first frame to the second."""
        zero = {"x": 0.0, "y": 0.0, "z": 0.0}
        return self.make(
            "nav_msgs/msg/Odometry",
            header=self.header(frames[0], time),
            child_frame_id=frames[1],
            pose=self.make(
                "geometry_msgs/msg/PoseWithCovariance",
                pose=self.make(
                    "geometry_msgs/msg/Pose",
                    position=self.make(
                        "geometry_msgs/msg/Point",
                        **dict(zip("xyz", place, strict=True)),
                    ),
                    orientation=self._quaternion(rotation),
                ),
                covariance=np.zeros(36),
            ),
            twist=self.make(
                "geometry_msgs/msg/TwistWithCovariance",
                twist=self.make(
                    "geometry_msgs/msg/Twist",
                    linear=self.make("geometry_msgs/msg/Vector3", **zero),
                    angular=self.make("geometry_msgs/msg/Vector3", **zero),
                ),
                covariance=np.zeros(36),
            ),
        )

    def _quaternion(self, rotation: tuple[float, float, float, float]) -> Any:
        return self.make(
            "geometry_msgs/msg/Quaternion",
            **dict(zip("xyzw", rotation, strict=True)),
        )


def euler(
    roll: float, pitch: float, yaw: float
) -> tuple[float, float, float, float]:
    """A quaternion x, y, z, w: roll about x first, then pitch about y, then yaw about z."""
    cr, sr = math.cos(roll / 2), math.sin(roll / 2)
    cp, sp = math.cos(pitch / 2), math.sin(pitch / 2)
    cy, sy = math.cos(yaw / 2), math.sin(yaw / 2)
    return (
        sr * cp * cy - cr * sp * sy,
        cr * sp * cy + sr * cp * sy,
        cr * cp * sy - sr * sp * cy,
        cr * cp * cy + sr * sp * sy,
    )
