"""Three links in a plane: two postures by two roads, and which of them is nearer."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.confinement import Obstacles
from helicoide.ik import closed
from helicoide.ik.closed import planar3r
from helicoide.ik.families import elbow
from helicoide.ik.postures import choice, numeric
from helicoide.ik.postures.branch import tool_at, wrap
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.robot import Robot
from helicoide.studies._campos_arms import planar_pose, planar_with_lengths
from helicoide.studies._campos_rows import (
    POSES,
    campos_result,
    length_settings,
    posture_chart,
    posture_motion,
    slide_statement,
)
from helicoide.studies.study import Chart, ChartLine, Interpretation, Progress, Result, Row, printed_statement
from helicoide.text import Text, untranslated

TITLE = Text(en="Three links, two postures", pt_BR="Três elos, duas posturas")
SOURCE = "Campos 1998, s.15–18, s.24, s.38–54"
ABOUT = Text(
    en="For a point and an orientation three links have two postures, elbow up and elbow down, and algebra and "
    "geometry lead to the same angles. Which of the two is nearer depends on how much the large joints count, and an "
    "obstacle at the elbow of the nearer one leaves the other.",
    pt_BR="Para um ponto e uma orientação, três elos têm duas posturas, cotovelo para cima e para baixo, e a álgebra e "
    "a geometria levam aos mesmos ângulos. Qual das duas está mais perto depende de quanto pesam as juntas grandes, e "
    "um obstáculo no cotovelo da mais próxima deixa a outra.",
)
ROBOT = "planar3r"

L1, L2, L3 = 1.0, 0.7, 0.2
LENGTHS = length_settings(l1=L1, l2=L2, l3=L3)
# (x, y, φ) of the third axis, m and rad: one goal whose steps are drawn; and one to choose for from where the arm is.
GOAL, CHOICE = (1.0, 0.8, 0.5), (-0.7, -1.1, -1.4)
NOW = frozen([0.5, 0.2, -1.0])
ALIKE, FALLING = (1, 1, 1), (3, 2, 1)
POST, FEW, TRIED, CHOICES = 0.05, 500, 60, 1000


@dataclass(frozen=True)
class Options:
    """How many random poses are solved."""

    poses: Annotated[float, POSES] = 20_000


def third_axis_pose(x: float, y: float, phi: float) -> Array:
    """The tool pose (4, 4), m, with the third axis at (x, y), m, and the hand at the angle φ, rad."""
    return planar_pose(x + L3 * np.cos(phi), y + L3 * np.sin(phi), phi)


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Algebra and geometry, the choice of a posture, and random postures; short: 500 of them."""
    robot = planar_with_lengths(ROBOT, L1, L2, L3)
    branches = closed.solve_closed_form(planar3r, robot, third_axis_pose(*GOAL), np.zeros(3)).branches
    missed, apart, lost, counts = compare_solutions(robot, FEW if short else int(options.poses), progress)
    near, weighed, around = rankings(robot)
    less, others = weight_effect(robot)
    rows = [
        Row(LEAST, min(counts), "", printed_statement("2", "s.15")),
        Row(MOST, max(counts), "", printed_statement("2", "s.15")),
        Row(ALGEBRA_VS_GEOMETRY, apart, "rad", SIGN_RULE),
        Row(BY_COSINE, disagreements(robot), "", COSINE),
        Row(LESS, less, "rad", SMALL_LINKS, (NEAR, WEIGHTS, LINKS)),
        Row(PLACE, [row.branch.name for row in around].index(near[0].branch.name) + 1, "", RULED_OUT, (POSTED,)),
        *(
            Row(COST.format(which=which, weights=weights), row.cost)
            for weights, ranking in (("1, 1, 1", near), ("3, 2, 1", weighed))
            for which, row in zip((NEARER, FARTHER), ranking, strict=True)
        ),
        Row(OTHERS, others),
        Row(MISSED, missed),
        Row(LOST, lost, "rad"),
    ]
    named = [(branch.name, branch.q) for branch in branches]
    charts = [
        posture_chart(TITLE, named),
        _drawn(robot, TITLE_PLANE, named),
        _drawn(robot, TITLE_CHOICE, _choice(near)),
    ]
    motions = [
        posture_motion(ROBOT, [q for _, q in named], LENGTHS, TITLE),
        posture_motion(ROBOT, [NOW, near[0].q, NOW, weighed[0].q], LENGTHS, TITLE_CHOICE),
    ]
    return campos_result(rows, charts, motions)


