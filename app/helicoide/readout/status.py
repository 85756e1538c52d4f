"""What the arm does, or why it does not, in words."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from helicoide.arrays import Array
from helicoide.command import FollowPath, GetReady, HoldPosition, MoveToPose, Park, Replay
from helicoide.ik import (
    AtAcceleration,
    AtEntryPoint,
    AtLimit,
    AtSpeed,
    Contact,
    ObstacleContact,
    Problem,
    Reason,
    SelfContact,
    methods,
)
from helicoide.ik.controller import GUARDED
from helicoide.ik.goal import Goal
from helicoide.ik.postures.choice import barrier
from helicoide.readout.distances import distances_of
from helicoide.readout.instruments import errors, held_by
from helicoide.state import State, points_on
from helicoide.text import Text

Tone = Literal["ok", "warn", "blocked", "stopped"]

SHORT, ARRIVED = 1e-3, 10e-3
TURNED = np.radians(1.0)

FOLLOWING = Text(en="Following: {path}.", pt_BR="Seguindo: {path}.")
MOVING = Text(en="Moving.", pt_BR="Em movimento.")
AT_THE_GOAL = Text(en="At the goal.", pt_BR="No objetivo.")


@dataclass(frozen=True)
class Status:
    """What the arm does, or why it does not, and how grave that is."""

    text: Text
    tone: Tone


def status(state: State) -> Status:
    """The state in words: a refusal first, then what holds the arm, then what it does."""
    if state.notice is not None:
        return Status(state.notice, "warn")
    if state.request.command == HoldPosition(stopped=True) and state.arm.parked:
        return Status(
            Text(
                en="Stopped, with the planes off: only Ready or Park move the arm.",
                pt_BR="Parado, com os planos desligados: só Pronto ou Estacionar movem o braço.",
            ),
            "stopped",
        )
    if state.request.command == HoldPosition(stopped=True):
        return Status(
            Text(
                en="Stopped. Nothing moves until the next press.",
                pt_BR="Parado. Nada se move até o próximo comando.",
            ),
            "stopped",
        )
    if isinstance(state.request.command, Replay):
        return Status(_replaying(state, state.request.command), "ok")
    if state.arm.parked or isinstance(state.request.command, Park | GetReady):
        return _parking(state)
    if isinstance(state.request.command, MoveToPose | FollowPath) and state.request.controller.method != GUARDED:
        return _by_method(state)
    if state.request.goal is not None and not isinstance(state.request.command, HoldPosition):
        return _towards(state, state.request.goal)
    return Status(Text(en="Ready: drag the target or a slider.", pt_BR="Pronto: arraste o alvo ou um controle."), "ok")


def _replaying(state: State, command: Replay) -> Text:
    """How far a replay is, and what holds it back."""
    if not command.arrived:
        return Text(en="Going to where it begins.", pt_BR="Indo para onde começa.")
    held = holding(state)
    where = Text(en="{title}: {s:.1f} of {end:.1f} s", pt_BR="{title}: {s:.1f} de {end:.1f} s").format(
        title=command.title, s=command.s, end=command.path.duration
    )
    if not held:
        return Text(en="{where}.", pt_BR="{where}.").format(where=where)
    return Text(en="{where}; held by: {what}.", pt_BR="{where}; retido por: {what}.").format(where=where, what=held[0])


def _parking(state: State) -> Status:
    if isinstance(state.request.command, HoldPosition):
        return Status(
            Text(
                en="Parked: planes are off. Ready brings the arm back.",
                pt_BR="Estacionado: planos desligados. Pronto traz o braço de volta.",
            ),
            "warn",
        )
    if not state.arm.parked and state.request.goal is not None and state.request.goal.position_error > SHORT:
        return Status(_held_back(state, state.request.goal), "blocked")
    if isinstance(state.request.command, Park):
        if not state.arm.parked and not state.arm.moving and state.request.unchanged > 1.0:
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
    if state.request.detour is not None:
        return Status(
            Text(
                en="Changing posture: another one comes nearer to the goal.",
                pt_BR="Mudando de postura: outra chega mais perto do objetivo.",
            ),
            "ok",
        )
    if goal.position_error > SHORT:
        return Status(_held_back(state, goal), "blocked")
    if state.request.with_orientation and goal.orientation_error > TURNED:
        return Status(_misaligned(state, goal), "warn")
    if isinstance(state.request.command, FollowPath) and state.request.command.playing:
        return Status(FOLLOWING.format(path=state.request.command.title), "ok")
    if state.arm.moving:
        return Status(MOVING, "ok")
    return Status(AT_THE_GOAL, "ok")


def _by_method(state: State) -> Status:
    """On the way by a method of the sources: whether it applies, and where it comes to rest."""
    if state.request.controller.refusal is not None:
        return Status(state.request.controller.refusal, "blocked")
    way, turn = errors(state)
    if isinstance(state.request.command, FollowPath) and state.request.command.playing and way < ARRIVED:
        return Status(FOLLOWING.format(path=state.request.command.title), "ok")
    if state.arm.moving:
        return Status(MOVING, "ok")
    if way > SHORT:
        return Status(_rests(state, way), "blocked")
    if state.request.with_orientation and turn > TURNED:
        return Status(
            Text(
                en="Position held, orientation {turned:.0f}° off.",
                pt_BR="Posição mantida, orientação a {turned:.0f}°.",
            ).format(turned=np.degrees(turn)),
            "warn",
        )
    return Status(AT_THE_GOAL, "ok")


def _rests(state: State, way: float) -> Text:
    """Where a method has come to rest, with what the guard held it back by, if anything."""
    method = methods.named(state.request.controller.method).TITLE
    held = holding(state)
    if not held:
        return Text(
            en="Rests {way:.0f} mm from the target: the method “{method}” finds no way on.",
            pt_BR="Parou a {way:.0f} mm do alvo: o método “{method}” não acha como seguir.",
        ).format(way=1000 * way, method=method)
    return Text(
        en="Rests {way:.0f} mm from the target, held by: {held}.",
        pt_BR="Parou a {way:.0f} mm do alvo, retido por: {held}.",
    ).format(way=1000 * way, held=held[0])


def _held_back(state: State, goal: Goal) -> Text:
    """Why the wish is not met: the plane and the point it holds, the joint at its limit, or the reach."""
    reason = goal.reasons[0] if goal.reasons else None
    short = f"{1000 * goal.position_error:.0f}"
    match reason:
        case Contact(plane, point):
            pane, guarded = state.problem.planes.panes[plane], state.robot.monitored[point]
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
        case SelfContact() | ObstacleContact():
            return Text(
                en="Blocked: {what} are as near as they may be; {short} mm short.",
                pt_BR="Bloqueado: {what} estão tão perto quanto podem; faltam {short} mm.",
            ).format(what=_named(state.problem, reason), short=short)
        case AtEntryPoint():
            return Text(
                en="Held by the entry point of the instrument; {short} mm short.",
                pt_BR="Retido pelo ponto de entrada do instrumento; faltam {short} mm.",
            ).format(short=short)
        case None | AtSpeed() | AtAcceleration():
            return Text(
                en="Out of reach by {short} mm: nearest point shown.",
                pt_BR="Fora de alcance por {short} mm: o ponto mais próximo é mostrado.",
            ).format(short=short)


def _distance_at(state: State, goal: Goal, contact: Contact) -> float:
    """The distance of a contact's point to its plane at the goal, m."""
    return float(distances_of(state, points_on(state.robot, goal.poses))[contact.point, contact.plane])


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
    ).format(turned=np.degrees(goal.orientation_error), why=why)


