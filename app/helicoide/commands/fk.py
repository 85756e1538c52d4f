"""Forward kinematics of a robot by three formulations, joint by joint on request, and its motor readings."""

from __future__ import annotations

import json as json_format
import sys
from math import isnan
from typing import Annotated, Any, Literal

import numpy as np
import tyro

from helicoide.arrays import Array
from helicoide.commands import chain_ends, chain_ends_json, language, print_remarks
from helicoide.export import stage_table
from helicoide.geometry import rigid, rotation
from helicoide.geometry.clifford import CL031
from helicoide.kernels import run_interpreted
from helicoide.kinematics.chain import JointVariable
from helicoide.kinematics.forward import FORMULATIONS
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.singularity import NEAR_SINGULAR, singularity
from helicoide.kinematics.stages import StageKind
from helicoide.text import HelicoideError, Text, number_text, numbers_text, untranslated

POSE = Text(
    en="{road:>16}: position {position} m; quaternion wxyz {quaternion}",
    pt_BR="{road:>16}: posição {position} m; quatérnio wxyz {quaternion}",
)
OUTSIDE = Text(
    en="{joint} is at {value}, outside its limits: {lower} … {upper}",
    pt_BR="{joint} está em {value}, fora dos limites: {lower} … {upper}",
)
NO_FRAMES = Text(
    en="--as source is for --frames dh, screws or products.",
    pt_BR="--as source vale com --frames dh, screws ou products.",
)
SINGULAR = Text(en="singularity: {words}", pt_BR="singularidade: {words}")
MOTORS = Text(en="motors, pulses from an assumed zero:", pt_BR="motores, pulsos a partir de um zero assumido:")
MOTOR_READING = Text(
    en="{label:>16}: {angle:.6g}°, {pulses:.6g} pulses", pt_BR="{label:>16}: {angle:.6g}°, {pulses:.6g} pulsos"
)
SCREW = Text(
    en="{label:>16}: {angle:.6g}°, {pulses:.6g} pulses, screw {mm:.1f} mm long",
    pt_BR="{label:>16}: {angle:.6g}°, {pulses:.6g} pulsos, fuso com {mm:.1f} mm",
)
ROUNDING = 1e-9  # tolerance of a joint on its limit, rad or m


def pose_json(T_world_tool: Array, robot: Robot) -> dict[str, object]:
    """A pose as JSON: its two frames, position, m, matrix, quaternion wxyz, and motor by blade."""
    motor = rigid.canonical(rigid.motor_from_pose(T_world_tool))
    return {
        "frame": robot.tool_link,
        "in": robot.base_link,
        "position": T_world_tool[:3, 3].tolist(),
        "matrix": T_world_tool.tolist(),
        "quaternion_wxyz": rotation.from_matrix(T_world_tool[:3, :3]).tolist(),
        "motor": dict(zip(CL031.names, motor.tolist(), strict=True)),
    }


def joints_outside_limits(robot: Robot, q: Array) -> list[tuple[JointVariable, float]]:
    """The joints of q (n,), rad or m, that are outside their limits, with their values."""
    pairs = zip(robot.variables, map(float, q), strict=True)
    return [(joint, x) for joint, x in pairs if not joint.lower - ROUNDING <= x <= joint.upper + ROUNDING]


@run_interpreted()
def run(
    robot: tyro.conf.Positional[str],
    q: Annotated[tuple[float, ...], tyro.conf.arg(help="joint values: rad, or m where a joint slides")],
    deg: bool = False,
    tip: str | None = None,
    base: str | None = None,
    set: tuple[str, ...] = (),
    frames: StageKind | None = None,
    as_: Annotated[Literal["si", "source"], tyro.conf.arg(name="as")] = "si",
    json: bool = False,
) -> None:
    """Print where the tool is, by DH rows, successive screws and dual quaternions (SI units).

    Then print how near the posture is to a singularity. A joint outside its limits causes a warning on stderr; the pose
    is still printed, and the command ends with 0. It ends with 2 for wrong input.

    Args:
        robot: name of a robot, or the path of a URDF file.
        q: joint values.
        deg: values of turning joints are in degrees.
        tip: the link of a URDF where the arm ends.
        base: the link of a URDF where the arm begins; its root if none.
        set: parameters of a robot to change, mm, such as l1=1500.
        frames: joint by joint instead: DH rows and frames, screws and displacements, or products of dual quaternions.
        as_: units of --frames: metres and radians, or the millimetres and degrees that the sources print.
        json: print JSON.
    """
    if as_ == "source" and frames is None:
        raise HelicoideError(NO_FRAMES)
    arm = load_robot(robot, tip, set, base)
    print_remarks(arm)
    values = arm.check_joints(q)
    if deg:
        values = np.where([joint.is_prismatic for joint in arm.variables], values, np.radians(values))
    if json:
        staged = {} if frames is None else {"frames": stage_table.stages_json(arm, values, frames, as_ == "source")}
        print(json_format.dumps(_as_json(arm, values) | staged, indent=1))
        return
    spoken = language()
    for line in (
        _poses(arm, values) if frames is None else stage_table.stage_lines(arm, values, frames, as_ == "source")
    ):
        print(line[spoken])
    for joint, value in joints_outside_limits(arm, values):
        print(_warning(joint, value, deg)[spoken], file=sys.stderr)


