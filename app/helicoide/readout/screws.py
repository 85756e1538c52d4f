"""The screw motion that an object represents, as curves that can be drawn."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from helicoide.arrays import Array
from helicoide.confinement.planes import pane_axes
from helicoide.geometry import motor
from helicoide.geometry.motor import ScrewDisplacement
from helicoide.kinematics.chain import joint_positions
from helicoide.readout.elements import Element
from helicoide.state import State

PIECES = 48
# Radius of the arc at a joint, as a fraction of the reach.
JOINT_RADIUS = 0.16


@dataclass(frozen=True, eq=False)
class DrawnScrew:
    """A screw and the point that it moves: its axis, and where the point begins, (3,), m.

    The point is moved along a helix: rotated about the axis by the angle while it slides along it.
    """

    screw: ScrewDisplacement
    start: Array

    @cached_property
    def centre(self) -> Array:
        """The point of the axis nearest to the start, (3,), m; for a translation, the start itself."""
        if self.screw.angle == 0:
            return self.start
        along = (self.start - self.screw.point) @ self.screw.direction
        return np.asarray(self.screw.point + along * self.screw.direction)

    def at(self, turned: Array, slid: Array) -> Array:
        """The start after fractions (k,) of the rotation and of the translation, (k, 3), m.

        c + cos θ r + sin θ n × r + d n, with r from the centre c to the start, which is perpendicular to the axis n.
        """
        n, r = self.screw.direction, self.start - self.centre
        theta, d = (turned * self.screw.angle)[:, None], (slid * self.screw.displacement)[:, None]
        return np.asarray(self.centre + np.cos(theta) * r + np.sin(theta) * np.cross(n, r) + d * n)

    @property
    def helix(self) -> Array:
        """The way of the point, (k, 3), m."""
        s = np.linspace(0.0, 1.0, PIECES + 1)
        return self.at(s, s)

    def arc(self, fraction: float = 1.0) -> Array:
        """The rotation alone, by a fraction of its angle, (k, 3), m."""
        s = np.linspace(0.0, fraction, PIECES + 1)
        return self.at(s, np.zeros_like(s))

    def sector(self, fraction: float = 1.0) -> Array:
        """The same arc and its two radii, as segments (k, 2, 3), m."""
        arc = self.arc(fraction)
        radii = [[self.centre, arc[0]], [self.centre, arc[-1]]]
        return np.concatenate([np.stack([arc[:-1], arc[1:]], axis=1), radii])

    @property
    def slide(self) -> Array:
        """The translation along the axis, from the centre, (2, 3), m."""
        return np.array([self.centre, self.centre + self.screw.displacement * self.screw.direction])


def screw_of_values(values: Array) -> DrawnScrew:
    """The screw of a motor (16,), which moves the base frame onto the frame; its helix begins at the base's origin."""
    return DrawnScrew(motor.screw_from_motor(values), np.zeros(3))


def drawn_screw(state: State, element: Element) -> DrawnScrew | None:
    """The screw of a frame, or the motion of a joint from its zero; None for planes and points, which have none."""
    if element.nature == "motor":
        return screw_of_values(element.values(state))
    if element.selection.kind != "joint":
        return None
    i = element.selection.index
    joint, value = state.robot.joints[i], float(joint_positions(state.robot.chain, state.arm.q)[i])
    axis, centre = state.axes[i], state.arm.poses[i + 1, :3, 3]
    if joint.is_prismatic:
        screw = ScrewDisplacement(axis, np.zeros(3), np.array(0.0), np.array(value))
        return DrawnScrew(screw, centre - value * axis)
    spoke = state.arm.poses[i, :3, :3] @ pane_axes(state.robot.directions[i])[:, 0]
    sense = np.sign(value) or 1.0
    screw = ScrewDisplacement(
        sense * axis, np.asarray(centre - (centre @ axis) * axis), np.array(abs(value)), np.array(0.0)
    )
    return DrawnScrew(screw, np.asarray(centre + JOINT_RADIUS * state.robot.reach * spoke))
