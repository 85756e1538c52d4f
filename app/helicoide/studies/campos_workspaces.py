"""Where a planar arm reaches: the annulus of two links and the ring of the polar arm, counted and in closed form."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Annotated

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.ik import closed
from helicoide.ik.closed import planar2r
from helicoide.ik.postures.branch import tool_at
from helicoide.ik.postures.workspace import reachable
from helicoide.kinematics import workspace
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.workspace import WorkspaceMap
from helicoide.studies._campos_arms import planar_pose, planar_with_lengths, with_joint_limits
from helicoide.studies._campos_rows import (
    LENGTH_1,
    LENGTH_2,
    campos_result,
    length_settings,
    posture_motion,
    slide_statement,
)
from helicoide.studies.study import Chart, ChartLine, Progress, Result, Row, printed_statement
from helicoide.text import Text, untranslated

TITLE = Text(en="Workspaces in a plane", pt_BR="Espaços de trabalho no plano")
SOURCE = "Campos 1998, s.6–13, s.31–34, s.53"
ABOUT = Text(
    en="Two links reach an annulus, every point inside with two orientations and every point on an edge with one. "
    "Random postures find the same area as the formula, and limiting the elbow to one side changes the count, not "
    "the area.",
    pt_BR="Dois elos alcançam um anel: cada ponto interno com duas orientações, cada ponto da borda com uma. Posturas "
    "aleatórias encontram a mesma área da fórmula, e limitar o cotovelo a um lado muda a contagem, não a área.",
)
ROBOT = "planar2r"

SAMPLES, FEW = 4_000_000, 300_000
# Parts by which counted areas may be apart; measured are 0.2 % and 1.2 % of the formula at most.
CLOSE, COARSE = 0.006, 0.02
# How far off an edge points are counted, and beside the first axis, m; a tool that is longer, m; random postures.
ASIDE, BESIDE, LONGER, TRIED = 1e-6, 1e-3, 0.1, 5000


@dataclass(frozen=True)
class Options:
    """The lengths of the two links, m."""

    l1: Annotated[float, LENGTH_1] = 1.0
    l2: Annotated[float, LENGTH_2] = 0.7


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Areas by random postures, and counts at the edges; short: fewer postures."""
    l1, l2 = options.l1, options.l2
    robot, polar, equal = planar_with_lengths(ROBOT, l1, l2), load_robot("polar_rp"), planar_with_lengths(ROBOT, l1, l1)
    half = with_joint_limits(robot, [0.0, 0.0], [2 * np.pi, np.pi])
    samples, near = (FEW, COARSE) if short else (SAMPLES, CLOSE)
    whole, one_sided, ring = (_map(arm, samples, done, progress) for done, arm in enumerate((robot, half, polar)))
    inner, outer = reachable(np.array([l1, l2]))
    r, r_longer, r_equal = (tool_radii(arm) for arm in (robot, with_longer_tool(robot, LONGER), equal))
    area = np.pi * (outer**2 - inner**2)
    rows = [
        *_counts(robot, half, inner, outer),
        Row(SAME_SET, one_sided.measure / whole.measure, "", slide_statement(*SAME_WORDS, "s.12", 1, "=", near)),
        Row(NEAREST, r.min(), "m", slide_statement("r ≥ |L₁ − L₂|", "r ≥ |L₁ − L₂|", "s.10", inner, "≥", 1e-12)),
        Row(FARTHEST, r.max(), "m", slide_statement("r ≤ L₁ + L₂", "r ≤ L₁ + L₂", "s.10, s.53", outer, "≤", 1e-12)),
        Row(DISC, r_equal.max() / l1, "L₁", slide_statement(*DISC_WORDS, "s.8", 2, "=", 1e-3)),
        Row(NO_HOLE, _count(equal, BESIDE), "", slide_statement(*DISC_WORDS, "s.8", 0, ">")),
        Row(TOOL, r_longer.max() - r.max(), "m", slide_statement(*TOOL_WORDS, "s.13", 0, ">")),
        Row(AREA.format(which=TWO), whole.measure, "m²"),
        Row(BY_FORMULA.format(which=TWO), area, "m²"),
        Row(AREA.format(which=POLAR), ring.measure, "m²"),
        Row(BY_FORMULA.format(which=POLAR), np.pi * (polar.upper[1] ** 2 - polar.lower[1] ** 2), "m²"),
    ]
    charts = [_edges(inner, outer), _radial(whole)]
    motion = posture_motion(ROBOT, [np.zeros(2), np.array([0.0, np.pi])], length_settings(l1=l1, l2=l2), STRETCHED)
    return campos_result(rows, charts, [motion])


def tool_radii(robot: Robot) -> Array:
    """The distance of the tool from the first axis, (k,), m, in random postures and the four straight ones."""
    q = np.random.default_rng(6).uniform(-np.pi, np.pi, (TRIED, 2))
    q[:2, 1] = 0, np.pi
    return np.array([np.hypot(*tool_at(robot, row)[:2, 3]) for row in q])


def with_longer_tool(robot: Robot, longer: float) -> Robot:
    """The arm with a tool that is longer by a length, m."""
    T = robot.T_world_tool_0.copy()
    T[0, 3] += longer
    return replace(robot, T_world_tool_0=frozen(T))