Ranking = tuple[choice.Ranked, ...]


def rankings(robot: Robot) -> tuple[Ranking, Ranking, Ranking]:
    """Postures ranked with equal weights, with decreasing weights, and with an obstacle at the elbow of the nearest."""
    branches = closed.solve_closed_form(planar3r, robot, third_axis_pose(*CHOICE), NOW).branches
    near = choice.ranked(robot, branches, NOW, ALIKE)
    post = Obstacles().with_sphere(link_poses(robot.chain, near[0].branch.q)[2][:3, 3], POST)
    around = choice.ranked(robot, branches, NOW, ALIKE, choice.touching(robot, post))
    return near, choice.ranked(robot, branches, NOW, FALLING), around


def weight_effect(robot: Robot) -> tuple[float, float]:
    """The reduction of the rotation of joint 1, rad, by decreasing weights, as a mean of random choices.

    Second, the share of choices in which another posture is chosen. With equal weights two postures often cost the
    same, and rounding decides between them.
    """
    turns = []
    for now, q in np.random.default_rng(17).uniform(-np.pi, np.pi, (CHOICES, 2, 3)):
        branches = closed.solve_closed_form(planar3r, robot, tool_at(robot, frozen(q)), now).branches
        changes = (choice.ranked(robot, branches, now, weights)[0].change for weights in (ALIKE, FALLING))
        turns.append([abs(float(change[0])) for change in changes])
    alike, falling = np.array(turns).T
    return float((alike - falling).mean()), float((alike != falling).mean())


def compare_solutions(robot: Robot, count: int, progress: Progress) -> tuple[float, float, float, set[int]]:
    """For random postures: worst residual, difference of algebra and geometry, rad, generating posture, counts.

    Geometry: θ₁ = β + ψ where θ₂ < 0, and β − ψ where θ₂ > 0. Source: Campos 1998, s.54.
    """
    missed, apart, lost, counts = 0.0, 0.0, 0.0, set[int]()
    for done, q in enumerate(np.random.default_rng(20).uniform(-np.pi, np.pi, (count, 3)), start=1):
        answer = closed.solve_closed_form(planar3r, robot, tool_at(robot, frozen(q)), np.zeros(3))
        counts.add(len(answer.branches))
        missed = max(missed, *(max(branch.missed, branch.turned) for branch in answer.branches))
        lost = max(lost, min(float(np.abs(wrap(branch.q - q)).max()) for branch in answer.branches))
        for steps in answer.values:
            psi = steps["ψ"] if steps["θ₂"] < 0 else -steps["ψ"]
            apart = max(apart, abs(float(wrap(steps["β"] + psi - steps["θ₁"]))))
        progress(done / count)
    return missed, apart, lost, counts


def disagreements(robot: Robot) -> int:
    """The number of random poses for which the test by c₂ and independent searches disagree."""
    links, count = elbow.Annulus(L1, L2), 0
    for x, y, phi in np.random.default_rng(44).uniform([-2, -2, -np.pi], [2, 2, np.pi], (TRIED, 3)):
        goal = np.ascontiguousarray(third_axis_pose(x, y, phi))
        found, _ = numeric.distinct_postures(robot, goal, np.zeros(3), True, 4)
        count += (abs(elbow.cosine_of_elbow(x, y, links)) <= 1) != (len(found) > 0)
    return count


def _choice(near: Ranking) -> list[tuple[Text, Array]]:
    return [(PRESENT, NOW), *((row.branch.name, row.branch.q) for row in near)]


def _drawn(robot: Robot, title: Text, postures: list[tuple[Text, Array]]) -> Chart:
    """The links in their plane, m."""
    lines = []
    for name, q in postures:
        points = [*link_poses(robot.chain, q)[1:, :2, 3], tool_at(robot, q)[:2, 3]]
        lines.append(ChartLine(name, *np.array(points).T))
    return Chart(title, untranslated("x, m"), untranslated("y, m"), tuple(lines))


