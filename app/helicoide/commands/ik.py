"""Inverse kinematics of a robot: the joint values for a pose of the tool."""

from __future__ import annotations

import json as json_format
import sys
from typing import Annotated, Any

import numpy as np
import tyro

from helicoide.commands import NOT_REACHED, described_ends, ends, language, remark
from helicoide.geometry import euler, rotation
from helicoide.ik.postures.branch import Answer, Branch
from helicoide.ik.postures.solve import reached, solve, solve_by, status
from helicoide.kinematics.chain import Array, frozen
from helicoide.kinematics.library import load
from helicoide.kinematics.robot import Robot
from helicoide.text import HelicoideError, Language, Text

URDF = euler.EXTRINSIC + "xyz"
LEFT = Text(
    en="   misses the goal by {mm:.4f} mm and {turned}; {limits}",
    pt_BR="   faltam {mm:.4f} mm e {turned} para o alvo; {limits}",
)
WITHIN = Text(en="within the joint limits", pt_BR="dentro dos limites das juntas")
BEYOND = Text(en="beyond the joint limits", pt_BR="além dos limites das juntas")


def run(
    robot: tyro.conf.Positional[str],
    position: Annotated[tuple[float, ...], tyro.conf.arg(help="where the tool is to be: X Y Z, m", metavar="X Y Z")],
    quat: Annotated[tuple[float, ...] | None, tyro.conf.arg(metavar="W X Y Z")] = None,
    rpy: Annotated[tuple[float, ...] | None, tyro.conf.arg(metavar="R P Y")] = None,
    deg: bool = False,
    method: str | None = None,
    all: bool = False,
    start: Annotated[tuple[float, ...] | None, tyro.conf.arg(name="from")] = None,
    tip: str | None = None,
    base: str | None = None,
    set: tuple[str, ...] = (),
    json: bool = False,
) -> None:
    """Print the joint values that bring the tool to a pose, or to a position where no orientation is given.

    Ends with 0 when a posture within the joint limits reaches what was asked for, with 3 when none does (the nearest
    that was found is printed), and with 2 for wrong input.

    Args:
        robot: name of a robot, or the path of a URDF file.
        quat: the tool's orientation as a quaternion of any length but zero.
        rpy: the tool's orientation as roll, pitch and yaw of URDF: about the fixed x, y and z axes, one after another.
        deg: angles are in degrees: those given, and those printed.
        method: name of a closed form, of a method that iterates, or numeric; a wrong one lists what there is.
        all: print every posture, not only the nearest to where the arm is.
        start: joint values where the arm is, rad, or m where a joint slides; its posture ready if there are none.
        tip: the link of a URDF where the arm ends.
        base: the link of a URDF where the arm begins; its root if none.
        set: parameters of a robot to change, mm, such as l1=1500.
        json: print JSON (SI units).
    """
    arm = load(robot, tip, set, base)
    remark(arm)
    R = _orientation(quat, rpy, deg)
    T = np.eye(4)
    T[:3, 3] = _checked(position, "--position", 3)
    T[:3, :3] = np.eye(3) if R is None else R
    q = arm.poses["ready"] if start is None else _radians(arm, arm.check_joints(start), deg)
    asked = (arm, T, q, all, R is not None)
    answer = solve(*asked) if method is None else solve_by(method, *asked)
    if json:
        print(json_format.dumps(described(arm, answer, T, R is not None), indent=1))
    else:
        print("\n".join(_lines(arm, answer, deg, language())))
    if not reached(answer):
        sys.exit(NOT_REACHED)


