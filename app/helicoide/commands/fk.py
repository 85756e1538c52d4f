"""Forward kinematics of a robot by its three roads."""

from __future__ import annotations

import json as json_format
from typing import Annotated

import numpy as np
import tyro

from helicoide.geometry import rigid, rotation
from helicoide.geometry.clifford import CL031
from helicoide.kinematics.chain import Array
from helicoide.kinematics.forward import ROADS
from helicoide.kinematics.library import load


def described(T_world_tool: Array) -> dict[str, object]:
    """A pose in all its forms: position, m; matrix; quaternion wxyz; motor coefficients by blade."""
    motor = rigid.canonical(rigid.motor_from_pose(T_world_tool))
    return {
        "position": T_world_tool[:3, 3].tolist(),
        "matrix": T_world_tool.tolist(),
        "quaternion_wxyz": rotation.from_matrix(T_world_tool[:3, :3]).tolist(),
        "motor": dict(zip(CL031.names, motor.tolist(), strict=True)),
    }


def run(
    robot: tyro.conf.Positional[str],
    q: Annotated[tuple[float, ...], tyro.conf.arg(help="joint values: rad, or m where a joint slides")],
    deg: bool = False,
    tip: str | None = None,
    set: tuple[str, ...] = (),
    json: bool = False,
) -> None:
    """Print where the tool is, by DH rows, successive screws and dual quaternions (SI units).

    Args:
        robot: name of a robot, or the path of a URDF file.
        q: joint values.
        deg: values of turning joints are in degrees.
        tip: the link of a URDF where the arm ends.
        set: parameters of a robot to change, mm, such as l1=1500.
        json: print JSON.
    """
    arm = load(robot, tip, set)
    values = arm.check_joints(q)
    if deg:
        values = np.where([joint.slides for joint in arm.variables], values, np.radians(values))
    if json:
        roads = {name: described(road(arm, values)) for name, road in ROADS.items()}
        print(json_format.dumps({"robot": arm.name, "q": values.tolist(), "roads": roads}, indent=1))
        return
    for name, road in ROADS.items():
        pose = road(arm, values)
        position, quat = _decimals(pose[:3, 3]), _decimals(rotation.from_matrix(pose[:3, :3]))
        print(f"{name:>16}: position {position} m; quaternion wxyz {quat}")


def _decimals(values: Array) -> str:
    return ", ".join(f"{value:.7f}" for value in values)
