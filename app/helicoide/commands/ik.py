"""Inverse kinematics of a robot: the joint values for a tool pose."""

from __future__ import annotations

import json as json_format
import sys
from collections.abc import Iterator, Sequence
from math import isfinite
from typing import Annotated, Any, NamedTuple

import numpy as np
import tyro

from helicoide.arrays import Array, frozen
from helicoide.commands import NOT_REACHED, chain_ends, chain_ends_json, language, print_remarks
from helicoide.confinement import Obstacles
from helicoide.geometry import euler, rotation
from helicoide.ik.postures import solvability
from helicoide.ik.postures.answer import Answer
from helicoide.ik.postures.choice import COLLIDES, Ranked, equal_weights
from helicoide.ik.postures.solve import answer_status, ranked_postures, reached, solve, solve_by
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.text import HelicoideError, Language, Text, number_text, numbers_text, untranslated, with_decimal_comma

URDF = euler.EXTRINSIC + "xyz"
RESIDUAL = Text(
    en="   {mm:.4f} mm and {turned} from the target; {limits}",
    pt_BR="   a {mm:.4f} mm e {turned} do alvo; {limits}",
)
WITHIN = Text(en="within the joint limits", pt_BR="dentro dos limites das juntas")
OUTSIDE_LIMITS = Text(en="outside the joint limits", pt_BR="fora dos limites das juntas")
NO_NUMBER = Text(en="none", pt_BR="nenhum")
COST = Text(en="; cost {cost:.3f}", pt_BR="; custo {cost:.3f}")
RULED_OUT = Text(en="; ruled out: {why}", pt_BR="; descartada: {why}")
ALL_COLLIDE = Text(en="every posture found touches the obstacle", pt_BR="toda postura encontrada toca o obstáculo")


def run(
    robot: tyro.conf.Positional[str],
    position: Annotated[tuple[float, ...], tyro.conf.arg(help="where the end effector is to be, m", metavar="X Y Z")],
    quat: Annotated[tuple[float, ...] | None, tyro.conf.arg(metavar="W X Y Z")] = None,
    rpy: Annotated[tuple[float, ...] | None, tyro.conf.arg(metavar="R P Y")] = None,
    deg: bool = False,
    method: str | None = None,
    all: bool = False,
    start: Annotated[tuple[float, ...] | None, tyro.conf.arg(name="from")] = None,
    weights: tuple[float, ...] | None = None,
    obstacle: Annotated[tuple[float, ...] | None, tyro.conf.arg(metavar="X Y Z R")] = None,
    tip: str | None = None,
    base: str | None = None,
    set: tuple[str, ...] = (),
    json: bool = False,
) -> None:
    """Print the joint values that bring the tool to a pose, or to a position where no orientation is given.

    Ends with 0 if a posture within the joint limits reaches the target, with 3 if none does (the nearest posture is
    printed), and with 2 for wrong input.

    Args:
        robot: name of a robot, or the path of a URDF file.
        quat: the tool's orientation as a quaternion of any length but zero.
        rpy: the tool's orientation as roll, pitch and yaw of URDF: about the fixed x, y and z axes, one after another.
        deg: angles are in degrees: those given, and those printed.
        method: name of a closed form, of a method that iterates, or numeric; a wrong one lists what there is.
        all: print every posture, not only the nearest to where the arm is.
        start: joint values where the arm is, rad, or m where a joint slides; its posture ready if there are none.
        weights: what the motion of each joint costs, 1/rad, or 1/m where it slides; the cheapest posture is chosen.
        obstacle: centre and radius of a sphere, m; postures that touch it are ruled out.
        tip: the link of a URDF where the arm ends.
        base: the link of a URDF where the arm begins; its root if none.
        set: parameters of a robot to change, mm, such as l1=1500.
        json: print JSON (SI units).
    """
    arm = load_robot(robot, tip, set, base)
    print_remarks(arm)
    R = _orientation(quat, rpy, deg)
    T = np.eye(4)
    T[:3, 3] = _checked(position, "--position", 3)
    T[:3, :3] = np.eye(3) if R is None else R
    q = arm.poses["ready"] if start is None else _radians(arm, arm.check_joints(start), deg)
    choosing = weights is not None or obstacle is not None
    asked = (arm, T, q, all or choosing, R is not None)
    answer = solve(*asked) if method is None else solve_by(method, *asked)
    ranking = ranked_postures(
        arm, answer, q, equal_weights(arm) if weights is None else weights, _sphere(obstacle), R is not None
    )
    free = [row for row in ranking if row.dropped is not COLLIDES]
    shown = ranking if all else free[: 1 if choosing else None] or ranking
    told = answer.only([answer.branches.index(row.branch) for row in free])
    said = ALL_COLLIDE if answer.branches and not free else answer_status(told)
    if json:
        print(json_format.dumps(answer_json(arm, told, said, shown, T, R is not None), indent=1))
    else:
        print("\n".join(_lines(arm, (said, answer.words), shown, Style(deg, choosing, language()))))
    if not reached(told):
        sys.exit(NOT_REACHED)


