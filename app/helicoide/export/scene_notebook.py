"""The present scene as a Jupyter notebook, which makes the arm again and computes its numbers."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from helicoide import readout
from helicoide.arrays import Array
from helicoide.command import FollowPath, MoveToJoints, MoveToPose
from helicoide.console.scene_names import plane_names
from helicoide.content import content_folders
from helicoide.export.notebook import NotebookCell, notebook_file
from helicoide.export.study_table import localized_number
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
POSTURE = Text(en="## Posture and planes", pt_BR="## Postura e planos")
TARGET = Text(
    en="## Target\n\nThe method is “{method}”.",
    pt_BR="## Alvo\n\nO método é “{method}”.",
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
    """The file of a notebook with robot, posture, planes, target and method of a state, and its numbers."""
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
    yield code(f"q = {state.arm.q.tolist()}", *_planes(state), "here = arm.at(q, planes)", "here")
    if aims:
        yield words(TARGET.format(method=named(state.request.controller.method).TITLE))
        yield code(f"target = {_matrix(readout.target_pose(state))}", _towards(state), "here.instruments")
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


def _towards(state: State) -> str:
    """The line that adds target, method and changed options to `here`."""
    controller = state.request.controller
    default, chosen = named(controller.method).Options(), controller.options(controller.method)
    options = {
        name: getattr(chosen, name)
        for name in settings(type(chosen))
        if getattr(chosen, name) != getattr(default, name)
    }
    orientation = state.request.with_orientation
    return f"here = here.towards(target, {controller.method!r}, {options!r}, orientation={orientation})"


def _matrix(T: Array) -> str:
    return "[\n" + "".join(f"    {row},\n" for row in T.tolist()) + "]"


def _numbers(state: State, language: Language) -> str:
    """The instruments of the state as a table in Markdown."""
    rows = [
        f"| {one.title[language]} | ${one.symbol}$ | {localized_number(one.value, one.unit)[language]} |"
        for one in readout.instruments(state)
    ]
    return "\n".join(["| | | |", "|---|---|---|", *rows])
