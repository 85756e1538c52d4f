"""The status line: what the arm does, or why it does not move, in words."""

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
from helicoide.readout.instruments import errors, limited_by, near_singular
from helicoide.state import State, points_on
from helicoide.text import Text, join_texts

Tone = Literal["ok", "warn", "blocked", "stopped"]

SHORT, ARRIVED = 1e-3, 10e-3
TURNED = np.radians(1.0)
FOR_A_POSE = 6  # joints that an arm needs for position and orientation

FOLLOWING = Text(en="Following: {path}.", pt_BR="Seguindo: {path}.")
MOVING = Text(en="Moving.", pt_BR="Em movimento.")
SINGULARITY = Text(en="Singularity: {said}.", pt_BR="Singularidade: {said}.")
AT_THE_GOAL = Text(en="Goal reached.", pt_BR="Objetivo alcançado.")


@dataclass(frozen=True)
class Status:
    """A status text and how serious it is."""

    text: Text
    tone: Tone


def status(state: State) -> Status:
    """The status of a state: its notice if there is one, else what the arm does, with a warning near a singularity."""
    if state.notice is not None:
        return Status(state.notice, "warn")
    said, near = _said(state), near_singular(state)
    if near is None or said.tone == "stopped":
        return said
    return Status(join_texts([said.text, SINGULARITY.format(said=near)], " "), said.tone)


def _said(state: State) -> Status:
    if state.request.command == HoldPosition(stopped=True) and state.arm.parked:
        return Status(
            Text(
                en="Stopped, planes off: only “Ready pose” or “Park” move the arm.",
                pt_BR="Parado, planos desligados: só “Ir à pose inicial” ou “Estacionar” movem o braço.",
            ),
            "stopped",
        )
    if state.request.command == HoldPosition(stopped=True):
        return Status(
            Text(
                en="Stopped. Nothing moves until the next command.",
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
    """The progress of a replay, and the constraint that limits it."""
    if not command.arrived:
        return Text(en="Moving to the start.", pt_BR="Indo ao início.")
    held = limiting(state)
    where = Text(en="{title}: {s:.1f} of {end:.1f} s", pt_BR="{title}: {s:.1f} de {end:.1f} s").format(
        title=command.title, s=command.s, end=command.path.duration
    )
    if not held:
        return Text(en="{where}.", pt_BR="{where}.").format(where=where)
    return Text(en="{where}; limited by: {what}.", pt_BR="{where}; limitado por: {what}.").format(
        where=where, what=held[0]
    )


def _parking(state: State) -> Status:
    if isinstance(state.request.command, HoldPosition):
        return Status(
            Text(
                en="Parked: planes are off. “Ready pose” brings the arm back.",
                pt_BR="Estacionado: planos desligados. “Ir à pose inicial” traz o braço de volta.",
            ),
            "warn",
        )
    if not state.arm.parked and state.request.goal is not None and state.request.goal.position_error > SHORT:
        return Status(_out_of_reach(state, state.request.goal), "blocked")
    if isinstance(state.request.command, Park):
        if not state.arm.parked and not state.arm.moving and state.request.unchanged > 1.0:
            return Status(
                Text(
                    en="Cannot park: a plane is too close to the ready pose. Move it first.",
                    pt_BR="Não dá para estacionar: um plano está perto demais da pose inicial. Mova-o primeiro.",
                ),
                "blocked",
            )
        return Status(Text(en="Moving to the park pose.", pt_BR="Indo estacionar."), "ok")
    return Status(Text(en="Moving to the ready pose.", pt_BR="Indo à pose inicial."), "ok")


def _towards(state: State, goal: Goal) -> Status:
    """The status under the guarded step, on the way to the goal or at it."""
    if state.request.detour is not None:
        return Status(
            Text(
                en="Changing posture: another one gets closer to the goal.",
                pt_BR="Mudando de postura: outra chega mais perto do objetivo.",
            ),
            "ok",
        )
    if goal.position_error > SHORT:
        return Status(_out_of_reach(state, goal), "blocked")
    if state.request.with_orientation and goal.orientation_error > TURNED:
        return Status(_misaligned(state, goal), "warn")
    if isinstance(state.request.command, FollowPath) and state.request.command.playing:
        return Status(FOLLOWING.format(path=state.request.command.title), "ok")
    if state.arm.moving:
        return Status(MOVING, "ok")
    return Status(AT_THE_GOAL, "ok")


def _by_method(state: State) -> Status:
    """The status under another method: why it does not apply, or how far it is from the target."""
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
                en="Position reached, orientation {turned:.0f}° from target.",
                pt_BR="Posição alcançada, orientação a {turned:.0f}° do alvo.",
            ).format(turned=np.degrees(turn)),
            "warn",
        )
    return Status(AT_THE_GOAL, "ok")


