"""The arm at a posture in a notebook: the same state, multivectors and numbers as in the lab."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace

import numpy as np
from markupsafe import Markup
from numpy.typing import ArrayLike

from helicoide import gate, readout
from helicoide.arrays import Array
from helicoide.command import MoveToPose
from helicoide.confinement import Obstacles
from helicoide.confinement.planes import Plane, pane_on_plane, planes_of
from helicoide.console.scene_names import scene_names
from helicoide.foresight import advance_with_search
from helicoide.gate.check import finite
from helicoide.geometry import rotation
from helicoide.geometry.clifford import CL031
from helicoide.geometry.multivector import Multivector
from helicoide.ik import entry_point
from helicoide.ik.method import changed
from helicoide.ik.methods import named
from helicoide.kinematics.differential import frame_jacobian
from helicoide.kinematics.robot import Robot
from helicoide.state import State, Update, initial_state, with_joints, with_problem
from helicoide.teaching import tables
from helicoide.teaching.elements import as_place, as_plane, as_radius, pose_of
from helicoide.teaching.formulations import Formulations
from helicoide.text import HelicoideError, Language, Text, untranslated

STEP, LONGEST = 0.01, 600.0  # s
TOO_LONG = Text(en="Give 0 to {most:g} seconds.", pt_BR="Dê de 0 a {most:g} segundos.")


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


def granted(update: Update, state: State) -> State:
    """The state after an update. Raises HelicoideError with the reason for which the lab would refuse it."""
    changed_state = update(replace(state, notice=None))
    if changed_state.notice is not None:
        raise HelicoideError(changed_state.notice)
    return changed_state


def _steps(seconds: float) -> int:
    """How many steps some seconds are."""
    (value,) = finite([seconds], (1,))
    if not 0 <= value <= LONGEST:
        raise HelicoideError(TOO_LONG.format(most=LONGEST))
    return round(float(value) / STEP)


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

    def among(
        self,
        obstacles: Iterable[tuple[ArrayLike, float]] = (),
        entry: ArrayLike | Multivector | None = None,
        zones: tuple[float, float] | None = None,
    ) -> ArmAtPosture:
        """The same among spheres, (centre (3,), radius) in m each, instead of those there were.

        entry: the entry point of the instrument, (3,) m or a point; None for none; zones: safety and warning distance
        to the planes, m, if they change. Raises HelicoideError for invalid numbers, and for an arm without instrument.
        """
        spheres = Obstacles()
        for centre, radius in obstacles:
            spheres = spheres.with_sphere(as_place(centre), as_radius(radius))
        robot, problem = self.state.robot, self.state.problem
        through = None if entry is None else entry_point(robot, as_place(entry))
        kept = problem.zones if zones is None else problem.zones.adjusted(*finite(zones, (2,)).tolist())
        problem = replace(problem, obstacles=spheres, entry=through, zones=kept)
        return replace(self, state=with_problem(self.state, problem))

    def with_gains(self, x: float, y: float, z: float, orientation: float) -> ArmAtPosture:
        """The same with other gains of the closed loop, 1/s, of the methods that have one.

        Raises HelicoideError with the range of a gain.
        """
        state = self.state
        for index, gain in enumerate((x, y, z, orientation)):
            state = granted(gate.set_gain(index, gain), state)
        return replace(self, state=state)

    def with_objective(
        self,
        name: str,
        options: Mapping[str, object] | None = None,
        weight: float = 1.0,
        as_row: bool = False,
        adapts: bool = False,
    ) -> ArmAtPosture:
        """The same with a secondary objective, which moves the joints that the task leaves free.

        options: its settings that differ from their defaults; weight: k₀, 1/s; as_row: as one more row of the task;
        adapts: whether the weight of a joint grows at its limit. Raises HelicoideError, which says what is valid.
        """
        updates = [
            gate.choose_objective(name),
            *(gate.set_objective(setting, value) for setting, value in (options or {}).items()),
            gate.weigh_objective(weight),
            gate.objective_as_row(as_row),
            gate.grow_weights(adapts),
        ]
        state = self.state
        for update in updates:
            state = granted(update, state)
        return replace(self, state=state)

    def after(self, seconds: float) -> ArmAtPosture:
        """The arm some seconds later, on its way to its target, in steps of 10 ms as in the lab.

        The first step after an installation takes longer: it is compiled. Raises HelicoideError for more than
        `LONGEST` seconds.
        """
        state = self.state
        for _ in range(_steps(seconds)):
            state = advance_with_search(state, STEP)
        return replace(self, state=state)

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