def answer_json(
    robot: Robot, answer: Answer, words: Text, shown: Sequence[Ranked], T_world_tool: Array, with_orientation: bool
) -> dict[str, Any]:
    """An answer as JSON, in SI units, with texts in both languages.

    solvability: Pieper's test; goal: the requested pose; solved: the pose that was solved for, which differs from the
    goal by moved, m, and turned, rad, if it was projected; reached: whether the command ends with 0; short: distance of
    the goal from the workspace, m; missed and turned: position and orientation error of each branch, m and rad; cost:
    weighted motion of the joints; dropped: why a branch is ruled out; screws: lengths of the ball screws, m, null for
    a joint with a gear.
    """
    verdict = solvability.verdict(robot)
    return {
        "robot": robot.name,
        **chain_ends_json(robot),
        "solvability": {"closed": verdict.closed, "axes": [axis + 1 for axis in verdict.axes], **_words(verdict.words)},
        "joints": [joint.name for joint in robot.variables],
        "goal": _pose(T_world_tool, with_orientation),
        "solved": _pose(answer.T_world_goal, with_orientation),
        "moved": answer.moved,
        "turned": answer.turned,
        "short": answer.short,
        "reached": reached(answer),
        "status": _words(words),
        "words": _words(answer.words),
        "branches": [_described(robot, row) for row in shown],
    }


def _described(robot: Robot, row: Ranked) -> dict[str, Any]:
    branch, actuators = row.branch, robot.actuators
    lengths = [] if actuators is None else actuators.lengths(row.q).tolist()
    return {
        "name": _words(branch.name),
        "q": row.q.tolist(),
        "missed": branch.missed,
        "turned": branch.turned,
        "within": branch.within,
        "cost": row.cost,
        "dropped": None if row.dropped is None else _words(row.dropped),
        "screws": [length if isfinite(length) else None for length in lengths],
    }


def _pose(T: Array, with_orientation: bool) -> dict[str, list[float] | None]:
    quat = rotation.from_matrix(T[:3, :3]).tolist() if with_orientation else None
    return {"position": T[:3, 3].tolist(), "quaternion_wxyz": quat}


def _words(text: Text) -> dict[str, str]:
    return {"en": text.en, "pt_BR": text.pt_BR}


class Style(NamedTuple):
    """How an answer is printed: angles in degrees or rad, with or without costs, in which language."""

    deg: bool
    costs: bool
    language: Language


def _lines(robot: Robot, status: tuple[Text, Text], shown: Sequence[Ranked], style: Style) -> list[str]:
    """The answer as lines of text; status: in short, and how it was found."""
    spoken, (said, words) = style.language, status
    return [
        f"{robot.name}: {said[spoken]}",
        chain_ends(robot)[spoken],
        f"   {solvability.verdict(robot).words[spoken]}",
        *([f"   {words[spoken]}"] if words[spoken] else []),
        *(line for row in shown for line in _of_posture(robot, row, style)),
    ]