def _rests(state: State, way: float) -> Text:
    """That the arm has stopped away from the target, and the constraint that limits it, if any."""
    method = methods.named(state.request.controller.method).TITLE
    held = limiting(state)
    if not held:
        return Text(
            en="Stopped {way:.0f} mm from the target: the method “{method}” cannot get closer.",
            pt_BR="Parado a {way:.0f} mm do alvo: o método “{method}” não consegue avançar.",
        ).format(way=1000 * way, method=method)
    return Text(
        en="Stopped {way:.0f} mm from the target, limited by: {held}.",
        pt_BR="Parado a {way:.0f} mm do alvo, limitado por: {held}.",
    ).format(way=1000 * way, held=held[0])


def _out_of_reach(state: State, goal: Goal) -> Text:
    """Why the target is not reached: a contact, a joint limit, the entry point or the reach."""
    reason = goal.reasons[0] if goal.reasons else None
    short = f"{1000 * goal.position_error:.0f}"
    match reason:
        case Contact(plane, point):
            pane, guarded = state.problem.planes.panes[plane], state.robot.monitored[point]
            return Text(
                en="Blocked by plane {name} ({pane}): {point} at {mm:.0f} mm; {short} mm from the target.",
                pt_BR="Bloqueado pelo plano {name} ({pane}): {point} a {mm:.0f} mm; a {short} mm do alvo.",
            ).format(
                name=pane.name,
                pane=pane.title,
                point=guarded.title,
                mm=1000 * _distance_at(state, goal, reason),
                short=short,
            )
        case AtLimit(joint):
            return Text(
                en="Joint {n} ({title}) at its limit; {short} mm from the target: closest reachable point shown.",
                pt_BR="Junta {n} ({title}) no limite; a {short} mm do alvo: mostrado o ponto alcançável mais próximo.",
            ).format(n=joint + 1, title=state.robot.variables[joint].title, short=short)
        case SelfContact() | ObstacleContact():
            return Text(
                en="Blocked: {what} at their smallest allowed distance; {short} mm from the target.",
                pt_BR="Bloqueado: {what} na menor distância permitida; a {short} mm do alvo.",
            ).format(what=_named(state.problem, reason), short=short)
        case AtEntryPoint():
            return Text(
                en="Limited by the entry point of the instrument; {short} mm from the target.",
                pt_BR="Limitado pelo ponto de entrada do instrumento; a {short} mm do alvo.",
            ).format(short=short)
        case None | AtSpeed() | AtAcceleration():
            return Text(
                en="Out of reach by {short} mm: closest reachable point shown.",
                pt_BR="Fora do alcance por {short} mm: mostrado o ponto alcançável mais próximo.",
            ).format(short=short)


def _distance_at(state: State, goal: Goal, contact: Contact) -> float:
    """The distance from the point of a contact to its plane at the goal, m."""
    return float(distances_of(state, points_on(state.robot, goal.poses))[contact.point, contact.plane])


def _misaligned(state: State, goal: Goal) -> Text:
    """That the position is reached alone, and why."""
    return Text(
        en="Position reached, orientation {turned:.0f}° from target: {why}.",
        pt_BR="Posição alcançada, orientação a {turned:.0f}° do alvo: {why}.",
    ).format(turned=np.degrees(goal.orientation_error), why=_why_misaligned(state, goal))


def _why_misaligned(state: State, goal: Goal) -> Text:
    """Why the orientation is not reached: a joint limit, the entry point, another constraint, or too few joints."""
    limit = next((reason for reason in goal.reasons if isinstance(reason, AtLimit)), None)
    joints = len(state.robot.variables)
    if limit is not None:
        return Text(en="joint {n} is at its limit", pt_BR="a junta {n} está no limite").format(n=limit.joint + 1)
    if state.problem.entry is not None:
        return Text(
            en="the shaft must pass through its entry point", pt_BR="a haste tem de passar pelo ponto de entrada"
        )
    if joints < FOR_A_POSE:
        return Text(
            en="with {n} joints the position fixes the yaw", pt_BR="com {n} juntas a posição determina a guinada"
        ).format(n=joints)
    touching = next((reason for reason in goal.reasons if not isinstance(reason, AtSpeed | AtAcceleration)), None)
    if touching is not None:
        return Text(en="limited by: {what}", pt_BR="limitado por: {what}").format(what=_named(state.problem, touching))
    return Text(en="closest reachable orientation shown", pt_BR="mostrada a orientação alcançável mais próxima")


def limiting(state: State) -> list[Text]:
    """The constraints that limited the last step, each in a few words, in the order of `held_by`."""
    return [_named(state.problem, reason) for reason in limited_by(state)]


def too_near(problem: Problem, q: Array) -> Text | None:
    """The worst violation of a clearance at a posture (n,), rad or m, in a few words; None if there is none."""
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
