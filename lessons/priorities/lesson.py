"""Priorities: what gives way when not everything can be had, by weights, by priorities, and before an obstacle."""

from __future__ import annotations

import numpy as np

from helicoide import gate
from helicoide.lesson import Choice, Diagnosis, Order, Shown, Step, Value, fixed
from helicoide.lines import GivenName, LineExercise
from helicoide.text import Text

from .goals import (
    BALL,
    EVEN,
    FAR,
    HEAVY,
    LEAST,
    LIGHT,
    SWUNG,
    all_are_light,
    at_the_ball,
    away_from_ball,
    clearance,
    free_joints_swung,
    missing,
    no_target,
    orientation_is_light,
    place_is_light,
    place_kept,
    row_pushes,
    start,
    start_beside_ball,
    start_weighed,
    start_with_objective,
    still_last,
    swung,
    target_at,
    target_here,
    turn_is_free,
    turn_not_asked,
    turned,
    vanishing,
    weight,
    weight_in_vain,
    within_reach,
)

TITLE = Text(en="Weights and priorities", pt_BR="Pesos e prioridades")
ABOUT = Text(
    en="When an arm cannot have everything: what a weight trades, what a priority forbids, what stops at a sphere.",
    pt_BR="Quando o braço não pode ter tudo: o que um peso troca, o que a prioridade proíbe, o que para na esfera.",
)
ROBOT = "zebra_zero"
NEEDS = ("redundancy",)
SOURCES = (
    "Vargas 2013: eqs. 2.50, 2.51, 4.67, §4.6 (gains), 4.69–4.74 (rows, obstacle)",
    "Cerbaro 2022: eqs. 9, 10, 13",
)

BALANCE = LineExercise(
    "error",
    (
        GivenName("a", "number", Text(en="what the first one asks for", pt_BR="o que o primeiro pede")),
        GivenName("b", "number", Text(en="what the second one asks for", pt_BR="o que o segundo pede")),
        GivenName("w1", "length", Text(en="the first weight", pt_BR="o primeiro peso")),
        GivenName("w2", "length", Text(en="the second weight", pt_BR="o segundo peso")),
    ),
    "a - x",
    steps=(("x", "(w1*a + w2*b)/(w1 + w2)"),),
    title=Text(en="where two pulls cancel, and what is missing", pt_BR="onde dois puxões se anulam, e o que falta"),
)
VALUES = {
    "far": fixed(FAR[0], "mm"),
    "missing": Value(lambda state, _: missing(state), "mm", 1),
    "turned": Value(lambda state, _: turned(state), "°", 1),
    "even": fixed(EVEN, "", 0),
    "light": fixed(LIGHT, "", 0),
    "least": fixed(LEAST, "", 1),
    "gain_place": Value(lambda state, _: state.request.controller.gains[0], "", 1),
    "gain_turn": Value(lambda state, _: state.request.controller.gains[3], "", 1),
    "clearance": Value(lambda state, _: clearance(state), "mm"),
    "kept": Value(lambda state, _: state.problem.zones.body_clearance, "mm"),
    "swung": Value(lambda state, _: swung(state), "°"),
    "least_swing": fixed(SWUNG, "°"),
    "heavy": fixed(HEAVY, "", 0),
    "weight": Value(lambda state, _: weight(state), "", 0),
    "vanish": Value(lambda state, _: vanishing(state), "mm"),
    "ball": fixed(np.array(BALL), "mm"),
}

STEPS = (
    Step(
        "out_of_reach",
        start,
        place_kept,
        ((target_at(*FAR), 6.0),),
        prediction=Choice(right=1, reveal="done"),
        diagnoses=(
            Diagnosis("not_asked", turn_not_asked, ((gate.keep_orientation(False), 1.5),)),
            Diagnosis("in_reach", within_reach, ((target_at(0.46, 0.0, 0.1885), 4.0),)),
        ),
        shown=Shown(camera="side", tab="robot"),
    ),
    Step(
        "weights",
        start_weighed,
        orientation_is_light,
        ((gate.set_gain(3, LEAST), 0.5), (target_at(*FAR), 8.0)),
        prediction=Choice(right=0, reveal="done"),
        diagnoses=(
            Diagnosis("wrong_one", place_is_light, ((gate.set_gain(3, 20.0), 0.5), (target_at(*FAR), 8.0))),
            Diagnosis(
                "all_of_them",
                all_are_light,
                (*((gate.set_gain(index, 2.0), 0.1) for index in range(4)), (target_at(*FAR), 12.0)),
            ),
        ),
        shown=Shown(camera="side", tab="method"),
        charts=("position error", "orientation error"),
    ),
    Step("balance", start, line=BALANCE),
    Step(
        "null_space",
        start_with_objective,
        free_joints_swung,
        ((target_here, 6.0),),
        prediction=Choice(right=2, reveal="done"),
        shown=Shown(camera="top", tab="robot"),
    ),
    Step(
        "heavier",
        start_with_objective,
        weight_in_vain,
        ((gate.keep_orientation(True), 0.5), (target_here, 1.0), (gate.weigh_objective(500.0), 2.0)),
        prediction=Choice(right=2, reveal="done"),
        diagnoses=(
            Diagnosis("free", turn_is_free, ((gate.weigh_objective(500.0), 0.5), (target_here, 6.0))),
            Diagnosis("no_target", no_target, ((gate.keep_orientation(True), 0.5), (gate.weigh_objective(500.0), 2.0))),
        ),
        shown=Shown(camera="top", tab="method"),
    ),
    Step(
        "row",
        start_with_objective,
        row_pushes,
        ((target_here, 6.0), (gate.objective_as_row(True), 6.0)),
        prediction=Choice(right=1, reveal="done"),
        diagnoses=(Diagnosis("last", still_last, ((target_here, 7.0),)),),
        shown=Shown(camera="top", tab="method"),
        charts=("position error",),
    ),
    Step(
        "ball",
        start_with_objective,
        at_the_ball,
        ((gate.keep_orientation(True), 0.3), (target_at(*BALL), 5.0)),
        held_for=0.5,
        prediction=Order(right=(2, 1, 0, 3), reveal="done"),
        diagnoses=(Diagnosis("away", away_from_ball, ((target_at(0.40, -0.15, 0.25), 5.0),)),),
        shown=Shown(camera="top", tab="robot"),
    ),
    Step(
        "explore",
        start_beside_ball,
        is_open=True,
        joints=(0, 3),
        shown=Shown(camera="top", tab="method"),
        charts=("position error",),
    ),
)
