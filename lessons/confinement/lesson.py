"""Confinement: planes around an arm, the distances that it keeps, why it stopped, and how a camera measures a room."""

from __future__ import annotations

from math import degrees, radians

from helicoide import gate
from helicoide.lesson import Choice, Diagnosis, Estimate, Shown, Step
from helicoide.perception.enclosure_reading import PLANE_READINGS
from helicoide.text import Text

from .goals import (
    another_distance,
    at_one_plane,
    at_right_wall,
    at_wall_as_before,
    at_wider_wall,
    ceiling_lowered,
    ceiling_on_its_way,
    ceiling_raised,
    ceiling_stopped,
    dragged_to,
    elbow_stopped,
    elbow_warned,
    in_the_corner,
    is_parked,
    measured_in_part,
    measuring,
    no_shield,
    read_from_the_file,
    room_measured,
    shield_holds,
    shoulder_at_stop,
    shoulder_lowered,
    start,
    start_in_a_box,
    stopped_by_elbow,
    target_at,
    target_beyond,
    target_let_go,
    target_reached,
    tool_nearest,
    tool_raised,
)
from .values import (
    ASKED,
    BACK,
    CORNER_WITHIN,
    CORRIDOR_WITHIN,
    ELBOW,
    LEAN_WITHIN,
    SHOULDER,
    WAIST,
    WIDER,
    ZONES_WITHIN,
    corridor,
    left_wall_lean,
    to_the_edge,
)
from .values import VALUES as VALUES

TITLE = Text(en="Confinement", pt_BR="Confinamento")
ABOUT = Text(
    en="An arm among planes: which point is stopped, by what and how far away, and how a camera measures the room.",
    pt_BR="Um braço entre planos: que ponto é detido, por qual plano, a que distância, e como uma câmera mede a sala.",
)
ROBOT = "movemaster"
NEEDS = ("drive_the_arm",)
SOURCES = ("Cerbaro 2022: §5.2, eqs. 18, 20, 25–26; §6.1–6.2, eqs. 36–37 and fig. 43",)

STEPS = (
    Step(
        "nearest",
        start,
        tool_nearest,
        ((target_at(0.60, 0.0, 0.11), 3.0),),
        prediction=Choice(right=1),
        diagnoses=(Diagnosis("raised", tool_raised, ((target_at(0.60, 0.0, 0.25), 3.0),)),),
        shown=Shown(hidden=("distances",), camera="first"),
    ),
    Step(
        "zones",
        start,
        elbow_stopped,
        ((gate.set_joint(SHOULDER, ASKED), 3.0),),
        joints=(SHOULDER,),
        prediction=Estimate(lambda state, _: shoulder_at_stop(state), "°", within=degrees(ZONES_WITHIN), reveal="done"),
        diagnoses=(
            Diagnosis("warned", elbow_warned, ((gate.set_joint(SHOULDER, radians(37.0)), 3.0),)),
            Diagnosis("lowered", shoulder_lowered, ((gate.set_joint(SHOULDER, radians(10.0)), 3.0),)),
        ),
        shown=Shown(layers=("distances",), camera="side"),
    ),
    Step(
        "elbow",
        start,
        stopped_by_elbow,
        ((target_at(*BACK), 4.0),),
        held_for=0.5,
        prediction=Choice(right=1, reveal="done"),
        diagnoses=(
            Diagnosis("beyond", target_beyond, ((target_at(0.60, 0.0, 0.70), 5.0),)),
            Diagnosis("let_go", target_let_go, ((dragged_to(*BACK), 6.0),)),
            Diagnosis("reached", target_reached, ((target_at(0.60, 0.0, 0.13), 4.0),)),
        ),
        shown=Shown(layers=("distances",), camera="side"),
    ),
    Step(
        "corner",
        start,
        in_the_corner,
        ((target_at(0.60, 0.50, -0.20), 6.0),),
        prediction=Estimate(lambda state, _: to_the_edge(state), "mm", within=1e3 * CORNER_WITHIN, reveal="done"),
        diagnoses=(
            Diagnosis("right", at_right_wall, ((target_at(0.60, -0.50, 0.15), 5.0),)),
            Diagnosis("one", at_one_plane, ((target_at(0.60, 0.50, 0.20), 5.0),)),
        ),
        shown=Shown(layers=("distances",), camera="first"),
    ),
    Step(
        "moving_plane",
        start,
        ceiling_stopped,
        ((ceiling_lowered(0.10), 1.0),),
        prediction=Choice(right=2, reveal="done"),
        diagnoses=(
            Diagnosis("further", ceiling_on_its_way, ((ceiling_lowered(0.02), 1.0),)),
            Diagnosis("raised", ceiling_raised, ((ceiling_lowered(-0.05), 1.0),)),
        ),
        shown=Shown(layers=("distances",), camera="side"),
    ),
    Step(
        "corridor",
        start,
        at_wider_wall,
        ((gate.set_zones(WIDER, WIDER + 0.03), 0.5), (target_at(0.60, 0.50, 0.17), 5.0)),
        prediction=Estimate(lambda state, _: corridor(state), "mm", within=1e3 * CORRIDOR_WITHIN),
        diagnoses=(
            Diagnosis("as_before", at_wall_as_before, ((target_at(0.60, 0.50, 0.17), 5.0),)),
            Diagnosis("another", another_distance, ((gate.set_zones(0.10, 0.13), 0.5),)),
        ),
        shown=Shown(layers=("distances",), camera="top", tab="robot"),
    ),
    Step(
        "measuring",
        start_in_a_box,
        room_measured,
        measuring(len(PLANE_READINGS)),
        prediction=Estimate(lambda state, _: left_wall_lean(state), "°", within=degrees(LEAN_WITHIN), reveal="done"),
        diagnoses=(
            Diagnosis("from_file", read_from_the_file, ((gate.restore_planes(), 0.5),)),
            Diagnosis("in_part", measured_in_part, measuring(1)),
        ),
        shown=Shown(camera="first", tab="robot"),
    ),
    Step(
        "parked",
        start,
        is_parked,
        ((gate.park(), 8.0),),
        prediction=Choice(right=1, reveal="done"),
        diagnoses=(Diagnosis("held", elbow_stopped, ((gate.set_joint(SHOULDER, radians(100.0)), 4.0),)),),
        shown=Shown(camera="side", tab="robot"),
    ),
    Step(
        "shield",
        start,
        shield_holds,
        ((gate.add_plane([-1.0, 0.0, 0.0, -0.70]), 0.5), (gate.go_to("zero"), 5.0)),
        diagnoses=(Diagnosis("elsewhere", no_shield, ((gate.add_plane([0.0, 1.0, 0.0, -0.20]), 0.5),)),),
        shown=Shown(layers=("distances",), camera="first", tab="robot"),
        is_open=True,
    ),
    Step(
        "explore",
        start,
        is_open=True,
        joints=(WAIST, SHOULDER, ELBOW, 3, 4),
        charts=("planes",),
        shown=Shown(layers=("distances",)),
    ),
)
