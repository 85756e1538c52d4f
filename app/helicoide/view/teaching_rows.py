"""Rows for teaching a path: record postures of the arm as points, order the points, and follow them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial

from viser import Icon

from helicoide import gate
from helicoide.kinematics.robot import Robot
from helicoide.text import Text, untranslated
from helicoide.trajectory.waypoint_file import encode_waypoints
from helicoide.trajectory.waypoints import GRIPPER_ACTIONS, MOVE_TYPES, Waypoint
from helicoide.view.path_rows import scaling
from helicoide.view.requests import ForArm, ForSeat, PageRequest, PlayTaught, Save
from helicoide.view.rows import Button, DependentRows, Dropdown, Folder, Row, Slider, TextEntry, Upload, VectorRow
from helicoide.view.window_view import View

FILE, LONGEST_STAY = "waypoints.toml", 60.0
ADD = Text(en="Add waypoint", pt_BR="Adicionar ponto")


def teaching_rows(robot: Robot) -> Folder:
    """Rows that record the arm's posture, edit each point, and follow, save and load all points."""
    rows: list[Row] = [
        Dropdown(
            Text(en="Move type", pt_BR="Tipo de movimento"),
            list(MOVE_TYPES.items()),
            lambda view: view.seat.move_type,
            lambda move_type: ForSeat(lambda seat: replace(seat, move_type=move_type)),
        ),
        Button(lambda _: ADD, lambda view: ForArm(gate.record(view.seat.move_type)), Icon.PLUS),
        Folder(
            Text(en="Waypoints", pt_BR="Pontos"), DependentRows(_names, partial(_points, robot.gripper is not None))
        ),
        scaling(lambda view: view.state.taught.shape, gate.choose_leg_shape),
        Button(
            lambda _: Text(en="Run waypoints", pt_BR="Executar os pontos"),
            lambda _: PlayTaught(),
            Icon.PLAYER_PLAY,
            lambda view: bool(view.state.taught.waypoints) and not view.state.arm.parked,
            weight="primary",
        ),
        Button(
            lambda _: Text(en="Save waypoints", pt_BR="Salvar pontos"),
            lambda view: Save(FILE, encode_waypoints(view.state.taught)),
            Icon.DOWNLOAD,
            lambda view: bool(view.state.taught.waypoints),
        ),
        Upload(
            Text(en="Load waypoints", pt_BR="Carregar pontos"),
            lambda _, __, content: ForArm(gate.take_waypoints(content)),
        ),
    ]
    return Folder(Text(en="Teach a path", pt_BR="Ensinar uma trajetória"), rows, open=False)


def _names(view: View) -> tuple[str, ...]:
    return tuple(waypoint.name for waypoint in view.state.taught.waypoints)


def _points(grips: bool, names: tuple[str, ...]) -> Sequence[Row]:
    return [Folder(untranslated(name), _point(place, name, grips), open=False) for place, name in enumerate(names)]


def _point(place: int, name: str, grips: bool) -> list[Row]:
    def here(view: View) -> Waypoint:
        return view.state.taught.waypoints[place]

    earlier = Text(en="{name}: move up", pt_BR="{name}: mover para cima").format(name=name)
    again = Text(en="{name}: use current posture", pt_BR="{name}: usar a postura atual").format(name=name)
    away = Text(en="{name}: remove", pt_BR="{name}: remover").format(name=name)
    return [
        TextEntry(
            Text(en="Name", pt_BR="Nome"),
            lambda _: name,
            Text(en="Rename", pt_BR="Renomear"),
            lambda typed: ForArm(gate.rename_waypoint(name, typed)),
        ),
        Dropdown(
            Text(en="Move type", pt_BR="Tipo de movimento"),
            list(MOVE_TYPES.items()),
            lambda view: here(view).move_type,
            lambda way: ForArm(gate.set_move_type(name, way)),
        ),
        Slider(
            Text(en="Dwell [s]", pt_BR="Espera [s]"),
            0.0,
            LONGEST_STAY,
            0.1,
            lambda view: here(view).dwell,
            lambda seconds: ForArm(gate.set_dwell(name, seconds)),
        ),
        *([_grip(name, here)] if grips else []),
        Button(lambda _: again, lambda _: ForArm(gate.teach_again(name)), Icon.TARGET),
        *(
            [Button(lambda _: earlier, lambda _: ForArm(gate.move_waypoint(name, place - 1)), Icon.ARROW_UP)]
            if place
            else []
        ),
        Button(lambda _: away, lambda _: ForArm(gate.delete_waypoint(name)), Icon.TRASH, weight="destructive"),
    ]


def _grip(name: str, here: Callable[[View], Waypoint]) -> Dropdown:
    return Dropdown(
        Text(en="Gripper", pt_BR="Garra"),
        list(GRIPPER_ACTIONS.items()),
        lambda view: here(view).gripper,
        lambda gripper: ForArm(gate.set_grip(name, gripper)),
    )


def ball_rows(robot: Robot) -> Folder:
    """The ball to grasp: place it, or put it on its stand and teach the points that carry it to another stand."""
    carried = Text(
        en="Teach the golf ball pick-and-place (Cerbaro 2022, fig. 21)",
        pt_BR="Ensinar a pegar e levar a bola de golfe (Cerbaro 2022, fig. 21)",
    )
    away = Text(en="Remove ball", pt_BR="Remover a bola")
    rows: list[Row] = [
        *([Button(lambda _: carried, lambda _: ForArm(gate.pick_and_place()))] if robot.name in gate.POINTS else []),
        VectorRow(Text(en="Ball, x y z [mm]", pt_BR="Bola, x y z [mm]"), 1.0, _ball, _put),
        Button(
            lambda _: away,
            lambda _: ForArm(gate.take_ball_away()),
            Icon.TRASH,
            lambda view: view.state.ball is not None,
            weight="destructive",
        ),
    ]
    return Folder(Text(en="Ball to grasp", pt_BR="Bola para pegar"), rows, open=False)


def _ball(view: View) -> tuple[float, float, float]:
    """The centre of the ball, mm; the origin if there is none."""
    ball = view.state.ball
    x, y, z = (0.0, 0.0, 0.0) if ball is None else (round(1000 * float(value), 1) for value in ball.centre)
    return x, y, z


def _put(view: View, millimetres: tuple[float, float, float]) -> PageRequest:
    return ForArm(gate.put_ball([value / 1000 for value in millimetres]))
