"""Drive the arm by joints, poses, numbers and along a path."""

from __future__ import annotations

from types import ModuleType

import numpy as np
from markupsafe import Markup
from viser import Icon

from helicoide import gate, readout
from helicoide.command import MoveToJoints
from helicoide.geometry import rotation
from helicoide.kinematics.library import robot_titles
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.robot_faults import remarks_and_faults
from helicoide.text import Text, untranslated
from helicoide.view import html, layers
from helicoide.view.obstacle_rows import entry_point_rows, obstacle_rows
from helicoide.view.path_rows import path_rows
from helicoide.view.plan_rows import plan_rows
from helicoide.view.plane_rows import plane_rows
from helicoide.view.posture_rows import posture_rows
from helicoide.view.requests import ForArm, ForLab, ForSeat, PageRequest
from helicoide.view.rows import Button, Checkbox, Dropdown, Folder, HtmlRow, Row, Slider, VectorRow
from helicoide.view.teaching_rows import ball_rows, teaching_rows
from helicoide.view.window_view import View
from helicoide.view.workspace_rows import workspace_rows

TITLE = Text(en="Robot", pt_BR="Robô")
ORDER = 1
ICON = Icon.ROBOT

READY = Text(en="Ready pose", pt_BR="Ir à pose inicial")
SHOW = Text(en="Show", pt_BR="Mostrar")
PARK = Text(en="Park (planes off)", pt_BR="Estacionar (sem planos)")


def rows(robot: Robot) -> list[Row]:
    """The panel for one robot."""
    return [
        _choice(robot),
        HtmlRow(_remarks),
        Button(lambda _: READY, lambda _: ForArm(gate.get_ready()), Icon.PLAYER_TRACK_NEXT, weight="primary"),
        *([Button(lambda _: PARK, lambda _: ForArm(gate.park()), Icon.PARKING)] if robot.panes else []),
        _poses(robot),
        Folder(Text(en="Joints [°]", pt_BR="Juntas [°]"), [joint_row(robot, i) for i in range(len(robot.variables))]),
        *([_gripper()] if robot.gripper else []),
        Folder(Text(en="Target", pt_BR="Alvo"), _target()),
        posture_rows(robot),
        plan_rows(robot),
        path_rows(robot),
        teaching_rows(robot),
        *([ball_rows(robot)] if gate.can_grasp(robot) else []),
        plane_rows(robot),
        obstacle_rows(robot),
        *([entry_point_rows()] if "rcm" in robot.frames else []),
        workspace_rows(robot),
        Folder(SHOW, _shows(robot), open=False),
    ]


def _choice(robot: Robot) -> Dropdown:
    """Every robot with a folder, and the one that was asked for at the start."""
    return Dropdown(
        label=Text(en="Arm", pt_BR="Braço"),
        options=list({robot.name: robot.title, **robot_titles()}.items()),
        value=lambda view: view.state.robot.name,
        request=ForLab,
    )


def _remarks(view: View) -> Markup:
    """Remarks on the robot: how its files were read, what is not drawn, and contradictions."""
    robot, language = view.state.robot, view.seat.language
    return Markup("").join(html.note(remark[language]) for remark in remarks_and_faults(robot))


def _driving(view: View) -> bool:
    return not view.state.arm.parked


def joint_row(robot: Robot, index: int) -> Slider:
    """A joint, in degrees or millimetres."""
    joint = robot.variables[index]
    scale, unit = (1000.0, " [mm]") if joint.is_prismatic else (180 / np.pi, "")

    def value(view: View) -> float:
        command = view.state.request.command
        q = command.q if isinstance(command, MoveToJoints) else view.state.arm.q
        return float(scale * q[index])

    return Slider(
        label=untranslated("{n} {title}{unit}").format(n=index + 1, title=joint.title, unit=unit),
        lower=float(np.ceil(10 * scale * joint.lower - 1e-6)) / 10,
        upper=float(np.floor(10 * scale * joint.upper + 1e-6)) / 10,
        step=0.1,
        value=value,
        request=lambda shown: ForArm(gate.set_joint(index, shown / scale)),
        enabled=_driving,
    )


