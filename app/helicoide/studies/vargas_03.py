"""Sim. 3 of Vargas 2013: six joints pass near a singular posture of the shoulder."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from math import pi

import numpy as np

from helicoide.arrays import Array
from helicoide.kinematics.differential import frame_jacobian
from helicoide.kinematics.singularity import singularity
from helicoide.studies.study import Figure, Interpretation, Progress, Result, Row, printed_statement
from helicoide.studies.vargas.arms import TOOL_DOWN, zebra_wrist
from helicoide.studies.vargas.paths import path_10, path_points, sped_up
from helicoide.studies.vargas.runs import (
    POSE,
    Experiment,
    MethodRun,
    MethodSettings,
    largest_absolute,
    method_settings,
    rotation_about,
    row_norms,
    run_each,
    run_method,
    tracking,
)
from helicoide.studies.vargas.table import (
    DESIRED,
    GainInCm,
    Step,
    condition_chart,
    fastest_chart,
    joint_velocity_chart,
    joints_chart,
    over_time,
    path_chart,
    run_row,
    runs_by_title,
    sentence_statement,
    study_result,
    transient_end,
    with_step,
    zebra_motions,
)
from helicoide.text import Text

TITLE = Text(en="Simulation 3: past the shoulder's singularity", pt_BR="Simulação 3: rente à singularidade do ombro")
SOURCE = "Vargas 2013, §3.3, sim. 3, figs. 3.4–3.5"
ABOUT = Text(
    en="""The wrist passes close to the axis of the waist while the hand keeps its orientation. Look at the wrist's \
joints at that moment: the inverse turns them at 14 rad/s, and at 35 rad/s when the path is run faster. All others \
let the orientation go for a while and find it again; the modified filtered inverse with γ = 10 keeps \
the position best.""",
    pt_BR="""O punho passa rente ao eixo da cintura enquanto a mão mantém a orientação. Observe as juntas do punho \
nesse instante: a inversa as gira a 14 rad/s, e a 35 rad/s quando o caminho é percorrido mais depressa. Todos os \
outros largam a orientação por um momento e a recuperam; a inversa filtrada modificada com γ = 10 é a \
que melhor mantém a posição.""",
)
ROBOT = "zebra_zero"
RATE = 5.0
SINCE = transient_end(RATE / 2)  # the angle of the quaternion's error fades with λ/2
WRIST = Text(en="fastest joint of the wrist from 4 s on", pt_BR="junta mais rápida do punho a partir de 4 s")
OFF = Text(en="largest error of position from 4 s on", pt_BR="maior erro de posição a partir de 4 s")
ASKEW = Text(en="largest error of orientation from 4 s on", pt_BR="maior erro de orientação a partir de 4 s")
PEAK = Text(en="velocity peak of the inverse, {of}", pt_BR="pico de velocidade da inversa, {of}")
AS_PRINTED = Text(en="time as printed in App. C", pt_BR="tempo como impresso no Ap. C")
AT_SPEED = Text(en="2.5 times as fast", pt_BR="2,5 vezes mais rápido")
FIGURES, FAST = "figs. 3.4–3.5", 2.5
NOT_SO_FAST = Text(
    en="with the time of (C.10); 2.5 times as fast, the peak is at 9.4 s",
    pt_BR="com o tempo de (C.10); 2,5 vezes mais rápido, o pico é em 9,4 s",
)
BEGUN = Interpretation(
    Text(en="start (0, π/2, −π, 0, −π/2, 0)", pt_BR="partida (0; π/2; −π; 0; −π/2; 0)"),
    Text(
        en="six random starts give the same slope and the same peaks",
        pt_BR="seis partidas aleatórias dão a mesma inclinação e os mesmos picos",
    ),
)
FAST_ONES = ("inverse", "filtered_1", "modified_1")


