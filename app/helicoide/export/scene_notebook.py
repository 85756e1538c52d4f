"""The present scene as a Jupyter notebook, which makes the arm again and computes its numbers."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from helicoide import readout
from helicoide.arrays import Array
from helicoide.command import FollowPath, MoveToJoints, MoveToPose
from helicoide.confinement import Zones
from helicoide.console.scene_names import plane_names
from helicoide.content import content_folders
from helicoide.export.notebook import NotebookCell, notebook_file
from helicoide.export.study_table import localized_number
from helicoide.ik import objectives
from helicoide.ik.controller import GUARDED, Controller
from helicoide.ik.method import settings
from helicoide.ik.methods import named
from helicoide.kinematics.library import packaged_urdfs
from helicoide.kinematics.robot import Robot
from helicoide.state import State
from helicoide.text import Language, Text

HEAD = Text(
    en="# {robot}: a scene of Helicoide\n\nThe cells make the scene again with the installed package and compute its "
    "numbers. Lengths are in metres, angles in radians. The lab has a page that describes the names.",
    pt_BR="# {robot}: uma cena do Helicoide\n\nAs células refazem a cena com o pacote instalado e calculam os seus "
    "números. Comprimentos em metros, ângulos em radianos. O laboratório tem uma página que descreve os nomes.",
)
POSTURE = Text(
    en="## Posture, planes and what else is there\n\nWaypoints, point clouds, a ball and a second arm are left out.",
    pt_BR="## Postura, planos e o que mais há na cena\n\nPontos, nuvens de pontos, uma bola e um segundo braço não "
    "vêm junto.",
)
TARGET = Text(
    en="## Target\n\nThe method is “{method}”, with its settings and gains. What it remembers of the motion begins "
    "anew.",
    pt_BR="## Alvo\n\nO método é “{method}”, com os seus ajustes e ganhos. O que ele guarda do movimento começa de "
    "novo.",
)
POSE_ALONE = Text(
    en="In the lab the arm followed a path or moved its joints. Here the target is the pose that this asked for when "
    "the notebook was saved.",
    pt_BR="No laboratório o braço seguia uma trajetória ou movia as juntas. Aqui o alvo é a pose que isso pedia quando "
    "o caderno foi salvo.",
)
STEP = Text(
    en="## The next step\n\nThe joint values 10 ms later, under limits, planes and obstacles as in the lab.",
    pt_BR="## O próximo passo\n\nOs valores das juntas 10 ms depois, com limites, planos e obstáculos como no "
    "laboratório.",
)
FORWARD = Text(en="## Forward kinematics in three ways", pt_BR="## Cinemática direta por três caminhos")
ALGEBRA = Text(en="## The multivectors of the scene", pt_BR="## Os multivetores da cena")
DISTANCES = Text(
    en="## Distances\n\nA row for each monitored point, a column for each plane, in metres.",
    pt_BR="## Distâncias\n\nUma linha por ponto monitorado, uma coluna por plano, em metros.",
)
NUMBERS = Text(en="## The numbers of the tab “Method”", pt_BR="## Os números da aba “Método”")
SHOWN = Text(en="When the notebook was saved, the page showed:", pt_BR="Quando o caderno foi salvo, a página mostrava:")
INVERSE = Text(en="## Every posture for the target", pt_BR="## Todas as posturas do alvo")
LAB = Text(
    en="## Go on in the lab\n\nCopy this into a cell: it opens the lab and asks the arm to go to this posture.",
    pt_BR="## Continuar no laboratório\n\nCopie isto numa célula: abre o laboratório e leva o braço a esta postura.",
)
IN_LAB = "\n\n```python\nlab = helicoide.lab(arm)\nlab.q = q\nlab\n```"


def scene_notebook(state: State, language: Language) -> bytes:
    """The file of a notebook with the scene of a state, its target and its method, and its numbers.

    The scene is robot, posture, planes, obstacles, entry point and distances; the method has its settings and gains.
    """
    return notebook_file(_cells(state, language))


def _cells(state: State, language: Language) -> Iterator[NotebookCell]:
    def words(text: Text, more: str = "") -> NotebookCell:
        return NotebookCell("markdown", text[language] + more)

    def code(*lines: str) -> NotebookCell:
        return NotebookCell("code", "\n".join(lines))

    aims = isinstance(state.request.command, MoveToPose | FollowPath | MoveToJoints)
    yield words(HEAD.format(robot=state.robot.title))
    yield code("import helicoide", "", f"arm = {_robot(state.robot, language)}", "arm")
    yield words(POSTURE)
    yield code(f"q = {state.arm.q.tolist()}", *_planes(state), "here = arm.at(q, planes)", *_around(state), "here")
    if aims:
        more = "" if isinstance(state.request.command, MoveToPose) else f" {POSE_ALONE[language]}"
        yield words(TARGET.format(method=named(state.request.controller.method).TITLE), more)
        yield code(f"target = {_matrix(readout.target_pose(state))}", *_towards(state), "here.instruments")
        yield words(STEP)
        yield code("here.after(0.01).q")
    yield words(FORWARD)
    yield code("here.forward")
    yield words(ALGEBRA)
    yield code("for name, multivector in here.multivectors.items():", '    print(f"{name}: {multivector}")')
    yield code("here.motor")
    if state.problem.planes.panes:
        yield words(DISTANCES)
        yield code("here.distances.round(4)")
    yield words(NUMBERS, f"\n\n{SHOWN[language]}\n\n{_numbers(state, language)}")
    yield code("here.instruments")
    if aims:
        yield words(INVERSE)
        yield code(f"arm.inverse(target, start=q, orientation={state.request.with_orientation})")
    yield words(LAB, IN_LAB)


def _robot(robot: Robot, language: Language) -> str:
    """The call that loads the robot: by its name, or else from its URDF file."""
    chosen = [f"language={language!r}"]
    if robot.name in content_folders("robots"):
        name = robot.name
        if robot.parameters:
            chosen.append(f"parameters={ {length: 1000 * value for length, value in robot.parameters.items()}!r}")
    else:
        name = robot.name if packaged_urdfs().get(robot.name) == robot.urdf else str(Path(robot.urdf))
        chosen += [f"tip={robot.tool_link!r}", f"base={robot.base or None!r}"]
    return f"helicoide.robot({name!r}, {', '.join(chosen)})"


def _planes(state: State) -> Iterator[str]:
    planes = state.problem.planes
    yield "planes = {"
    for name, normal, offset in zip(plane_names(state), planes.normals.tolist(), planes.offsets.tolist(), strict=True):
        yield f"    {name!r}: helicoide.plane({normal}, {offset}),"
    yield "}"


def _around(state: State) -> Iterator[str]:
    """The line that adds obstacles, entry point and distances to `here`, where there are any or they were changed."""
    problem, given = state.problem, list[str]()
    if len(problem.obstacles.radii):
        spheres = zip(problem.obstacles.ends[:, 0].tolist(), problem.obstacles.radii.tolist(), strict=True)
        given.append(f"obstacles={list(spheres)!r}")
    if problem.entry is not None:
        given.append(f"entry={problem.entry.point.tolist()}")
    if problem.zones != Zones():
        given.append(f"zones={(problem.zones.critical, problem.zones.warning)!r}")
    if given:
        yield f"here = here.among({', '.join(given)})"


def _towards(state: State) -> Iterator[str]:
    """The lines that add target, method, settings, gains and secondary objective to `here`.

    The settings of the guarded step count with every method, as it limits them all.
    """
    controller, orientation = state.request.controller, state.request.with_orientation
    for method in dict.fromkeys((GUARDED, controller.method)):
        options = _changed_settings(controller.options(method), named(method).Options())
        if options or method == controller.method:
            yield f"here = here.towards(target, {method!r}, {options!r}, orientation={orientation})"
    if controller.gains != Controller().gains:
        yield f"here = here.with_gains{controller.gains!r}"
    if (second := controller.secondary) is not None:
        options = _changed_settings(second.options, objectives.named(second.objective).Options())
        asked = f"weight={second.weight!r}, as_row={second.as_row}, adapts={second.adapts}"
        yield f"here = here.with_objective({second.objective!r}, {options!r}, {asked})"


def _changed_settings(chosen: Any, default: Any) -> dict[str, object]:
    """The settings that differ from their defaults, by name."""
    return {
        name: getattr(chosen, name)
        for name in settings(type(chosen))
        if getattr(chosen, name) != getattr(default, name)
    }


def _matrix(T: Array) -> str:
    return "[\n" + "".join(f"    {row},\n" for row in T.tolist()) + "]"


def _numbers(state: State, language: Language) -> str:
    """The instruments of the state as a table in Markdown."""
    rows = [
        f"| {one.title[language]} | ${one.symbol}$ | {localized_number(one.value, one.unit)[language]} |"
        for one in readout.instruments(state)
    ]
    return "\n".join(["| | | |", "|---|---|---|", *rows])