def _of_posture(robot: Robot, row: Ranked, style: Style) -> Iterator[str]:
    branch, (deg, costs, spoken) = row.branch, style
    values = ("; " if spoken == "pt_BR" else ", ").join(
        f"{joint.name} {_value(float(x), joint.is_prismatic, deg)[spoken]}"
        for joint, x in zip(robot.variables, row.q, strict=True)
    )
    turned = _turned(branch.turned, deg)
    left = RESIDUAL.format(mm=1000 * branch.missed, turned=turned, limits=WITHIN if branch.within else OUTSIDE_LIMITS)[
        spoken
    ]
    if costs:
        left += COST.format(cost=row.cost)[spoken]
    if row.dropped is COLLIDES:
        left += RULED_OUT.format(why=row.dropped)[spoken]
    yield f"{branch.name[spoken]}: {values}"
    yield left
    if robot.actuators is not None:
        yield f"   {robot.actuators.description(row.q)[spoken]}"


def _turned(angle: float, deg: bool) -> Text:
    value, unit = (number_text(np.degrees(angle), ".4f"), "°") if deg else (number_text(angle, ".2e"), " rad")
    return untranslated("{value}{unit}").format(value=value, unit=unit)


def _value(x: float, slides: bool, deg: bool) -> Text:
    decimals, unit = (7, " m") if slides else (5, "°") if deg else (7, " rad")
    shown = round(float(np.degrees(x)) if unit == "°" else x, decimals)
    return with_decimal_comma(f"{shown + 0.0:.{decimals}f}{unit}")  # + 0.0: no minus before a zero


def _radians(robot: Robot, values: Array, deg: bool) -> Array:
    if not deg:
        return values
    return frozen(np.where([joint.is_prismatic for joint in robot.variables], values, np.radians(values)))


def _orientation(quat: tuple[float, ...] | None, rpy: tuple[float, ...] | None, deg: bool) -> Array | None:
    """The requested rotation (3, 3); None if none is given."""
    if quat is not None and rpy is not None:
        raise HelicoideError(Text(en="Give --quat or --rpy, not both.", pt_BR="Use --quat ou --rpy, não os dois."))
    if quat is not None:
        w = _checked(quat, "--quat", 4)
        if not w.any():
            raise HelicoideError(
                Text(en="--quat is zero: it has no direction.", pt_BR="--quat é nulo: não tem direção.")
            )
        return rotation.to_matrix(rotation.unit_vector(w))
    if rpy is None:
        return None
    angles = _checked(rpy, "--rpy", 3)
    return euler.euler_matrix(np.radians(angles) if deg else angles, URDF)


def _sphere(given: tuple[float, ...] | None) -> Obstacles:
    """The given obstacle, or none."""
    if given is None:
        return Obstacles()
    *centre, radius = _checked(given, "--obstacle", 4)
    if radius <= 0:
        raise HelicoideError(
            Text(
                en="The radius of --obstacle, the last of its four numbers, must be positive, not {radius:g}.",
                pt_BR="O raio de --obstacle, o último dos quatro números, deve ser maior que zero, não {radius:g}.",
            ).format(radius=radius)
        )
    return Obstacles().with_sphere(np.array(centre), float(radius))


def _checked(values: tuple[float, ...], option: str, count: int) -> Array:
    if len(values) != count or not np.isfinite(values).all():
        raise HelicoideError(
            Text(
                en="{option} takes {n} finite numbers, not {given}.",
                pt_BR="{option} recebe {n} números finitos, não {given}.",
            ).format(option=option, n=count, given=numbers_text(values) if values else NO_NUMBER)
        )
    return frozen(values)