def described(robot: Robot, answer: Answer, T_world_tool: Array, with_orientation: bool) -> dict[str, Any]:
    """An answer in SI units; words in both languages.

    goal is what was asked for, solved what was solved for: other than the goal by moved and turned where it was
    projected; reached: whether the command ends with 0; short: how far the goal lies beyond the workspace; missed and
    turned: what each branch leaves of it.
    """
    return {
        "robot": robot.name,
        **described_ends(robot),
        "joints": [joint.name for joint in robot.variables],
        "goal": _pose(T_world_tool, with_orientation),
        "solved": _pose(answer.T_world_goal, with_orientation),
        "moved": answer.moved,
        "turned": answer.turned,
        "short": answer.short,
        "reached": reached(answer),
        "status": _words(status(answer)),
        "words": _words(answer.words),
        "branches": [
            {
                "name": _words(branch.name),
                "q": branch.q.tolist(),
                "missed": branch.missed,
                "turned": branch.turned,
                "within": branch.within,
            }
            for branch in answer.branches
        ],
    }


def _pose(T: Array, with_orientation: bool) -> dict[str, list[float] | None]:
    quat = rotation.from_matrix(T[:3, :3]).tolist() if with_orientation else None
    return {"position": T[:3, 3].tolist(), "quaternion_wxyz": quat}


def _words(text: Text) -> dict[str, str]:
    return {"en": text.en, "pt_BR": text.pt_BR}


def _lines(robot: Robot, answer: Answer, deg: bool, spoken: Language) -> list[str]:
    """The answer as people read it."""
    return [
        f"{robot.name}: {status(answer)[spoken]}",
        ends(robot)[spoken],
        *([f"   {answer.words[spoken]}"] if answer.words[spoken] else []),
        *(line for branch in answer.branches for line in _of_branch(robot, branch, deg, spoken)),
    ]


def _of_branch(robot: Robot, branch: Branch, deg: bool, spoken: Language) -> tuple[str, str]:
    values = ", ".join(
        f"{joint.name} {_value(float(x), joint.slides, deg)}"
        for joint, x in zip(robot.variables, branch.q, strict=True)
    )
    turned = f"{np.degrees(branch.turned):.4f}°" if deg else f"{branch.turned:.2e} rad"
    left = LEFT.format(mm=1000 * branch.missed, turned=turned, limits=WITHIN if branch.within else BEYOND)
    return f"{branch.name[spoken]}: {values}", left[spoken]


def _value(x: float, slides: bool, deg: bool) -> str:
    decimals, unit = (7, " m") if slides else (5, "°") if deg else (7, " rad")
    shown = round(float(np.degrees(x)) if unit == "°" else x, decimals)
    return f"{shown + 0.0:.{decimals}f}{unit}"  # + 0.0: no minus before a zero


def _radians(robot: Robot, values: Array, deg: bool) -> Array:
    if not deg:
        return values
    return frozen(np.where([joint.slides for joint in robot.variables], values, np.radians(values)))


def _orientation(quat: tuple[float, ...] | None, rpy: tuple[float, ...] | None, deg: bool) -> Array | None:
    """The rotation that is asked for, (3, 3); None where there is none."""
    if quat is not None and rpy is not None:
        raise HelicoideError(Text(en="Give --quat or --rpy, not both.", pt_BR="Use --quat ou --rpy, não os dois."))
    if quat is not None:
        w = _checked(quat, "--quat", 4)
        if not w.any():
            raise HelicoideError(
                Text(en="--quat is zero: it has no direction.", pt_BR="--quat é nulo: não tem direção.")
            )
        return rotation.to_matrix(rotation.unit(w))
    if rpy is None:
        return None
    angles = _checked(rpy, "--rpy", 3)
    return euler.matrix(np.radians(angles) if deg else angles, URDF)


def _checked(values: tuple[float, ...], option: str, count: int) -> Array:
    if len(values) != count or not np.isfinite(values).all():
        raise HelicoideError(
            Text(
                en="{option} takes {n} finite numbers, not {given}.",
                pt_BR="{option} recebe {n} números finitos, não {given}.",
            ).format(option=option, n=count, given=", ".join(f"{value:g}" for value in values) or "none")
        )
    return frozen(values)