def _poses(robot: Robot, q: Array) -> list[Text]:
    """The tool pose by each formulation, how near the posture is to a singularity, and the motor readings."""
    lines = [untranslated(f"{robot.name}:"), chain_ends(robot)]
    for name, road in FORMULATIONS.items():
        pose = road(robot, q)
        position, quat = _decimals(pose[:3, 3]), _decimals(rotation.from_matrix(pose[:3, :3]))
        lines.append(POSE.format(road=name, position=position, quaternion=quat))
    lines.append(SINGULAR.format(words=singularity(robot, q).description(NEAR_SINGULAR)))
    motors = motor_readings(robot, q)
    if isinstance(motors, Text):
        return [*lines, motors]
    told = [
        (MOTOR_READING if isnan(length) else SCREW).format(
            label=label, angle=np.degrees(angle), pulses=pulses + 0.0, mm=1000 * length
        )
        for label, angle, pulses, length in motors
    ]
    return [*lines, MOTORS, *told] if told else lines


Motor = tuple[str, float, float, float]


def motor_readings(robot: Robot, q: Array) -> list[Motor] | Text:
    """For each actuator: label, driven angle, rad, pulses, and length of its ball screw, m, NaN if it has none.

    Returns the reason instead if an actuator cannot reach its angle.
    """
    actuators = robot.actuators
    if actuators is None:
        return []
    try:
        pulses = actuators.from_joints(q)
    except HelicoideError as error:
        return error.text
    numbers = (actuators.coupling @ q, pulses, actuators.lengths(q))
    return list(zip(actuators.labels, *(map(float, values) for values in numbers), strict=True))


def _as_json(robot: Robot, q: Array) -> dict[str, Any]:
    """What --json prints: poses by formulation, nearness to a singularity, motors, and joints outside limits."""
    here = singularity(robot, q)
    words = here.description(NEAR_SINGULAR)
    return {
        "robot": robot.name,
        **chain_ends_json(robot),
        "q": q.tolist(),
        "roads": {name: pose_json(road(robot, q), robot) for name, road in FORMULATIONS.items()},
        "singularity": {
            "rank": here.rank,
            "usual": here.generic_rank,
            "factors": {factor.kind.name.lower(): factor.relative for factor in here.factors},
            "words": {"en": words.en, "pt_BR": words.pt_BR},
        },
        "motors": _motors(motor_readings(robot, q)),
        "outside": [
            {"joint": joint.name, "value": value, "lower": joint.lower, "upper": joint.upper}
            for joint, value in joints_outside_limits(robot, q)
        ],
    }


def _motors(found: list[Motor] | Text) -> list[dict[str, Any]]:
    if isinstance(found, Text):
        return []
    return [
        {"motor": label, "driven": angle, "pulses": pulses, "screw": None if isnan(length) else length}
        for label, angle, pulses, length in found
    ]


def _warning(joint: JointVariable, value: float, deg: bool) -> Text:
    scale, unit = (1.0, " m") if joint.is_prismatic else (180 / np.pi, "°") if deg else (1.0, " rad")
    given, lower, upper = (
        untranslated("{x}{unit}").format(x=number_text(scale * x, ".6g"), unit=unit)
        for x in (value, joint.lower, joint.upper)
    )
    return OUTSIDE.format(joint=joint.name, value=given, lower=lower, upper=upper)


def _decimals(values: Array) -> Text:
    return numbers_text(values, ".7f")
