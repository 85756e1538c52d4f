"""ROS messages: the definitions of ROS 2 and of Cerbaro's Movemaster, and how they become bytes."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
from rosbags.typesys import Stores, get_types_from_msg, get_typestore
from rosbags.typesys.store import Typestore
from rosbags.typesys.stores import ros2_humble as ros

from helicoide.arrays import Array
from helicoide.geometry import rotation

JOINT_STATE = "sensor_msgs/msg/JointState"
SETPOINT, STATUS = "movemaster_msg/msg/setpoint", "movemaster_msg/msg/status"
WORLD = "world"
# Cerbaro 2022, quadros 4 and 5
DEFINITIONS = {
    SETPOINT: "\n".join(
        [*(f"float32 set_{k}" for k in range(1, 6)), "bool set_GRIP", "int8 GoHome", "bool emergency_stop"]
    ),
    STATUS: "\n".join(
        [
            "string joint",
            *(f"float32 {name}" for name in ("setpoint", "pulse_count", "error", "output", "control_loop")),
            "bool IsDone",
        ]
    ),
}


@cache
def typestore() -> Typestore:
    """The definitions of all messages that are written or read here."""
    store = get_typestore(Stores.ROS2_HUMBLE)
    for name, definition in DEFINITIONS.items():
        store.register(get_types_from_msg(definition, name))
    return store


def message_bytes(message: Any) -> bytes:
    """A message as bytes (CDR)."""
    return bytes(typestore().serialize_cdr(message, message.__msgtype__))


@cache
def definition_text(kind: str) -> bytes:
    """The definition of a kind of message with all that it uses, as an MCAP file carries it."""
    return typestore().generate_msgdef(kind, ros_version=2)[0].encode()


def header_message(ns: int, frame: str = WORLD) -> ros.std_msgs__msg__Header:
    """The time, ns, and the frame of a message."""
    seconds, rest = divmod(ns, 1_000_000_000)
    return ros.std_msgs__msg__Header(ros.builtin_interfaces__msg__Time(seconds, rest), frame)


def joint_message(ns: int, names: list[str], q: Array, velocities: Array) -> ros.sensor_msgs__msg__JointState:
    """Joint values (n,), rad or m, and their velocities (n,)."""
    return ros.sensor_msgs__msg__JointState(header_message(ns), names, np.array(q), np.array(velocities), np.zeros(0))


def stamped_pose(ns: int, T: Array) -> ros.geometry_msgs__msg__PoseStamped:
    """A pose T_world_a (4, 4), m."""
    return ros.geometry_msgs__msg__PoseStamped(header_message(ns), pose_message(T))


def pose_message(T: Array) -> ros.geometry_msgs__msg__Pose:
    """A pose T (4, 4), m."""
    return ros.geometry_msgs__msg__Pose(
        ros.geometry_msgs__msg__Point(*T[:3, 3].tolist()), quaternion_message(T[:3, :3])
    )


def quaternion_message(R: Array) -> ros.geometry_msgs__msg__Quaternion:
    """The quaternion of a rotation matrix (3, 3); ROS writes its real part last."""
    w, x, y, z = rotation.from_matrix(R).tolist()
    return ros.geometry_msgs__msg__Quaternion(x, y, z, w)


def frame_message(ns: int, child: str, T: Array) -> ros.geometry_msgs__msg__TransformStamped:
    """The frame `child` in the world, T_world_child (4, 4), m."""
    moved = ros.geometry_msgs__msg__Vector3(*T[:3, 3].tolist())
    return ros.geometry_msgs__msg__TransformStamped(
        header_message(ns), child, ros.geometry_msgs__msg__Transform(moved, quaternion_message(T[:3, :3]))
    )
