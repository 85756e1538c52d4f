"""The palette (Ctrl+K): Stop and other frequent buttons, and every tab, pose, method, layer, lesson, study and arm."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

from helicoide import gate
from helicoide.ik import methods
from helicoide.kinematics.library import robot_titles
from helicoide.kinematics.robot import Robot
from helicoide.lesson import all_lessons, entered
from helicoide.seat import Seat
from helicoide.studies import panel_state
from helicoide.text import Text
from helicoide.view import layers, panels
from helicoide.view.camera import PRESETS
from helicoide.view.page import STOP
from helicoide.view.panels.robot import PARK, READY
from helicoide.view.panels.study import studies_by_source
from helicoide.view.plan_rows import DISCARD, EXECUTE
from helicoide.view.requests import (
    CopyLink,
    ForArm,
    ForLab,
    ForSeat,
    ForStudyPanel,
    Look,
    OwnArm,
    PageRequest,
    PlanMotion,
    Redo,
    ShowTab,
    Stop,
    Undo,
)
from helicoide.view.top_rows import (
    COPY_LINK,
    DARK,
    OWN,
    PROJECTOR,
    SHARED,
    TRANSPARENT,
    with_dark,
    with_projector,
    with_transparent,
)

UNDO_KEY = Text(en="Undo (Ctrl+Z)", pt_BR="Desfazer (Ctrl+Z)")
REDO_KEY = Text(en="Redo (Ctrl+Shift+Z)", pt_BR="Refazer (Ctrl+Shift+Z)")
CAMERA = Text(en="Camera: {title}", pt_BR="Câmera: {title}")
LOOKS = (
    (with_projector, PROJECTOR, Text(en="Projector off", pt_BR="Sem projetor")),
    (with_dark, DARK, Text(en="Light", pt_BR="Claro")),
    (with_transparent, TRANSPARENT, Text(en="Solid arm", pt_BR="Braço opaco")),
)
TAB = Text(en="Tab: {title}", pt_BR="Aba: {title}")
POSE = Text(en="Go to pose: {title}", pt_BR="Ir para a pose: {title}")
PLAN_TO = Text(en="Plan a motion to: {title}", pt_BR="Planejar movimento para: {title}")
METHOD = Text(en="Method: {title}", pt_BR="Método: {title}")
LAYER = Text(en="Show or hide: {title}", pt_BR="Mostrar ou ocultar: {title}")
LESSON = Text(en="Lesson: {title}", pt_BR="Lição: {title}")
STUDY = Text(en="Study: {title}", pt_BR="Estudo: {title}")
ARM = Text(en="Arm: {title}", pt_BR="Braço: {title}")


def palette(robot: Robot) -> Iterator[tuple[Text, PageRequest]]:
    """Every command: its name and its request."""
    yield STOP, Stop()
    yield READY, ForArm(gate.get_ready())
    if robot.panes:
        yield PARK, ForArm(gate.park())
    yield Text(en="Play the path", pt_BR="Reproduzir a trajetória"), ForArm(gate.play())
    yield Text(en="Pause the path", pt_BR="Pausar a trajetória"), ForArm(gate.pause())
    yield UNDO_KEY, Undo()
    yield REDO_KEY, Redo()
    yield COPY_LINK, CopyLink()
    for preset, title in PRESETS.items():
        yield CAMERA.format(title=title), Look(preset)
    for look, on_words, off_words in LOOKS:
        yield on_words, ForSeat(partial(look, True))
        yield off_words, ForSeat(partial(look, False))
    yield OWN, OwnArm(True)
    yield SHARED, OwnArm(False)
    for index, panel in enumerate(panels.all_panels()):
        yield TAB.format(title=panel.TITLE), ShowTab(index)
    for name, title in robot.pose_titles.items():
        yield POSE.format(title=title), ForArm(gate.go_to(name))
        yield PLAN_TO.format(title=title), PlanMotion(gate.go_to(name), title)
    yield EXECUTE, ForArm(gate.execute_plan())
    yield DISCARD, ForArm(gate.clear_plan())
    for name in methods.names():
        yield METHOD.format(title=methods.named(name).TITLE), ForArm(gate.choose_method(name))
    for layer in layers.optional():
        yield LAYER.format(title=layer.TITLE), ForSeat(partial(_toggled, layer.NAME))
    for lesson in all_lessons():
        yield LESSON.format(title=lesson.title), ForSeat(partial(entered, name=lesson.id))
    for name, title in studies_by_source():
        yield STUDY.format(title=title), ForStudyPanel(panel_state.with_study(name))
    for name, title in robot_titles().items():
        yield ARM.format(title=title), ForLab(name)


def _toggled(name: str, seat: Seat) -> Seat:
    """A seat with a layer shown if it was hidden, and hidden if it was shown."""
    return seat.with_layer(name, not seat.visible_layers[name])
