"""What a State says of itself: named multivectors, distances, and the status in words."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from helicoide.confinement import Zone
from helicoide.geometry import rigid
from helicoide.geometry.clifford import CL031
from helicoide.ik import AtLimit, Contact
from helicoide.ik.goal import Goal
from helicoide.kinematics.chain import Array
from helicoide.state import Along, GetReady, Hold, Park, State, points_on
from helicoide.text import Text

Tone = Literal["ok", "warn", "blocked", "stopped"]
SHORT = 1e-3
TURNED = np.radians(1.0)


@dataclass(frozen=True, eq=False)
class Reading:
    """A multivector of the scene: a key that names its object, a title, a symbol in TeX, 16 coefficients (m)."""

    key: str
    title: Text
    symbol: str
    values: Array


def readings(state: State) -> list[Reading]:
    """Tool motor, joint lines, planes and guarded points as multivectors of Cl(0,3,1)."""
    return [_tool(state), *_lines(state), *_planes(state), *_points(state)]


def _tool(state: State) -> Reading:
    motor = rigid.canonical(rigid.motor_from_pose(state.T_world_tool))
    return Reading("tool", Text(en="tool motor", pt_BR="motor do efetuador"), "M", motor)


def _lines(state: State) -> list[Reading]:
    title = Text(en="axis of joint {n} ({joint})", pt_BR="eixo da junta {n} ({joint})")
    return [
        Reading(
            f"joint {i}",
            title.format(n=i + 1, joint=joint.title),
            rf"\ell_{i + 1}",
            rigid.line(state.axes[i], state.poses[i + 1, :3, 3]),
        )
        for i, joint in enumerate(state.robot.joints)
    ]


def _planes(state: State) -> list[Reading]:
    planes, title = state.problem.planes, Text(en="plane {name} ({pane})", pt_BR="plano {name} ({pane})")
    return [
        Reading(
            f"plane {k}",
            title.format(name=pane.name, pane=pane.title),
            rf"\pi_{{{pane.name}}}",
            rigid.plane(planes.normals[k], planes.offsets[k]),
        )
        for k, pane in enumerate(state.robot.panes)
    ]


def _points(state: State) -> list[Reading]:
    title = Text(en="point: {point}", pt_BR="ponto: {point}")
    return [
        Reading(f"point {j}", title.format(point=point.title), rf"p_{j + 1}", rigid.point(state.guarded_points[j]))
        for j, point in enumerate(state.robot.guarded)
    ]


def distance_product(state: State, point: int, plane: int) -> Array:
    """πp − pπ = 2 l e1e2e3e of a guarded point and a plane, (16,), m. Source: Cerbaro 2022, eq. 19."""
    pi = rigid.plane(state.problem.planes.normals[plane], state.problem.planes.offsets[plane])
    p = rigid.point(state.guarded_points[point])
    return np.subtract(CL031.product(pi, p), CL031.product(p, pi))


def plane_distances(state: State) -> Array:
    """Distances of every guarded point to every plane, (m, k), m."""
    return _distances(state, state.guarded_points)


def _distances(state: State, points: Array) -> Array:
    planes = state.problem.planes
    return np.asarray(points @ planes.normals.T - planes.offsets)


def nearest(state: State) -> Contact:
    """The guarded point and the plane that are closest to each other."""
    table = plane_distances(state)
    point, plane = np.unravel_index(np.argmin(table), table.shape)
    return Contact(int(plane), int(point))


def zones(state: State) -> tuple[Zone, ...]:
    """The zone of each plane: that of the guarded point nearest to it."""
    return tuple(state.problem.zones.of(float(least)) for least in plane_distances(state).min(axis=0))


@dataclass(frozen=True)
class Status:
    """What the arm does, or why it does not, and how grave that is."""

    text: Text
    tone: Tone


def status(state: State) -> Status:
    """The state in words: a refusal first, then what holds the arm, then what it does."""
    if state.notice is not None:
        return Status(state.notice, "warn")
    if state.command == Hold(stopped=True) and state.parked:
        return Status(
            Text(
                en="Stopped, with the planes off: only Ready or Park move the arm.",
                pt_BR="Parado, com os planos desligados: só Pronto ou Estacionar movem o braço.",
            ),
            "stopped",
        )
    if state.command == Hold(stopped=True):
        return Status(
            Text(
                en="Stopped. Nothing moves until the next press.",
                pt_BR="Parado. Nada se move até o próximo comando.",
            ),
            "stopped",
        )
    if state.parked or isinstance(state.command, Park | GetReady):
        return _parking(state)
    if state.goal is not None and not isinstance(state.command, Hold):
        return _towards(state, state.goal)
    return Status(Text(en="Ready: drag the target or a slider.", pt_BR="Pronto: arraste o alvo ou um controle."), "ok")


def _parking(state: State) -> Status:
    if isinstance(state.command, Hold):
        return Status(
            Text(
                en="Parked: planes are off. Ready brings the arm back.",
                pt_BR="Estacionado: planos desligados. Pronto traz o braço de volta.",
            ),
            "warn",
        )
    if not state.parked and state.goal is not None and state.goal.short > SHORT:
        return Status(_held_back(state, state.goal), "blocked")
    if isinstance(state.command, Park):
        if not state.parked and not state.moving and state.rested > 1.0:
            return Status(
                Text(
                    en="Cannot park: a plane is too near to the ready pose. Move it first.",
                    pt_BR="Não dá para estacionar: um plano está perto demais da pose pronta. Mova-o primeiro.",
                ),
                "blocked",
            )
        return Status(Text(en="Going to park.", pt_BR="Indo estacionar."), "ok")
    return Status(Text(en="Going to the ready pose.", pt_BR="Indo para a pose pronta."), "ok")


def _towards(state: State, goal: Goal) -> Status:
    """On the way to a wish, or at the nearest point to it."""
    if state.detour is not None:
        return Status(
            Text(
                en="Changing posture: another one comes nearer to the goal.",
                pt_BR="Mudando de postura: outra chega mais perto do objetivo.",
            ),
            "ok",
        )
    if goal.short > SHORT:
        return Status(_held_back(state, goal), "blocked")
    if state.with_orientation and goal.turned > TURNED:
        return Status(_misaligned(state, goal), "warn")
    if isinstance(state.command, Along) and state.command.playing:
        return Status(Text(en="Following the ellipse.", pt_BR="Seguindo a elipse."), "ok")
    if state.moving:
        return Status(Text(en="Moving.", pt_BR="Em movimento."), "ok")
    return Status(Text(en="At the goal.", pt_BR="No objetivo."), "ok")


def _held_back(state: State, goal: Goal) -> Text:
    """Why the wish is not met: the plane and the point it holds, the joint at its limit, or the reach."""
    reason = goal.reasons[0] if goal.reasons else None
    short = f"{1000 * goal.short:.0f}"
    match reason:
        case Contact(plane, point):
            pane, guarded = state.robot.panes[plane], state.robot.guarded[point]
            return Text(
                en="Blocked by plane {name} ({pane}): {point} at {mm:.0f} mm; {short} mm short.",
                pt_BR="Bloqueado pelo plano {name} ({pane}): {point} a {mm:.0f} mm; faltam {short} mm.",
            ).format(
                name=pane.name,
                pane=pane.title,
                point=guarded.title,
                mm=1000 * _distance_at(state, goal, reason),
                short=short,
            )
        case AtLimit(joint):
            return Text(
                en="Joint {n} ({title}) at its limit; {short} mm short: nearest point shown.",
                pt_BR="Junta {n} ({title}) no limite; faltam {short} mm: o ponto mais próximo é mostrado.",
            ).format(n=joint + 1, title=state.robot.variables[joint].title, short=short)
        case None:
            return Text(
                en="Out of reach by {short} mm: nearest point shown.",
                pt_BR="Fora de alcance por {short} mm: o ponto mais próximo é mostrado.",
            ).format(short=short)


def _distance_at(state: State, goal: Goal, contact: Contact) -> float:
    """The distance of a contact's point to its plane at the goal, m."""
    return float(_distances(state, points_on(state.robot, goal.poses))[contact.point, contact.plane])


def _misaligned(state: State, goal: Goal) -> Text:
    """What the arm cannot do about the orientation: a joint at its limit, or a joint that it does not have."""
    limit = next((reason for reason in goal.reasons if isinstance(reason, AtLimit)), None)
    why = (
        Text(
            en="with {n} joints the position decides the heading",
            pt_BR="com {n} juntas a posição decide a direção",
        ).format(n=len(state.robot.variables))
        if limit is None
        else Text(en="joint {n} is at its limit", pt_BR="a junta {n} está no limite").format(n=limit.joint + 1)
    )
    return Text(
        en="Position held, orientation {turned:.0f}° off: {why}.",
        pt_BR="Posição mantida, orientação a {turned:.0f}°: {why}.",
    ).format(turned=np.degrees(goal.turned), why=why)
