"""A robot arm as the rest of the program uses it: SI units, radians, arrays ready for the kernels."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from itertools import pairwise
from math import isfinite
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helicoide.arrays import Array, frozen
from helicoide.kinematics.actuators import Actuators
from helicoide.kinematics.chain import Chain, Joint, JointVariable, chain_array, joint_positions
from helicoide.kinematics.dh import DhTable
from helicoide.kinematics.robot_parts import FRAME_TITLES, Capsule, Frame, Gripper, MonitoredPoint, PlanePane
from helicoide.kinematics.urdf_xml import root_link
from helicoide.text import HelicoideError, Text, numbers_text

# Radius of the bodies of an arm whose file gives none, as a fraction of its reach; shorter segments are left out
# unless a prismatic joint extends them.
DEFAULT_BODY_RADIUS = 0.04
# Below this reach, m, the tool counts as not moving away from its axes; and the reach of an arm without any length, m.
SMALLEST_REACH, DEFAULT_REACH = 1e-6, 0.5


@dataclass(frozen=True, eq=False)
class Robot:
    """An arm: m moving joints in a chain, driven by n variables q; n = m unless some joints follow others.

    The frame of link i lies at the point of joint i, its axes parallel to the base at q = 0; link 0 is the base.
    monitored_points (p, 3), m, are given in the frames of the links monitored_links (p,) that carry them.
    parameters: lengths, m, that the URDF names as ${name}; floor: height of the floor, m; camera: position and target
    of the first view, m; assumed: what the source does not give: lengths, limits or speeds; capsules: bodies that the
    file gives; self_collision: pairs of them that must not touch, by number; base: URDF link at which the chain begins,
    "" for the root; leaders: joints outside the chain that joints of it follow; remarks: sentences on how the file was
    read; stated: whether screws, DH rows and the URDF are stated independently, so that they can contradict each other.
    """

    name: str
    title: Text
    source: str
    urdf: Path
    joints: tuple[Joint, ...]
    tool_link: str
    T_world_tool_0: Array
    dh: DhTable
    frames: Mapping[str, Frame]
    monitored: tuple[MonitoredPoint, ...]
    monitored_points: Array
    monitored_links: NDArray[np.int64]
    poses: Mapping[str, Array]
    pose_titles: Mapping[str, Text]
    assumed: tuple[str, ...] = ()
    parameters: Mapping[str, float] = field(default_factory=dict)
    floor: float = 0.0
    camera: tuple[Array, Array] | None = None
    gripper: Gripper | None = None
    panes: tuple[PlanePane, ...] = ()
    capsules: tuple[Capsule, ...] = ()
    self_collision: tuple[tuple[int, int], ...] = ()
    actuators: Actuators | None = None
    base: str = ""
    leaders: tuple[JointVariable, ...] = ()
    remarks: tuple[Text, ...] = ()
    stated: bool = False

    @cached_property
    def all_remarks(self) -> tuple[Text, ...]:
        """The remarks, and a sentence on visuals that cannot be drawn. Reads the meshes."""
        from helicoide.kinematics.urdf_file import undrawn_remark  # imported here, as the reader of meshes loads slowly

        left_out = undrawn_remark(self.urdf, self.parameters)
        return self.remarks if left_out is None else (*self.remarks, left_out)

    @cached_property
    def variables(self) -> tuple[JointVariable, ...]:
        """The variables of q, (n,): joints that follow no other, then the leaders outside the chain."""
        return (*(joint for joint in self.joints if joint.mimic is None), *self.leaders)

    @cached_property
    def chain(self) -> Chain:
        """The joints as the kernels take them, (m,) of `CHAIN`."""
        return chain_array(self.joints)

    @cached_property
    def directions(self) -> Array:
        """Joint axes at q = 0, (m, 3), unit, base frame."""
        return frozen([joint.direction for joint in self.joints])

    @cached_property
    def points(self) -> Array:
        """A point on each joint axis at q = 0, (m, 3), m, base frame."""
        return frozen([joint.point for joint in self.joints])

    @cached_property
    def lower(self) -> Array:
        """Lower limits of the variables, (n,), rad or m."""
        return frozen([joint.lower for joint in self.variables])

    @cached_property
    def upper(self) -> Array:
        """Upper limits of the variables, (n,), rad or m."""
        return frozen([joint.upper for joint in self.variables])

    @cached_property
    def speed(self) -> Array:
        """Speed limits of the variables, (n,), rad/s or m/s."""
        return frozen([joint.speed for joint in self.variables])

    @cached_property
    def acceleration(self) -> Array:
        """Acceleration limits of the variables, (n,), rad/s² or m/s²; infinite where there is none."""
        return frozen([joint.acceleration for joint in self.variables])

    @cached_property
    def bodies(self) -> tuple[Capsule, ...]:
        """The capsules of the file; if it gives none, capsules between successive monitored points."""
        return self.capsules or _bodies_between_points(self)

    @cached_property
    def periodic(self) -> NDArray[np.bool_]:
        """Whether adding 2π to a variable gives the same posture, (n,): not if it slides or drives other joints."""
        geared = self.chain["slides"] | (self.chain["ratio"] != np.round(self.chain["ratio"]))
        held = set(self.chain["driver"][geared])
        return np.array([not variable.is_prismatic and i not in held for i, variable in enumerate(self.variables)])

    @cached_property
    def T_link_tool(self) -> Array:
        """The tool in the frame of the last link, (4, 4), m."""
        return in_link_frame(self.T_world_tool_0, self.points[-1])

    @cached_property
    def stretched_length(self) -> float:
        """Length of the stretched chain from the first axis to the tool, with every bounded slide extended, m."""
        ways = np.diff([*self.points, self.T_world_tool_0[:3, 3]], axis=0)
        ways[0] -= (ways[0] @ self.directions[0]) * self.directions[0]
        return float(np.linalg.norm(ways, axis=1).sum() + self.slide_travel[~self._assumed].sum())

    @cached_property
    def maximum_reach(self) -> float:
        """How far the tool may be at most, m: `reach`, and the slides whose range is assumed out as well."""
        return self.reach + float(self.slide_travel[self._assumed].sum())

    @cached_property
    def slide_travel(self) -> Array:
        """Largest distance of each prismatic joint from zero, (m,), m; 0 for revolute joints."""
        ends = np.abs([joint_positions(self.chain, self.lower), joint_positions(self.chain, self.upper)]).max(axis=0)
        return frozen(np.where(self.chain["slides"], ends, 0.0))

    @cached_property
    def _assumed(self) -> NDArray[np.bool_]:
        """Whether the range of what drives each joint is assumed, (m,)."""
        return np.array([self.variables[i].assumed for i in self.chain["driver"]])

    @cached_property
    def fixed_tool_point(self) -> bool:
        """Whether the joints change only the orientation of the tool and never its position."""
        return self.stretched_length < SMALLEST_REACH and not any(joint.is_prismatic for joint in self.joints)

    @cached_property
    def reach(self) -> float:
        """Size of the arm, m, not zero: `stretched_length`, or the largest distance of joints or tool from the base."""
        if self.stretched_length >= SMALLEST_REACH:
            return self.stretched_length
        far = float(np.linalg.norm([*self.points, self.T_world_tool_0[:3, 3]], axis=1).max())
        return far if far >= SMALLEST_REACH else DEFAULT_REACH

    @cached_property
    def base_link(self) -> str:
        """The fixed URDF link at which the chain begins."""
        return self.base or root_link(self.urdf, self.parameters)

    def check_joints(self, q: ArrayLike) -> Array:
        """The joint values as a read-only copy (n,); raises HelicoideError unless they are n finite numbers."""
        return frozen(self.joint_array(q))

    def joint_array(self, q: ArrayLike) -> Array:
        """The same without a copy, for callers that do not keep the array."""
        values = np.ascontiguousarray(q, dtype=np.float64)
        if values.shape != (len(self.variables),) or not all(map(isfinite, values.tolist())):
            raise HelicoideError(
                Text(
                    en="{robot} takes {n} finite joint values ({names}), not {given}.",
                    pt_BR="{robot} recebe {n} valores finitos de junta ({names}), não {given}.",
                ).format(
                    robot=self.name,
                    n=len(self.variables),
                    names=", ".join(joint.name for joint in self.variables),
                    given=numbers_text(values.ravel()),
                )
            )
        return values


def _bodies_between_points(robot: Robot) -> tuple[Capsule, ...]:
    origins = np.array([np.zeros(3), *robot.points])
    at_zero = robot.monitored_points + origins[robot.monitored_links]
    piece = Text(en="from {a} to {b}", pt_BR="de {a} a {b}")
    return tuple(
        Capsule(
            name=f"{a.name}-{b.name}",
            title=piece.format(a=a.title, b=b.title),
            ends=frozen(robot.monitored_points[i : i + 2]),
            links=(int(robot.monitored_links[i]), int(robot.monitored_links[i + 1])),
            radius=DEFAULT_BODY_RADIUS * robot.reach,
        )
        for i, (a, b) in enumerate(pairwise(robot.monitored))
        if np.linalg.norm(at_zero[i + 1] - at_zero[i]) > DEFAULT_BODY_RADIUS * robot.reach
        or any(joint.is_prismatic for joint in robot.joints[robot.monitored_links[i] : robot.monitored_links[i + 1]])
    )


def in_link_frame(T_world_frame_0: Array, point: Array) -> Array:
    """A frame at q = 0, (4, 4), m, in the frame of the link whose joint has the point (3,), m."""
    T = T_world_frame_0.copy()
    T[:3, 3] -= point
    return frozen(T)


def default_monitored_points(
    joints: tuple[Joint, ...], T_world_tool_0: Array
) -> tuple[tuple[MonitoredPoint, ...], Array, NDArray[np.int64]]:
    """The monitored points, if the file names none: the centre of every joint, and the tool."""
    centre = Text(en="joint {n}", pt_BR="junta {n}")
    points = [MonitoredPoint(joint.name, centre.format(n=i + 1)) for i, joint in enumerate(joints)]
    last = in_link_frame(T_world_tool_0, joints[-1].point)[:3, 3]
    carriers = np.arange(1, len(joints) + 1)
    return (
        (*points, MonitoredPoint("tool", FRAME_TITLES["tool"])),
        frozen([*np.zeros((len(joints), 3)), last]),
        np.append(carriers, len(joints)),
    )
