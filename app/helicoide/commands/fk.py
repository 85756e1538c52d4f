"""Forward kinematics of a robot by its three roads."""

from __future__ import annotations

import json as json_format
import sys
from typing import Annotated, Any

import numpy as np
import tyro

from helicoide.commands import described_ends, ends, language, remark
from helicoide.geometry import rigid, rotation
from helicoide.geometry.clifford import CL031
from helicoide.kinematics.chain import Array, Variable
from helicoide.kinematics.forward import ROADS
from helicoide.kinematics.library import load
from helicoide.kinematics.robot import Robot
from helicoide.text import Text

POSE = Text(
    en="{road:>16}: position {position} m; quaternion wxyz {quaternion}",
    pt_BR="{road:>16}: posição {position} m; quatérnio wxyz {quaternion}",
)
OUTSIDE = Text(
    en="{joint} is at {value}, outside its limits: {lower} … {upper}",
    pt_BR="{joint} está em {value}, fora dos limites: {lower} … {upper}",
)
ROUNDING = 1e-9  # of a joint that is put on its limit, rad or m


def described(T_world_tool: Array) -> dict[str, object]:
    """A pose in all its forms: position, m; matrix; quaternion wxyz; motor coefficients by blade."""
    motor = rigid.canonical(rigid.motor_from_pose(T_world_tool))
    return {
        "position": T_world_tool[:3, 3].tolist(),
        "matrix": T_world_tool.tolist(),
        "quaternion_wxyz": rotation.from_matrix(T_world_tool[:3, :3]).tolist(),
        "motor": dict(zip(CL031.names, motor.tolist(), strict=True)),
    }


def outside(robot: Robot, q: Array) -> list[tuple[Variable, float]]:
    """The joints whose values, q (n,), rad or m, are outside their limits, with these values."""
    pairs = zip(robot.variables, map(float, q), strict=True)
    return [(joint, x) for joint, x in pairs if not joint.lower - ROUNDING <= x <= joint.upper + ROUNDING]


def run(
    robot: tyro.conf.Positional[str],
    q: Annotated[tuple[float, ...], tyro.conf.arg(help="joint values: rad, or m where a joint slides")],
    deg: bool = False,
    tip: str | None = None,
    base: str | None = None,
    set: tuple[str, ...] = (),
    json: bool = False,
) -> None:
    """Print where the tool is, by DH rows, successive screws and dual quaternions (SI units).

    A joint outside its limits is told of on the error output; the pose is printed all the same, and the command ends
    with 0. It ends with 2 for wrong input.

    Args:
        robot: name of a robot, or the path of a URDF file.
        q: joint values.
        deg: values of turning joints are in degrees.
        tip: the link of a URDF where the arm ends.
        base: the link of a URDF where the arm begins; its root if none.
        set: parameters of a robot to change, mm, such as l1=1500.
        json: print JSON.
    """
    arm = load(robot, tip, set, base)
    remark(arm)
    values = arm.check_joints(q)
    if deg:
        values = np.where([joint.slides for joint in arm.variables], values, np.radians(values))
    if json:
        print(json_format.dumps(_told(arm, values), indent=1))
        return
    spoken = language()
    print(f"{arm.name}:\n{ends(arm)[spoken]}")
    for name, road in ROADS.items():
        pose = road(arm, values)
        position, quat = _decimals(pose[:3, 3]), _decimals(rotation.from_matrix(pose[:3, :3]))
        print(POSE.format(road=name, position=position, quaternion=quat)[spoken])
    for joint, value in outside(arm, values):
        print(_warning(joint, value, deg)[spoken], file=sys.stderr)


def _told(robot: Robot, q: Array) -> dict[str, Any]:
    """What --json prints: the pose by each road, and the joints that are outside their limits."""
    return {
        "robot": robot.name,
        **described_ends(robot),
        "q": q.tolist(),
        "roads": {name: described(road(robot, q)) for name, road in ROADS.items()},
        "outside": [
            {"joint": joint.name, "value": value, "lower": joint.lower, "upper": joint.upper}
            for joint, value in outside(robot, q)
        ],
    }


def _warning(joint: Variable, value: float, deg: bool) -> Text:
    scale, unit = (1.0, " m") if joint.slides else (180 / np.pi, "°") if deg else (1.0, " rad")
    given, lower, upper = (f"{scale * x:.6g}{unit}" for x in (value, joint.lower, joint.upper))
    return OUTSIDE.format(joint=joint.name, value=given, lower=lower, upper=upper)


def _decimals(values: Array) -> str:
    return ", ".join(f"{value:.7f}" for value in values)
