"""Rows for obstacles, and for the entry point of an instrument."""

from __future__ import annotations

from functools import partial

import numpy as np
from viser import Icon

from helicoide import gate
from helicoide.arrays import Array
from helicoide.kinematics.robot import Robot
from helicoide.text import Text
from helicoide.view.requests import ForArm, PageRequest
from helicoide.view.rows import Button, Checkbox, DependentRows, Folder, Row, Slider, VectorRow
from helicoide.view.window_view import View

ADD = Text(en="Add sphere", pt_BR="Adicionar esfera")


def obstacle_rows(robot: Robot) -> Folder:
    """Rows that add a sphere, and for each sphere its centre, its radius and its removal."""
    return Folder(Text(en="Obstacles", pt_BR="Obstáculos"), DependentRows(_count, partial(_spheres, robot)), open=False)


def _count(view: View) -> int:
    return len(view.state.problem.obstacles.radii)


def _spheres(robot: Robot, count: int) -> list[Row]:
    add = Button(
        lambda _: ADD, lambda _: ForArm(gate.add_obstacle()), Icon.PLUS, lambda view: not view.state.arm.parked
    )
    return [add, *(row for index in range(count) for row in _sphere(robot, index))]


def _sphere(robot: Robot, index: int) -> list[Row]:
    n = index + 1
    remove = Text(en="Remove sphere {n}", pt_BR="Remover esfera {n}").format(n=n)

    def centre(view: View) -> Array:
        ends = view.state.problem.obstacles.ends
        return ends[index, 0] if index < len(ends) else np.zeros(3)

    def radius(view: View) -> float:
        radii = view.state.problem.obstacles.radii
        return 1000 * float(radii[index]) if index < len(radii) else 0.0

    return [
        VectorRow(
            Text(en="Sphere {n}: x y z [mm]", pt_BR="Esfera {n}: x y z [mm]").format(n=n),
            1.0,
            lambda view: _millimetres(centre(view)),
            lambda view, shown: ForArm(gate.set_obstacle(index, np.asarray(shown) / 1000)),
        ),
        Slider(
            Text(en="Sphere {n}: radius [mm]", pt_BR="Esfera {n}: raio [mm]").format(n=n),
            float(np.ceil(1000 * gate.SMALLEST * robot.reach)),
            float(np.floor(1000 * gate.LARGEST * robot.reach)),
            1.0,
            radius,
            lambda shown: ForArm(gate.set_obstacle_radius(index, shown / 1000)),
        ),
        Button(lambda _: remove, lambda _: ForArm(gate.remove_obstacle(index)), Icon.TRASH, weight="destructive"),
    ]


def entry_point_rows() -> Folder:
    """The entry point: whether it is held, and its position."""
    return Folder(
        Text(
            en="Entry point (remote centre of motion, RCM)", pt_BR="Ponto de entrada (centro remoto de movimento, RCM)"
        ),
        DependentRows(_is_enforced, _entry),
        open=False,
    )


def _is_enforced(view: View) -> bool:
    return view.state.problem.entry is not None


def _entry(enforced: bool) -> list[Row]:
    hold = Checkbox(
        Text(en="Enforce the RCM", pt_BR="Impor o centro remoto (RCM)"),
        _is_enforced,
        lambda on: ForArm(gate.enforce_entry(on)),
    )
    where = VectorRow(Text(en="entry point x y z [mm]", pt_BR="ponto de entrada x y z [mm]"), 1.0, _point, _set_point)
    return [hold, where] if enforced else [hold]


def _point(view: View) -> tuple[float, float, float]:
    entry = view.state.problem.entry
    return (0.0, 0.0, 0.0) if entry is None else _millimetres(entry.point)


def _set_point(view: View, shown: tuple[float, float, float]) -> PageRequest:
    return ForArm(gate.set_entry(np.asarray(shown) / 1000))


def _millimetres(point: Array) -> tuple[float, float, float]:
    x, y, z = (round(1000 * float(value), 1) for value in point)
    return x, y, z
