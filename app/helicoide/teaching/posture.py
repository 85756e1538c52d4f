"""The arm at a posture in a notebook: the same state, multivectors and numbers as in the lab."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from markupsafe import Markup
from numpy.typing import ArrayLike

from helicoide import readout
from helicoide.arrays import Array
from helicoide.command import MoveToPose
from helicoide.confinement.planes import Plane, pane_on_plane, planes_of
from helicoide.console.scene_names import scene_names
from helicoide.geometry import rotation
from helicoide.geometry.clifford import CL031
from helicoide.geometry.multivector import Multivector
from helicoide.ik.method import changed
from helicoide.ik.methods import named
from helicoide.kinematics.differential import frame_jacobian
from helicoide.kinematics.robot import Robot
from helicoide.state import State, initial_state, with_joints
from helicoide.teaching import tables
from helicoide.teaching.elements import as_plane, pose_of
from helicoide.teaching.formulations import Formulations
from helicoide.text import Language, untranslated


def state_at(robot: Robot, q: Array, planes: Mapping[str, Multivector] | None) -> State:
    """The state of an arm at rest at q (n,); planes: by name, instead of those of its file."""
    state = with_joints(initial_state(robot), q)
    if planes is None:
        return state
    panes = []
    for name, given in planes.items():
        normal, offset = as_plane(given)
        panes.append(pane_on_plane(Plane(normal, offset), name, untranslated(name), state.T_world_tool[:3, 3]))
    return replace(state, problem=replace(state.problem, planes=planes_of(tuple(panes))))


@dataclass(frozen=True, eq=False)
class ArmAtPosture:
    """An arm at a posture, with its multivectors and numbers. Poses are in the base frame, lengths in m.

    state: as in the lab.
    """

    state: State
    language: Language

    @property
    def q(self) -> Array:
        """The joint values, (n,), rad or m."""
        return self.state.arm.q

    @property
    def T(self) -> Array:
        """The pose of the end effector, (4, 4), m."""
        return self.state.T_world_tool

    @property
    def motor(self) -> Multivector:
        """The pose of the end effector as a motor of Cl(0,3,1)."""
        return self.multivectors["M_tool"]

    @property
    def quaternion(self) -> Array:
        """The orientation of the end effector, (4,), w x y z."""
        return rotation.from_matrix(self.T[:3, :3])

    @property
    def multivectors(self) -> dict[str, Multivector]:
        """The multivectors of Cl(0,3,1) that the console of the lab knows, by their names there: M_tool, L1, …"""
        values = {name: named.at(self.state) for name, named in scene_names(self.state).items()}
        return {name: M for name, M in values.items() if isinstance(M, Multivector) and M.algebra == CL031}

    @property
    def J(self) -> Array:
        """The Jacobian of the end effector, (6, n): twist (v, ω) = J q̇ in the base frame."""
        return frame_jacobian(self.state.robot, self.q)

    @property
    def forward(self) -> Formulations:
        """Forward kinematics by DH rows, by successive screws and by products of motors, side by side."""
        return Formulations(self.state.robot, self.q, self.language)

    @property
    def distances(self) -> Array:
        """The distances of the monitored points to the planes, (points, planes), m."""
        return readout.plane_distances(self.state)

    @property
    def instruments(self) -> dict[str, float]:
        """The numbers of the tab “Method” by their symbols, such as "w" for the manipulability; errors in mm and °."""
        return {one.symbol: one.value for one in readout.instruments(self.state)}

    def towards(
        self,
        target: ArrayLike | Multivector,
        method: str = "guarded",
        options: Mapping[str, object] | None = None,
        orientation: bool = True,
    ) -> ArmAtPosture:
        """The same with a target for the end effector, (4, 4) or a motor, and the method by which it goes there.

        options: settings of the method that differ from their defaults; orientation: whether that of the target counts.
        Raises HelicoideError, which lists the methods or the settings there are.
        """
        asked = named(method).Options()
        for name, value in (options or {}).items():
            asked = changed(asked, name, value)
        controller = self.state.request.controller.with_method(method).with_options(method, asked)
        request = replace(
            self.state.request,
            command=MoveToPose(pose_of(target)),
            controller=controller,
            with_orientation=orientation,
        )
        return replace(self, state=replace(self.state, request=request))

    def __repr__(self) -> str:
        return f"{self.state.robot.name}, q = {np.round(self.q, 6)}"

    def _repr_html_(self) -> Markup:
        """The pose of the end effector as a matrix and as a motor."""
        return Markup("<p>{}</p>{}{}").format(
            repr(self), tables.matrix(self.T, self.language), self.motor._repr_html_()
        )
