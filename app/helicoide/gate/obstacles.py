"""Spherical obstacles: add, drag, resize and remove them.

The one that moves stops: a dragged sphere stops at the arm, and a moving arm stops at the sphere.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from helicoide.arrays import Array
from helicoide.confinement import Obstacles, last_free_point, segment_distances
from helicoide.gate.check import FARTHEST, driven, finite
from helicoide.gate.target import Phase
from helicoide.kinematics.robot_parts import Capsule
from helicoide.state import Drag, State, Update, with_drag, with_problem
from helicoide.text import HelicoideError, Text

MOST = 6
ROUNDING = 1e-9  # m
NO_SPACE = Text(
    en="The arm is where obstacle {n} was: move the arm first.",
    pt_BR="O braço está onde ficava o obstáculo {n}: mova o braço antes.",
)
# As fractions of the reach: initial, smallest and largest radius, and initial distance of the centre from the tool.
RADIUS, SMALLEST, LARGEST, ASIDE = 0.06, 0.02, 0.25, 0.35


def obstacle_handle(index: int) -> str:
    """The handle of an obstacle in a `Drag`."""
    return f"obstacle {index}"


def add_obstacle() -> Update:
    """Add a sphere beside the tool."""

    def change(state: State) -> State:
        obstacles, reach = state.problem.obstacles, state.robot.reach
        if len(obstacles.radii) == MOST:
            raise HelicoideError(
                Text(en="At most {most} obstacles are allowed.", pt_BR="Há no máximo {most} obstáculos.").format(
                    most=MOST
                )
            )
        place = _roomy(state, RADIUS * reach)
        radius = _fitting(state, place, RADIUS * reach)
        if radius < SMALLEST * reach:
            raise HelicoideError(
                Text(
                    en="There is no free space next to the end effector: move the arm first.",
                    pt_BR="Não há espaço ao lado do efetuador: mova o braço antes.",
                )
            )
        return _with(state, obstacles.with_sphere(place, radius))

    return driven(change)


def drag_obstacle(seat: str, phase: Phase, index: int, position: ArrayLike) -> Update:
    """Drag a sphere to a position (3,), m: it moves along a straight line and stops before it touches the arm."""

    def change(state: State) -> State:
        asked = _place(state, index, position)
        grasp = Drag(seat, obstacle_handle(index))
        if phase == "start":
            state = with_drag(state, grasp)
        if state.request.drag != grasp:
            return state
        return _moved(with_drag(state, None) if phase == "end" else state, index, asked)

    return driven(change)


def set_obstacle(index: int, position: ArrayLike) -> Update:
    """Move the centre of a sphere to a position (3,), m, in the same way."""
    return driven(lambda state: _moved(state, index, _place(state, index, position)))


def set_obstacle_radius(index: int, radius: float) -> Update:
    """Set the radius of a sphere, m; it grows only as far as its clearance from the arm allows."""

    def change(state: State) -> State:
        _check(state, index)
        (value,), reach = finite([radius], (1,)), state.robot.reach
        if not SMALLEST * reach <= value <= LARGEST * reach:
            raise HelicoideError(
                Text(
                    en="The radius of a sphere must be {least:.0f} to {most:.0f} mm.",
                    pt_BR="O raio de uma esfera vai de {least:.0f} a {most:.0f} mm.",
                ).format(least=1000 * SMALLEST * reach, most=1000 * LARGEST * reach)
            )
        obstacles = state.problem.obstacles
        centre, before = obstacles.ends[index, 0], obstacles.radii[index]
        fitting = value if value <= before else max(before, _fitting(state, centre, value))
        notice = None if fitting == value else _at_arm(state, index)
        return replace(_with(state, obstacles.with_sphere_at(index, centre, fitting)), notice=notice)

    return driven(change)


def remove_obstacle(index: int) -> Update:
    """Remove a sphere."""

    def change(state: State) -> State:
        _check(state, index)
        return _with(with_drag(state, None), state.problem.obstacles.without(index))

    return driven(change)


def restored_obstacles(state: State, wanted: Obstacles) -> tuple[Obstacles, list[Text]]:
    """The spheres of an earlier scene, and what gave way to the arm: a moved sphere stops there, a new one is smaller.

    Raises HelicoideError if there is no space for a sphere that was removed.
    """
    present, said = state.problem.obstacles, []
    for index, (centre, radius) in enumerate(zip(wanted.ends[:, 0], wanted.radii, strict=True)):
        still_there = (present.ends[:, 0] == centre).all(axis=1) & (present.radii >= radius)
        if still_there.any() or (fitting := _fitting(state, centre, float(radius))) >= radius - ROUNDING:
            continue
        if len(present.radii) == len(wanted.radii):
            reach = _kept(state) + min(radius, present.radii[index])
            centre = last_free_point(present.ends[index, 0], centre, _axes(state), reach)
            fitting = max(_fitting(state, centre, float(radius)), min(radius, present.radii[index]))
        elif fitting < SMALLEST * state.robot.reach:
            raise HelicoideError(NO_SPACE.format(n=index + 1))
        wanted = wanted.with_sphere_at(index, centre, fitting)
        said.append(_at_arm(state, index))
    return wanted, said


def _roomy(state: State, radius: float) -> Array:
    """A centre beside the tool, (3,), m: the one nearest to the base with enough room, else the one with most room."""
    obstacles, planes, reach = state.problem.obstacles, state.problem.planes, state.robot.reach
    places = state.T_world_tool[:3, 3] + np.concatenate([np.eye(3), -np.eye(3)]) * ASIDE * reach
    places[:, 2] = np.maximum(places[:, 2], state.robot.floor + radius)
    axes, kept = np.concatenate([_axes(state), obstacles.ends]), np.concatenate([_kept(state), obstacles.radii])
    room = np.hstack([segment_distances(places, axes) - kept, places @ planes.normals.T - planes.offsets]).min(axis=1)
    far = np.linalg.norm(places - state.robot.points[0], axis=1)
    return np.asarray(places[np.lexsort([far, -np.minimum(room, radius)])[0]])


def _check(state: State, index: int) -> None:
    count = len(state.problem.obstacles.radii)
    if index not in range(count):
        raise HelicoideError(
            Text(en="The obstacles are 1 to {n}.", pt_BR="Os obstáculos são de 1 a {n}.").format(n=count)
            if count
            else Text(en="There are no obstacles.", pt_BR="Não há obstáculos.")
        )


def _place(state: State, index: int, position: ArrayLike) -> Array:
    _check(state, index)
    asked, far = finite(position, (3,)), FARTHEST * state.robot.maximum_reach
    if np.abs(asked).max() > far:
        raise HelicoideError(
            Text(
                en="An obstacle must be within {far:.1f} m of the base.",
                pt_BR="Um obstáculo deve ficar a até {far:.1f} m da base.",
            ).format(far=far)
        )
    return asked


def _moved(state: State, index: int, moved: Array) -> State:
    obstacles = state.problem.obstacles
    start, radius = obstacles.ends[index, 0], float(obstacles.radii[index])
    centre = last_free_point(start, moved, _axes(state), _kept(state) + radius)
    notice = None if np.array_equal(centre, moved) else _at_arm(state, index)
    return replace(_with(state, obstacles.with_sphere_at(index, centre, radius)), notice=notice)


def _axes(state: State) -> Array:
    """The axes of the moving bodies of the arm and of the second arm at their present poses, (k, 2, 3), m."""
    arms = [state.arm.poses] if state.compared is None else [state.arm.poses, state.compared.arm.poses]
    return np.array([body.axis_at(poses) for poses in arms for body in _moving(state)])


def _kept(state: State) -> Array:
    """The smallest distance that a point obstacle must keep from each of `_axes`, (k,), m."""
    arms = 1 if state.compared is None else 2
    return np.array([body.radius + state.problem.zones.body_clearance for body in _moving(state)] * arms)


def _moving(state: State) -> list[Capsule]:
    return [body for body in state.robot.bodies if max(body.links) > 0]


def _fitting(state: State, centre: Array, radius: float) -> float:
    """The radius, reduced if necessary to the largest that keeps its distance from the arm."""
    return min(radius, float((segment_distances(centre[None], _axes(state))[0] - _kept(state)).min()))


def _at_arm(state: State, index: int) -> Text:
    return Text(
        en="Obstacle {n} stops {mm:.0f} mm from the arm.",
        pt_BR="O obstáculo {n} para a {mm:.0f} mm do braço.",
    ).format(n=index + 1, mm=1000 * state.problem.zones.body_clearance)


def _with(state: State, obstacles: Obstacles) -> State:
    return with_problem(state, replace(state.problem, obstacles=obstacles))