def _poses(robot: Robot) -> Dropdown:
    """Named poses: choosing one goes there; the row then shows the neutral entry again."""
    none = Text(en="choose …", pt_BR="escolha …")
    return Dropdown(
        label=Text(en="Go to pose", pt_BR="Ir para a pose"),
        options=[("", none), *robot.pose_titles.items()],
        value=lambda _: "",
        request=lambda name: ForArm(gate.go_to(name) if name else lambda state: state),
    )


def _gripper() -> Slider:
    return Slider(
        label=Text(en="Gripper [%]", pt_BR="Garra [%]"),
        lower=0.0,
        upper=100.0,
        step=1.0,
        value=lambda view: 100 * view.state.request.gripper,
        request=lambda percent: ForArm(gate.set_gripper(percent / 100)),
    )


def _target() -> list[Row]:
    return [
        VectorRow(Text(en="x y z [mm]", pt_BR="x y z [mm]"), 1.0, _position, _set_position),
        VectorRow(
            Text(en="Yaw, pitch, roll (ZYX) [°]", pt_BR="Guinada, arfagem, rolagem (ZYX) [°]"),
            1.0,
            _angles,
            _set_angles,
        ),
        Checkbox(
            Text(en="Keep orientation", pt_BR="Manter a orientação"),
            lambda view: view.state.request.with_orientation,
            lambda on: ForArm(gate.keep_orientation(on)),
        ),
    ]


def _position(view: View) -> tuple[float, float, float]:
    x, y, z = (round(1000 * float(value), 1) for value in readout.target_pose(view.state)[:3, 3])
    return x, y, z


def _angles(view: View) -> tuple[float, float, float]:
    """Angles about z, y, x: Roll, Pitch and Yaw in the naming of Cerbaro 2022, eqs. 53–55."""
    angles = rotation.roll_pitch_yaw_zyx(readout.target_pose(view.state)[:3, :3])
    z, y, x = (round(float(np.degrees(angle)), 1) + 0.0 for angle in angles)
    return z, y, x


def _set_position(view: View, millimetres: tuple[float, float, float]) -> PageRequest:
    quat = rotation.from_matrix(readout.target_pose(view.state)[:3, :3])
    return ForArm(gate.set_target(np.asarray(millimetres) / 1000, quat))


def _set_angles(view: View, degrees: tuple[float, float, float]) -> PageRequest:
    z, y, x = (
        rotation.from_axis_angle(axis, np.radians(angle)) for axis, angle in zip(np.eye(3)[::-1], degrees, strict=True)
    )
    quat = rotation.multiply(rotation.multiply(z, y), x)
    return ForArm(gate.set_target(readout.target_pose(view.state)[:3, 3], quat))


def _shows(robot: Robot) -> list[Row]:
    """A folder for each kind of layers."""
    kinds = {kind: [layer for layer in layers.optional() if kind == layer.KIND] for kind in layers.KINDS}
    return [
        Folder(layers.KINDS[kind], [row for layer in listed for row in _of_layer(layer, robot)])
        for kind, listed in kinds.items()
    ]


def _of_layer(layer: ModuleType, robot: Robot) -> list[Row]:
    """A checkbox, the line that says what is seen while the layer is shown, and the settings of the layer."""
    name: str = layer.NAME

    def line(view: View) -> Markup:
        return html.note(layer.SAID[view.seat.language]) if view.seat.visible_layers[name] else Markup("")

    return [_show(name, layer.TITLE), HtmlRow(line), *(layer.rows(robot) if hasattr(layer, "rows") else ())]


def _show(name: str, title: Text) -> Checkbox:
    return Checkbox(
        title, lambda view: view.seat.visible_layers[name], lambda on: ForSeat(lambda seat: seat.with_layer(name, on))
    )