@dataclass(frozen=True)
class Options:
    """gain: the smaller γ, 1/(cm² s), beside ten times it; dt, s, half of it at speed."""

    gain: GainInCm = 1.0
    dt: Step = 1e-3

    @property
    def ways(self) -> dict[str, MethodSettings]:
        """The inverse, a damping, and the filtered inverses with γ and ten times it."""
        filtered = {
            f"{kind}_{times}": method_settings(name, f"γ = {times * self.gain:g}", gain=times * self.gain)
            for kind, name in (("filtered", "filtered"), ("modified", "filtered_modified"))
            for times in (1, 10)
        }
        damped = method_settings("damped_by_manipulability", "δ₀ = 0.1", damping=0.1, threshold=1e3)
        return {"inverse": method_settings("inverse"), "damping": damped, **filtered}


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Six methods with λ = 5 on trajectory 10, three of them also at 2.5 times its speed."""
    arm, ways = zebra_wrist(), options.ways
    dt = max(options.dt, 1e-2) if short else options.dt
    usual, fast = (tracking(arm, sped_up(path_10, k), POSE, rotation_about(1, pi / 2)) for k in (1.0, FAST))
    half = max(options.dt, 5e-3) if short else dt / 2
    printed_speed = Experiment(arm, usual, RATE, TOOL_DOWN, dt, 31.5)
    faster_run = Experiment(arm, fast, RATE, TOOL_DOWN, half, 12.6)
    plans = {(key, 1.0): partial(run_method, printed_speed, one) for key, one in ways.items()}
    plans |= {(key, FAST): partial(run_method, faster_run, ways[key]) for key in FAST_ONES}
    runs = run_each(plans, progress)
    slow, at_speed = {key: runs[key, 1.0] for key in ways}, {key: runs[key, FAST] for key in FAST_ONES}
    rows = [
        *_statements(slow["inverse"], at_speed["inverse"], dt),
        *_kinds(slow["inverse"]),
        *_recovered(slow),
    ]
    judged = [key for key in ways if not (short and key == "inverse")]  # whose peaks a long step misses
    for key in judged:
        rows += _passage(ways[key].title, slow[key], Figure(FIGURES) if key == "inverse" else None)
    for key in (key for key in judged if key in at_speed):
        of = Text(en="{of}, {speed}", pt_BR="{of}, {speed}").format(of=ways[key].title, speed=AT_SPEED)
        rows.append(
            run_row(
                WRIST, of, largest_absolute(at_speed[key].joint_velocities[:, 3:], at_speed[key].t >= SINCE), "rad/s"
            )
        )
    names = runs_by_title(ways, slow)
    desired = path_points(path_10, slow["inverse"].t)
    inverted, title = slow["inverse"], ways["inverse"].title
    charts = (
        over_time(OFF_PATH, "‖e_p‖, cm", names, lambda run: row_norms(run.e[:, :3]), FIGURES, log=True),
        over_time(TURNED, "ϑ, °", names, orientation_error_angles, FIGURES),
        condition_chart({title: inverted}, FIGURES),
        joint_velocity_chart(inverted, title, FIGURES),
        joints_chart(inverted, title, FIGURES),
        fastest_chart(names),
        path_chart(
            {DESIRED: desired[:, :2], **{name: (desired - one.e[:, :3])[:, :2] for name, one in names.items()}},
            "x, cm",
            "y, cm",
        ),
    )
    return study_result(rows, charts, zebra_motions(names))


OFF_PATH = Text(en="error of position", pt_BR="erro de posição")
TURNED = Text(en="error of orientation", pt_BR="erro de orientação")


def orientation_error_angles(run: MethodRun) -> Array:
    """The angle of the error of orientation, (k,), degrees: e is sin(ϑ/2) times its axis."""
    return np.asarray(np.degrees(2 * np.arcsin(np.minimum(1, row_norms(run.e[:, 3:])))))


def position_error_slope(run: MethodRun) -> float:
    """d ln‖e_p‖/dt between 0.1 and 1 s, 1/s."""
    between = (run.t > 0.1) & (run.t < 1)
    return float(np.polyfit(run.t[between], np.log(row_norms(run.e[between, :3])), 1)[0])


def peak_time(run: MethodRun) -> float:
    """The time, s, of the largest wrist velocity after the transient."""
    later = run.t >= SINCE
    return float(run.t[later][np.abs(run.joint_velocities[later, 3:]).max(axis=1).argmax()])


def _statements(usual: MethodRun, fast: MethodRun, dt: float) -> list[Row]:
    """The decay, and the instant of the peak with the trajectory as printed and faster."""
    decay = with_step(Text(en="slope of ln‖e_p‖, inverse", pt_BR="inclinação de ln‖e_p‖, inversa"), dt)
    law = sentence_statement(
        "exponential decay, Λ = 5I: −5", "decaimento exponencial, Λ = 5I: −5", "sim. 3", -5.0, within=0.15
    )
    said = printed_statement("≈ 9", f"sim. 3, {FIGURES}")
    return [
        run_row(decay, None, position_error_slope(usual), "1/s", law, fitted=(BEGUN,)),
        run_row(PEAK.format(of=AS_PRINTED), None, peak_time(usual), "s", said, erratum="vargas-1", why=NOT_SO_FAST),
        run_row(PEAK.format(of=AT_SPEED), None, peak_time(fast), "s"),
    ]


def _kinds(run: MethodRun) -> list[Row]:
    """What is singular at the peak of the inverse, in words, and that its factors are the determinant."""
    robot, q = zebra_wrist().robot, run.q[np.abs(run.t - peak_time(run)).argmin()]
    here = singularity(robot, q)
    product = float(np.prod([factor.value for factor in here.factors]))
    splits = sentence_statement("det J_G = det J₁₁ det J₂₂", "det J_G = det J₁₁ det J₂₂", "eq. 3.9", 1.0, "=", 1e-6)
    ratio = Text(en="product of the factors over det J_G", pt_BR="produto dos fatores sobre det J_G")
    near = Text(
        en="factor of det J_G at the peak, of its largest (0 would be {kind})",
        pt_BR="fator de det J_G no pico, em relação ao máximo (0 seria {kind})",
    )
    return [
        run_row(ratio, None, abs(product / float(np.linalg.det(frame_jacobian(robot, q)))), "", splits),
        *(run_row(near.format(kind=one.kind.value), None, 100 * abs(one.relative), "%") for one in here.factors),
    ]


def _passage(of: Text, run: MethodRun, shown: Figure | None) -> list[Row]:
    """The wrist's velocities and both errors; shown: where the source shows them."""
    later = run.t >= SINCE
    return [
        run_row(WRIST, of, largest_absolute(run.joint_velocities[:, 3:], later), "rad/s", shown),
        run_row(OFF, of, largest_absolute(row_norms(run.e[:, :3]), later), "cm", shown),
        run_row(ASKEW, of, largest_absolute(orientation_error_angles(run), later), "°", shown),
    ]


def _recovered(runs: dict[str, MethodRun]) -> list[Row]:
    """The remaining errors of all methods after 29 s."""
    late = runs["inverse"].t > 29
    position = Text(en="error of position after 29 s, at most", pt_BR="erro de posição após 29 s, no máximo")
    orientation = Text(en="error of orientation after 29 s, at most", pt_BR="erro de orientação após 29 s, no máximo")
    return [
        run_row(position, None, max(largest_absolute(row_norms(run.e[:, :3]), late) for run in runs.values()), "cm"),
        run_row(
            orientation, None, max(largest_absolute(orientation_error_angles(run), late) for run in runs.values()), "°"
        ),
    ]