def _map(robot: Robot, samples: int, done: int, progress: Progress) -> WorkspaceMap:
    plan = workspace.plan_map(robot, "reachable", samples)
    return workspace.collect_map(plan, workspace.count_chunks(plan), lambda share: progress((done + share) / 3))


def _count(arm: Robot, r: float) -> int:
    """The number of postures within the limits for a point at the distance r, m."""
    return sum(
        branch.within for branch in closed.solve_closed_form(planar2r, arm, planar_pose(r, 0.0), np.zeros(2)).branches
    )


def _counts(robot: Robot, half: Robot, inner: float, outer: float) -> list[Row]:
    """The number of postures for points near the edges, on them and between."""
    middle = 0.5 * (inner + outer)
    annulus = slide_statement("|L₁ − L₂| ≤ r ≤ L₁ + L₂", "|L₁ − L₂| ≤ r ≤ L₁ + L₂", "s.10", 0)
    return [
        Row(INSIDE, _count(robot, middle), "", printed_statement("2", "s.10")),
        Row(OUTER, _count(robot, outer), "", printed_statement("1", "s.10")),
        Row(INNER, _count(robot, inner), "", printed_statement("1", "s.10")),
        Row(OUTSIDE, _count(robot, outer + ASIDE), "", annulus),
        *([Row(HOLE, _count(robot, inner - ASIDE), "", annulus)] if inner > ASIDE else []),
        Row(ONE_SIDE, _count(half, middle), "", printed_statement("1", "s.12")),
    ]


def _edges(inner: float, outer: float) -> Chart:
    """The two circles, m."""
    turn = np.linspace(0, 2 * np.pi, 121)
    lines = tuple(
        ChartLine(name, r * np.cos(turn), r * np.sin(turn)) for name, r in ((EDGE_OUT, outer), (EDGE_IN, inner))
    )
    return Chart(EDGES, untranslated("x, m"), untranslated("y, m"), lines)


def _radial(found: WorkspaceMap) -> Chart:
    """How many postures there are for each area, by the distance from the first axis."""
    r = np.hypot(*found.cells.centres[:, :2].T)
    edges = np.linspace(0, r[found.reached].max(), 60)
    inside = np.histogram(r, edges)[0]
    hits = np.histogram(r, edges, weights=found.hits)[0]
    return Chart(
        Text(en="Random postures by distance", pt_BR="Posturas aleatórias por distância"),
        untranslated("r, m"),
        Text(en="share of postures per m²", pt_BR="fração das posturas por m²"),
        (
            ChartLine(
                TWO, 0.5 * (edges[1:] + edges[:-1]), hits / np.maximum(inside, 1) / found.samples / found.cells.size**2
            ),
        ),
    )


SAME_WORDS = ("θ₂ from 0 to 180°: the same reachable set", "θ₂ de 0 a 180°: o mesmo conjunto alcançável")
DISC_WORDS = ("L₁ = L₂: a disc of radius 2 L₁", "L₁ = L₂: um disco de raio 2 L₁")
TOOL_WORDS = ("the workspace depends on the tool", "o espaço de trabalho depende da ferramenta")
SAME_SET = Text(
    en="area with the elbow to one side only, over the whole one",
    pt_BR="área com o cotovelo só de um lado, sobre a total",
)
NEAREST = Text(
    en="smallest distance of the end effector from the first axis",
    pt_BR="menor distância do efetuador ao primeiro eixo",
)
FARTHEST = Text(
    en="largest distance of the end effector from the first axis", pt_BR="maior distância do efetuador ao primeiro eixo"
)
DISC = Text(
    en="largest distance of the end effector from the first axis, two equal links",
    pt_BR="maior distância do efetuador ao primeiro eixo, dois elos iguais",
)
NO_HOLE = Text(
    en="postures of two equal links for a point 1 mm beside the first axis",
    pt_BR="posturas de dois elos iguais para um ponto a 1 mm do primeiro eixo",
)
TOOL = Text(
    en="how far the edge moves with an end effector 100 mm longer",
    pt_BR="quanto a borda anda com ferramenta 100 mm mais longa",
)
AREA = Text(en="area, {which}", pt_BR="área, {which}")
BY_FORMULA = Text(en="area by its formula, {which}", pt_BR="área pela fórmula, {which}")
TWO = Text(en="two links", pt_BR="dois elos")
POLAR = Text(en="polar arm", pt_BR="braço polar")
OUTSIDE = Text(en="postures 1 µm beyond the outer edge", pt_BR="posturas 1 µm além da borda externa")
OUTER = Text(en="postures on the outer edge", pt_BR="posturas na borda externa")
INSIDE = Text(en="postures between the edges", pt_BR="posturas entre as bordas")
INNER = Text(en="postures on the inner edge", pt_BR="posturas na borda interna")
HOLE = Text(en="postures 1 µm inside the hole", pt_BR="posturas 1 µm para dentro do vazio")
ONE_SIDE = Text(
    en="postures between the edges, the elbow to one side only",
    pt_BR="posturas entre as bordas, cotovelo só de um lado",
)
EDGES = Text(en="The annulus", pt_BR="O anel")
EDGE_OUT, EDGE_IN = Text(en="outer edge", pt_BR="borda externa"), Text(en="inner edge", pt_BR="borda interna")
STRETCHED = Text(en="stretched, then folded", pt_BR="esticado, depois dobrado")