SIGN_RULE = slide_statement(
    "algebraic = geometric; θ₁ = β + ψ for θ₂ < 0, β − ψ for θ₂ > 0",
    "algébrica = geométrica; θ₁ = β + ψ para θ₂ < 0, β − ψ para θ₂ > 0",
    "s.24, s.54",
    0,
    "=",
    1e-9,
)
COSINE = slide_statement("−1 ≤ c₂ ≤ 1, else out of reach", "−1 ≤ c₂ ≤ 1, senão fora de alcance", "s.44", 0)
SMALL_LINKS = slide_statement(
    "weights: the small links move rather than the large",
    "pesos: movem-se os elos pequenos em vez dos grandes",
    "s.17",
    0,
    ">",
)
RULED_OUT = slide_statement(
    "an obstacle may rule out the nearest", "um obstáculo pode excluir a mais próxima", "s.17", 1, ">"
)
NEAR = Interpretation(
    Text(en="near: the least Σ wᵢ |Δθᵢ|", pt_BR="perto: a menor Σ wᵢ |Δθᵢ|"),
    Text(en="with squares 0.088 rad less", pt_BR="com quadrados, 0,088 rad a menos"),
)
WEIGHTS = Interpretation(
    Text(en="weights 3, 2, 1", pt_BR="pesos 3, 2, 1"),
    Text(
        en="with 6, 2, 1 0.183 rad less, with 2, 1.5, 1 0.042",
        pt_BR="com 6; 2; 1, 0,183 rad a menos; com 2; 1,5; 1, 0,042",
    ),
)
POSTED = Interpretation(
    Text(en="a post of 50 mm at its elbow", pt_BR="um poste de 50 mm no cotovelo dela"),
    Text(en="one that it does not touch leaves the nearest", pt_BR="um que ela não toca deixa a mais próxima"),
)
LINKS = Interpretation(
    Text(en="links of 1, 0.7 and 0.2 m", pt_BR="elos de 1; 0,7 e 0,2 m"),
    Text(en="with 0.5, 1 and 0.3 m 0.115 rad less", pt_BR="com 0,5; 1 e 0,3 m, 0,115 rad a menos"),
)
COST = Text(en="cost of the {which} posture, weights {weights}", pt_BR="custo da postura {which}, pesos {weights}")
NEARER, FARTHER = Text(en="nearer", pt_BR="mais próxima"), Text(en="farther", pt_BR="mais distante")
LEAST = Text(en="least number of postures of random poses", pt_BR="menor número de posturas de poses aleatórias")
MOST = Text(en="largest number of postures of random poses", pt_BR="maior número de posturas de poses aleatórias")
MISSED = Text(en="worst miss of any posture", pt_BR="maior erro de qualquer postura")
ALGEBRA_VS_GEOMETRY = Text(
    en="largest difference of algebra and geometry", pt_BR="maior diferença entre álgebra e geometria"
)
LOST = Text(en="worst distance of the generating posture", pt_BR="maior distância da postura geradora")
BY_COSINE = Text(
    en="random poses for which c₂ and searches say different things",
    pt_BR="poses aleatórias em que c₂ e as buscas discordam",
)
LESS = Text(
    en="how much less joint 1 turns with weights 3, 2, 1 than with 1, 1, 1, on average of 1000 choices",
    pt_BR="quanto a junta 1 gira a menos com pesos 3, 2, 1 do que com 1, 1, 1, em média de 1000 escolhas",
)
OTHERS = Text(
    en="share of these choices in which the weights lead to another posture",
    pt_BR="fração dessas escolhas em que os pesos levam a outra postura",
)
PLACE = Text(
    en="place in the choice of the nearest posture, a post at its elbow",
    pt_BR="lugar na escolha da postura mais próxima, com um poste no cotovelo dela",
)
TITLE_PLANE = Text(en="Elbow up and elbow down", pt_BR="Cotovelo para cima e para baixo")
TITLE_CHOICE = Text(en="The choice", pt_BR="A escolha")
PRESENT = Text(en="where the arm is", pt_BR="onde o braço está")
