"""Undo and redo changes of planes, obstacles, zones, entry point, waypoints and settings of methods.

Undo never moves an arm. The arm holds its position where the restored scene or settings could let it move, and a plane
or an obstacle that would come too near to the arm gives way, as if it were dragged. Comparisons of methods, point
clouds and choices of a path are not recorded.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterator
from dataclasses import fields, replace

import numpy as np

from helicoide.arrays import Array
from helicoide.command import HoldPosition
from helicoide.confinement import Obstacles, Planes, limited_plane_centre
from helicoide.gate.check import PARKED, checked
from helicoide.gate.enclosure import STOPPED
from helicoide.gate.method import for_both_arms
from helicoide.gate.obstacles import restored_obstacles
from helicoide.history import Change, History, Undoable
from helicoide.ik.controller import Controller
from helicoide.state import State, Update, with_command, with_drag, with_problem
from helicoide.text import HelicoideError, Text, join_texts
from helicoide.trajectory.waypoints import WaypointList

ROUNDING = 1e-9  # m: a smaller difference is no change
Difference = tuple[Text, Hashable]
"""What differs, in words, and its subject."""

NOTHING_TO_UNDO = Text(en="There is nothing to undo.", pt_BR="Não há nada a desfazer.")
NOTHING_TO_REDO = Text(en="There is nothing to redo.", pt_BR="Não há nada a refazer.")
CONNECTED = Text(
    en="“{what}” stays: while a real arm is connected, planes, obstacles and limits are not undone or redone.",
    pt_BR="“{what}” fica: com um braço real conectado, planos, obstáculos e limites não são desfeitos nem refeitos.",
)
UNDONE = Text(en="Undone: {what}.", pt_BR="Desfeito: {what}.")
REDONE = Text(en="Redone: {what}.", pt_BR="Refeito: {what}.")
HOLDS = Text(en="The arm holds its position.", pt_BR="O braço mantém a posição.")
SET_UP = Text(en="scene changed", pt_BR="cena alterada")
PLANE_ADDED = Text(en="plane {name} added", pt_BR="plano {name} acrescentado")
PLANE_REMOVED = Text(en="plane {name} removed", pt_BR="plano {name} removido")
PLANE_MOVED = Text(en="plane {name} moved", pt_BR="plano {name} movido")
PLANES = Text(en="planes replaced", pt_BR="planos trocados")
OBSTACLE_ADDED = Text(en="obstacle added", pt_BR="obstáculo acrescentado")
OBSTACLE_REMOVED = Text(en="obstacle removed", pt_BR="obstáculo removido")
OBSTACLE_CHANGED = Text(en="obstacle {n} changed", pt_BR="obstáculo {n} alterado")
OBSTACLES = Text(en="obstacles replaced", pt_BR="obstáculos trocados")
ZONES = Text(en="safety and warning distance", pt_BR="distâncias de segurança e de aviso")
ENTRY_ON = Text(en="entry point set", pt_BR="ponto de entrada definido")
ENTRY_OFF = Text(en="entry point removed", pt_BR="ponto de entrada removido")
ENTRY_MOVED = Text(en="entry point moved", pt_BR="ponto de entrada movido")
TAUGHT = Text(en="waypoints changed", pt_BR="pontos alterados")
WAYPOINT_ADDED = Text(en="waypoint {name} added", pt_BR="ponto {name} acrescentado")
WAYPOINT_REMOVED = Text(en="waypoint {name} deleted", pt_BR="ponto {name} excluído")
WAYPOINT_CHANGED = Text(en="waypoint {name} changed", pt_BR="ponto {name} alterado")
METHOD = Text(en="method chosen", pt_BR="método escolhido")
OPTION = Text(en="setting of the method", pt_BR="ajuste do método")
GAINS = Text(en="gain of the closed loop", pt_BR="ganho da malha fechada")
OBJECTIVE = Text(en="secondary objective", pt_BR="objetivo secundário")


def undoable_of(state: State) -> Undoable:
    """The part of a state that can be undone."""
    problem = state.problem
    return Undoable(
        problem.planes, problem.obstacles, problem.zones, problem.entry, state.taught, state.request.controller
    )


def recorded(before: State, after: State) -> State:
    """The state after an update, with what the update changed in its history. A drag is one change.

    Another robot, and an undo itself, bring their own history.
    """
    if after.robot is not before.robot or after.history is not before.history:
        return after
    drag_before, drag = before.request.drag, after.request.drag
    history = before.history
    if drag is not None and drag is not drag_before:
        history = history.finished()
    parts = _parts(undoable_of(before), undoable_of(after))
    if parts:
        title, subject = parts[0] if len(parts) == 1 else (SET_UP, None)
        history = history.with_change(Change(title, subject, undoable_of(before)))
    if drag is None and drag_before is not None:
        history = history.finished()
    return after if history is after.history else replace(after, history=history)


def finish_change() -> Update:
    """Let the next change be one of its own: another pointer or key has gone down."""

    def update(state: State) -> State:
        history = state.history.finished()
        return state if history is state.history else replace(state, history=history)

    return update


def undo_change(connected: bool = False) -> Update:
    """Undo the last change. connected: whether a real arm follows; then no limit, plane or obstacle is changed."""

    def change(state: State) -> State:
        if not state.history.undo:
            raise HelicoideError(NOTHING_TO_UNDO)
        return _returned(state, state.history.undo[-1], state.history.undone, UNDONE, connected)

    return checked(change)


def redo_change(connected: bool = False) -> Update:
    """Make the change again that was undone last. connected: as in `undo_change`."""

    def change(state: State) -> State:
        if not state.history.redo:
            raise HelicoideError(NOTHING_TO_REDO)
        return _returned(state, state.history.redo[-1], state.history.redone, REDONE, connected)

    return checked(change)


def _returned(
    state: State, change: Change, history: Callable[[Undoable], History], words: Text, connected: bool
) -> State:
    """The state with the other side of a change, at rest if that could move the arm, and a notice."""
    present, other = undoable_of(state), change.other
    guarded = bool([*_scene(present, other)])
    if connected and guarded:
        raise HelicoideError(CONNECTED.format(what=change.title))
    if state.arm.parked and guarded:
        raise HelicoideError(PARKED)
    said = [words.format(what=change.title)]
    state = with_drag(state, None)
    if (guarded or [*_settings(present, other)]) and not isinstance(state.request.command, HoldPosition):
        state = with_command(state, HoldPosition())
        said.append(HOLDS)
    if guarded:
        state, gave_way = _with_scene(state, other)
        said += gave_way
    state = _with_settings(replace(state, taught=other.taught), other.controller)
    return replace(state, history=history(present), notice=join_texts(said, " "))


def _with_scene(state: State, other: Undoable) -> tuple[State, list[Text]]:
    """The state with other planes, obstacles, zones and entry point, and what gave way to the arm."""
    planes, stopped = _clear_planes(state, other.planes, other.zones.critical)
    obstacles, at_arm = restored_obstacles(state, other.obstacles)
    problem = replace(state.problem, planes=planes, obstacles=obstacles, zones=other.zones, entry=other.entry)
    if (other.entry is None) != (state.problem.entry is None):
        state = for_both_arms(state, lambda controller: controller.with_method(controller.method))
    said = [STOPPED.format(names=", ".join(stopped), mm=1000 * other.zones.critical)] if stopped else []
    return with_problem(state, problem), [*said, *at_arm]


def _clear_planes(state: State, planes: Planes, critical: float) -> tuple[Planes, list[str]]:
    """The planes, those that return moved back to the critical distance, m, from the arm; and the names of these."""
    present, stopped = state.problem.planes, []
    for index, name in enumerate(planes.names):
        normal, centre = planes.normals[index], planes.centres[index]
        if name in present.names and _same_plane(present, present.names.index(name), planes, index):
            continue
        clear = limited_plane_centre(normal, centre, state.monitored_points, critical)
        if np.linalg.norm(clear - centre) > ROUNDING:
            planes = planes.with_plane(index, normal, clear)
            stopped.append(name)
    return planes, stopped


def _with_settings(state: State, other: Controller) -> State:
    """The state with the method and the settings of another controller; a second arm keeps its method."""

    def change(controller: Controller) -> Controller:
        second = controller.secondary if _same_objective(controller, other) else other.secondary
        return replace(controller, changed=other.changed, gains=other.gains, secondary=second)

    if state.request.controller.method != other.method:
        chosen = state.request.controller.with_method(other.method)
        state = replace(state, request=replace(state.request, controller=chosen))
    return for_both_arms(state, change)


def _parts(old: Undoable, new: Undoable) -> list[Difference]:
    """What differs between two scenes."""
    return [*_scene(old, new), *_waypoints(old.taught, new.taught), *_settings(old, new)]


def _scene(old: Undoable, new: Undoable) -> Iterator[Difference]:
    if old.planes is not new.planes:
        yield from _planes(old.planes, new.planes)
    if old.obstacles is not new.obstacles:
        yield from _obstacles(old.obstacles, new.obstacles)
    if old.zones != new.zones:
        yield ZONES, "zones"
    if old.entry is not new.entry:
        if old.entry is None or new.entry is None:
            yield (ENTRY_OFF, None) if new.entry is None else (ENTRY_ON, None)
        elif not _near(old.entry.point, new.entry.point):
            yield ENTRY_MOVED, "entry"


def _planes(old: Planes, new: Planes) -> Iterator[Difference]:
    if old.names == new.names:
        moved = [k for k in range(len(old.names)) if not _same_plane(old, k, new, k)]
        for k in moved if len(moved) == 1 else ():
            yield PLANE_MOVED.format(name=new.names[k]), ("plane", k)
        if len(moved) > 1:
            yield PLANES, None
    elif new.names[:-1] == old.names:
        yield PLANE_ADDED.format(name=new.names[-1]), None
    elif lost := [k for k, name in enumerate(old.names) if name not in new.names]:
        alone = len(lost) == 1 and len(new.names) == len(old.names) - 1
        yield (PLANE_REMOVED.format(name=old.names[lost[0]]) if alone else PLANES), None
    else:
        yield PLANES, None


def _same_plane(old: Planes, i: int, new: Planes, j: int) -> bool:
    size = old.panes[i].size == new.panes[j].size
    return size and _near(old.normals[i], new.normals[j]) and _near(old.centres[i], new.centres[j])


def _obstacles(old: Obstacles, new: Obstacles) -> Iterator[Difference]:
    count = len(old.radii)
    if len(new.radii) == count:
        same = [_near(old.ends[k], new.ends[k]) and _near(old.radii[k], new.radii[k]) for k in range(count)]
        if same.count(False) == 1:
            yield OBSTACLE_CHANGED.format(n=same.index(False) + 1), ("obstacle", same.index(False))
        elif same.count(False) > 1:
            yield OBSTACLES, None
    elif abs(len(new.radii) - count) == 1:
        yield (OBSTACLE_ADDED if len(new.radii) > count else OBSTACLE_REMOVED), None
    else:
        yield OBSTACLES, None


def _waypoints(old: WaypointList, new: WaypointList) -> Iterator[Difference]:
    if old.waypoints is new.waypoints and old.shape == new.shape:
        return
    fresh = [name for name in new.names if name not in old.names]
    lost = [name for name in old.names if name not in new.names]
    changed = [name for name in old.names if name in new.names and _waypoint(old, name) is not _waypoint(new, name)]
    if (len(fresh), len(lost), len(changed)) == (1, 0, 0):
        yield WAYPOINT_ADDED.format(name=fresh[0]), None
    elif (len(fresh), len(lost), len(changed)) == (0, 1, 0):
        yield WAYPOINT_REMOVED.format(name=lost[0]), None
    elif (len(fresh), len(lost), len(changed)) == (0, 0, 1):
        yield WAYPOINT_CHANGED.format(name=changed[0]), ("waypoint", changed[0])
    else:
        yield TAUGHT, None


def _waypoint(taught: WaypointList, name: str) -> object:
    return taught.waypoints[taught.names.index(name)]


def _settings(old: Undoable, new: Undoable) -> Iterator[Difference]:
    a, b = old.controller, new.controller
    if a is b:
        return
    if a.method != b.method:
        yield METHOD, None
    if a.changed != b.changed:
        yield OPTION, ("option", *_changed_options(a, b))
    if a.gains != b.gains:
        yield GAINS, ("gain", *(k for k, (one, other) in enumerate(zip(a.gains, b.gains, strict=True)) if one != other))
    if not _same_objective(a, b):
        yield OBJECTIVE, ("objective", a.secondary is None or b.secondary is None)


def _changed_options(a: Controller, b: Controller) -> list[tuple[str, str]]:
    """The methods and names of the options that differ."""
    return [
        (method, field.name)
        for method in sorted({*a.changed, *b.changed})
        for field in fields(b.options(method))
        if getattr(a.options(method), field.name) != getattr(b.options(method), field.name)
    ]


def _same_objective(a: Controller, b: Controller) -> bool:
    """Whether the secondary objectives are the same, apart from weights that have grown."""
    if a.secondary is None or b.secondary is None:
        return a.secondary is b.secondary
    names = ("objective", "options", "weight", "as_row", "adapts")
    return all(getattr(a.secondary, name) == getattr(b.secondary, name) for name in names)


def _near(a: Array | float, b: Array | float) -> bool:
    return bool(np.max(np.abs(np.asarray(a) - np.asarray(b)), initial=0.0) <= ROUNDING)