def holding(state: State) -> list[Text]:
    """What held the last step back, the hardest first, in a few words each."""
    return [_named(state.problem, reason) for reason in held_by(state)]


def too_near(problem: Problem, q: Array) -> Text | None:
    """What would be nearer than it may be in a posture (n,), rad or m, in a few words; None where nothing would."""
    reason = barrier(problem, q)
    return None if reason is None else _named(problem, reason)


def _named(problem: Problem, reason: Reason) -> Text:
    """A reason in a few words."""
    bodies = [body.title for body in problem.robot.bodies]
    match reason:
        case Contact(plane, point):
            return Text(en="plane {a}: {b}", pt_BR="plano {a}: {b}").format(
                a=problem.planes.panes[plane].name, b=problem.robot.monitored[point].title
            )
        case SelfContact(first, second):
            return Text(en="{a} and {b}", pt_BR="{a} e {b}").format(a=bodies[first], b=bodies[second])
        case ObstacleContact(obstacle, body):
            return Text(en="obstacle {n} and {a}", pt_BR="obstáculo {n} e {a}").format(n=obstacle + 1, a=bodies[body])
        case AtLimit(joint):
            return Text(en="limit of joint {n}", pt_BR="limite da junta {n}").format(n=joint + 1)
        case AtSpeed(joint):
            return Text(en="speed of joint {n}", pt_BR="velocidade da junta {n}").format(n=joint + 1)
        case AtAcceleration(joint):
            return Text(en="acceleration of joint {n}", pt_BR="aceleração da junta {n}").format(n=joint + 1)
        case AtEntryPoint():
            return Text(en="the entry point", pt_BR="o ponto de entrada")
