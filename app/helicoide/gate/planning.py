"""A planned motion: show it, execute it, discard it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from helicoide.command import Replay
from helicoide.gate.check import driven
from helicoide.state import Plan, State, Update, with_command
from helicoide.text import HelicoideError, Text
from helicoide.trajectory.spline import JointSpline

# How far the arm may be from the start of its plan, rad or m.
AT_START = 2e-3
EXECUTING = Text(en="Executing the plan: {title}", pt_BR="Executando o plano: {title}")
NO_PLAN = Text(en="There is no planned motion: plan one first.", pt_BR="Não há movimento planejado: planeje um antes.")
ELSEWHERE = Text(
    en="The arm is no longer where the plan begins: plan again.",
    pt_BR="O braço não está mais onde o plano começa: planeje de novo.",
)
OUTDATED = Text(
    en="Planes, obstacles or limits have changed since the motion was planned: plan again.",
    pt_BR="Planos, obstáculos ou limites mudaram desde o planejamento: planeje de novo.",
)


def plan_found(plan: Plan) -> Update:
    """Show a planned motion; nothing moves."""
    return lambda state: replace(state, plan=plan, notice=None)


def clear_plan() -> Update:
    """Discard the planned motion."""
    return lambda state: replace(state, plan=None)


def execute_plan() -> Update:
    """Follow the planned motion under all limits, if the arm is at its start and nothing around it has changed."""

    def change(state: State) -> State:
        plan = state.plan
        if plan is None:
            raise HelicoideError(NO_PLAN)
        if plan.problem is not state.problem:
            raise HelicoideError(OUTDATED)
        if np.abs(state.arm.q - plan.q[0]).max() > AT_START:
            raise HelicoideError(ELSEWHERE)
        path = JointSpline(plan.times, plan.q)
        return with_command(replace(state, plan=None), Replay(path, EXECUTING.format(title=plan.title)))

    return driven(change)
