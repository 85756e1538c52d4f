"""Remote centre: a rod through an entry point, the lever of wrist and tip, what the constraint costs, a moving body."""

from __future__ import annotations

from math import radians

from helicoide import gate
from helicoide.lesson import Choice, Diagnosis, Estimate, Shown, Step, Value, fixed
from helicoide.lines import GivenName, LineExercise
from helicoide.text import Text

from .goals import (
    BESIDE,
    BODY_MOVES,
    ELBOW,
    JOINTS,
    MOVED,
    SPIN,
    SPUN,
    SWING,
    TIP_MOVES,
    TURNED,
    as_long_inside,
    at_ready,
    entry_along,
    entry_at,
    hand_for_body,
    hand_for_tip,
    hand_moved,
    inside,
    missed,
    no_entry,
    not_asked,
    only_swung,
    orientation_gives_way,
    outside,
    pulled_out,
    ratio,
    rod_beside,
    rod_followed,
    spun,
    start,
    stuck,
    tip_along,
    tip_missing,
    tip_moved,
    tip_sideways,
    tip_target,
    turned,
)

TITLE = Text(en="Remote centre", pt_BR="Centro remoto")
ABOUT = Text(
    en="A rod through a small hole: wrist and tip move opposite ways, two rows hold the rod, and they cost two joints.",
    pt_BR="Uma haste por um furo pequeno: o punho e a ponta vão em sentidos opostos, duas linhas da tarefa "
    "seguram a haste e custam duas juntas.",
)
ROBOT = "dia10_rod"
NEEDS = ("differential",)
SOURCES = ("Coutinho 2015: §1.2.2 (fulcrum), §1.4 and §5.1 (n − r ≥ 6), eqs. 3.1, 3.26, 3.30",)

RESIDUE = LineExercise(
    "error",
    (
        GivenName("w", "point", Text(en="the wrist, a point of the rod's axis", pt_BR="o punho, um ponto do eixo")),
        GivenName("t", "point", Text(en="the tip of the rod", pt_BR="a ponta da haste")),
        GivenName("r", "point", Text(en="the entry point", pt_BR="o ponto de entrada")),
    ),
    "distance(r, L)",
    steps=(("L", "line(w, t)"),),
    sign_counts=False,
    title=Text(
        en="how far the axis of the rod passes from the hole", pt_BR="a que distância do furo passa o eixo da haste"
    ),
)
VALUES = {
    "moved": fixed(MOVED, "mm"),
    "outside": Value(lambda state, _: outside(state), "mm"),
    "inside": Value(lambda state, _: inside(state), "mm"),
    "ratio": Value(lambda state, _: ratio(state), "", 2),
    "outside_first": Value(lambda state, _: outside(at_ready(state)), "mm"),
    "inside_first": Value(lambda state, _: inside(at_ready(state)), "mm"),
    "whole": Value(lambda state, _: outside(state) + inside(state), "mm"),
    "ratio_first": Value(lambda state, _: ratio(at_ready(state)), "", 1),
    "tip_moves": fixed(TIP_MOVES, "mm"),
    "hand_for_tip": Value(hand_for_tip, "mm"),
    "body_moves": fixed(BODY_MOVES, "mm"),
    "hand_for_body": Value(hand_for_body, "mm"),
    "hand_moved": Value(lambda state, _: hand_moved(state), "mm"),
    "tip_side": Value(lambda state, _: tip_moved(state)[1], "mm"),
    "missed": Value(lambda state, _: missed(state), "mm", 1),
    "beside": fixed(BESIDE, "mm"),
    "tip_missing": Value(lambda state, _: tip_missing(state), "mm", 1),
    "turned": Value(lambda state, _: turned(state), "°"),
    "least_turn": fixed(TURNED, "°"),
    "joints": fixed(JOINTS, "", 0),
    "spun": fixed(SPUN, "°"),
    "spin": Value(lambda state, _: state.arm.q[SPIN], "°"),
}

UNHELD = Diagnosis("unheld", no_entry, ((gate.enforce_entry(False), 1.5),))
STEPS = (
    Step(
        "pivot",
        start,
        tip_sideways,
        ((tip_target(0.06, 0.0), 3.0),),
        prediction=Choice(right=1, reveal="done"),
        diagnoses=(UNHELD, Diagnosis("along", tip_along, ((tip_target(0.0, -0.06), 3.0),))),
        shown=Shown(camera="front"),
    ),
    Step(
        "lever",
        start,
        as_long_inside,
        ((tip_target(0.0, 0.105), 3.0),),
        prediction=Estimate(hand_for_tip, "mm", within=1.0),
        diagnoses=(
            Diagnosis("pulled_out", pulled_out, ((tip_target(0.0, -0.06), 3.0),)),
            Diagnosis("swung", only_swung, ((tip_target(0.06, 0.0), 3.0),)),
        ),
        shown=Shown(layers=("shaft",), camera="front"),
    ),
    Step("residue", start, line=RESIDUE, shown=Shown(layers=("shaft",), camera="front")),
    Step(
        "who_holds",
        start,
        rod_beside,
        ((entry_at(0.03, 0.0), 1.5),),
        held_for=0.5,
        prediction=Choice(right=1, reveal="done"),
        diagnoses=(
            Diagnosis("followed", rod_followed, ((tip_target(0.0, 0.0), 1.0), (entry_at(0.03, 0.0), 3.0))),
            Diagnosis("slid", entry_along, ((entry_at(0.0, 0.05), 1.5),)),
        ),
        shown=Shown(layers=("shaft",), camera="front"),
    ),
    Step(
        "breathing",
        start,
        rod_followed,
        ((tip_target(0.0, 0.0), 1.0), (entry_at(0.03, 0.0), 3.0)),
        held_for=0.5,
        prediction=Estimate(hand_for_body, "mm", within=1.0),
        diagnoses=(
            Diagnosis("resting", rod_beside, ((entry_at(0.03, 0.0), 1.5),)),
            Diagnosis("slid", entry_along, ((tip_target(0.0, 0.0), 1.0), (entry_at(0.0, 0.05), 2.0))),
        ),
        shown=Shown(layers=("shaft",), camera="front"),
        charts=("entry distance",),
    ),
    Step(
        "cost",
        start,
        orientation_gives_way,
        ((gate.keep_orientation(True), 0.5), (tip_target(0.06, 0.0), 4.0)),
        prediction=Choice(right=2, reveal="done"),
        diagnoses=(
            UNHELD,
            Diagnosis("not_asked", not_asked, ((tip_target(0.06, 0.0), 3.0),)),
            Diagnosis("along", tip_along, ((gate.keep_orientation(True), 0.5), (tip_target(0.0, 0.06), 3.0))),
        ),
        shown=Shown(layers=("shaft",), camera="front", tab="robot"),
    ),
    Step(
        "alone",
        start,
        spun,
        ((gate.set_joint(SPIN, radians(60.0)), 3.0),),
        joints=(SWING, ELBOW, SPIN),
        prediction=Choice(right=2, reveal="done"),
        diagnoses=(Diagnosis("stuck", stuck, ((gate.set_joint(SWING, radians(40.0)), 2.5),)),),
        shown=Shown(layers=("shaft", "axes"), camera="front"),
    ),
    Step(
        "explore",
        start,
        is_open=True,
        joints=(SPIN,),
        shown=Shown(layers=("shaft",), camera="front"),
        charts=("entry distance", "shaft outside"),
    ),
)
