"""Use every control of the page on one arm, without a page."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Any

import numpy as np
import viser
from tests.driving import rough_ride

from helicoide import content, gate, lesson
from helicoide.foresight import advance_with_search, foreseen
from helicoide.ik import methods, objectives
from helicoide.kinematics import workspace
from helicoide.kinematics.library import load_robot
from helicoide.perception.camera import SimulatedCamera
from helicoide.perception.enclosure_reading import available_readings, camera_cloud, plane_in_cloud
from helicoide.readout.signals import signals_of
from helicoide.seat import Seat
from helicoide.session.mapping import plan_of
from helicoide.session.planning import plan_motion
from helicoide.session.postures import list_postures as every_posture
from helicoide.session.postures import to_singular_posture
from helicoide.session.preparing import rehearse
from helicoide.session.replaying import along_fastest
from helicoide.session.workcell import TICK
from helicoide.state import State, Update, initial_state
from helicoide.text import HelicoideError
from helicoide.trajectory.waypoints import MOVE_TYPES
from helicoide.view import layers, panels, shapes
from helicoide.view.layers import Stage
from helicoide.view.requests import (
    CountMap,
    ForArm,
    ForSeat,
    ListPostures,
    PageRequest,
    PlanMotion,
    PlayFastest,
    PlayTaught,
    Tour,
    TrySingular,
)
from helicoide.view.rows import (
    Button,
    Checkbox,
    DependentRows,
    Dropdown,
    Folder,
    HtmlRow,
    Row,
    Slider,
    TextEntry,
    VectorRow,
)
from helicoide.view.window_view import View

FAR = 3.0


@dataclass
class Lab:
    """An arm with one seat."""

    state: State
    seat: Seat
    layers: list[Any]
    panels: list[list[Row]]
    shown: View | None = None

    def view(self) -> View:
        return View(self.state, self.seat)

    def act(self, request: PageRequest) -> None:
        """Carry out a request as the lab does, but without other processes."""
        match request:
            case ForArm(update):
                self.post(update)
            case ForSeat(update):
                self.seat = update(self.seat)
            case PlayTaught():
                self.post(gate.replay_through(self.state))
            case PlayFastest():
                self.post(along_fastest(self.state))
            case ListPostures():
                self.post(every_posture(self.state))
            case PlanMotion(update, title):
                self.post(plan_motion(self.state, update, title))
            case TrySingular():
                self.post(to_singular_posture(self.state))
            case CountMap(kind):
                workspace.count_chunk(replace(plan_of(self.state.robot, kind), samples=1), 0)
            case Tour():
                self.tour()
            case _:
                return
        self.pass_time(3)

    def post(self, update: Update) -> None:
        self.state = update(self.state)

    def pass_time(self, ticks: int) -> None:
        """Advance the arm, with its goal computed and drawn about as often as in the lab."""
        for tick in range(ticks):
            self.state = advance_with_search(self.state, TICK)
            if tick % 10 == 0:
                self.state = foreseen(self.state)
                self.draw()

    def draw(self) -> None:
        """Update all layers, and compute all rows."""
        view = self.view()
        for layer in self.layers:
            layer.update(self.shown, view)
        self.shown = view
        for signal in signals_of(self.state).values():
            signal.read(self.state)
        for row in leaves(self.panels, view):
            match row:
                case HtmlRow():
                    row.html(view)
                case Slider() | VectorRow() | Checkbox() | Dropdown():
                    row.value(view)

    def tour(self) -> None:
        camera = SimulatedCamera(noise=0.002, outliers=0.1, resolution=(40, 30))
        for reading in available_readings(self.state.robot):
            inside = self.state.T_world_tool[:3, 3]
            found = plane_in_cloud(camera_cloud(camera, self.state), reading, inside)
            self.post(gate.show_cloud(reading.name, *found))


def leaves(rows: Sequence[Any], view: View) -> Iterator[Any]:
    """The rows that are shown now, including those in folders."""
    for row in rows:
        if isinstance(row, list):
            yield from leaves(row, view)
        elif isinstance(row, Folder):
            inner = row.rows
            yield from leaves(inner.rows(inner.key(view)) if isinstance(inner, DependentRows) else inner, view)
        else:
            yield row


def requests(row: Row, view: View) -> list[Callable[[], PageRequest]]:
    """The requests that a user can make with a row: ends and middle of a slider, every option, a far vector."""
    match row:
        case Slider(lower=low, upper=high, value=value):
            return [lambda x=x: row.request(x) for x in (low, high, (low + high) / 2, value(view))]
        case Button(enabled=enabled, shown=shown):
            return [lambda: row.request(view)] if enabled(view) and shown(view) else []
        case Checkbox(value=value):
            return [lambda on=on: row.request(on) for on in (not value(view), value(view))]
        case Dropdown(options=options):
            return [lambda key=key: row.request(key) for key, _ in (options(view) if callable(options) else options)]
        case VectorRow(value=value):
            here = value(view)
            there = (here[0] + 50.0, here[1] - 2000.0, here[2] + 900.0)
            return [lambda xyz=xyz: row.request(view, xyz) for xyz in (there, here)]
        case TextEntry():
            return [lambda: row.request("1"), lambda: row.request("0 0 1 900")]
    return []


def press(lab: Lab, rows: Sequence[Row]) -> None:
    """Use every row once, also those that appear meanwhile."""
    pressed: set[str] = set()
    while fresh := [row for row in leaves(rows, lab.view()) if _name(row, lab.view()) not in pressed]:
        row, view = fresh[0], lab.view()
        pressed.add(_name(row, view))
        for request in requests(row, view):
            with suppress(HelicoideError):
                lab.act(request())


def _name(row: Any, view: View) -> str:
    label = getattr(row, "label", "")
    return f"{type(row).__name__} {label(view) if callable(label) else label}"


def opened(name: str, server: viser.ViserServer) -> Lab:
    """An arm at `ready`, with a seat that shows every layer."""
    robot = load_robot(name)
    rehearse(robot)
    shows = MappingProxyType({layer.NAME: True for layer in layers.optional()})
    lab = Lab(
        initial_state(robot),
        Seat("", "en", visible_layers=shows),
        [],
        [panel.rows(robot) for panel in panels.all_panels()],
    )
    server.scene.reset()
    stage = Stage(server.scene, robot, shapes.load_shapes(robot), lab.act, "")
    lab.layers = [layer.build(stage) for layer in layers.all_layers()]
    return lab


def drags(lab: Lab) -> None:
    """Drag the target far out in every direction, through planes and under the bench, and drag each plane."""
    reach, wxyz = FAR * lab.state.robot.reach, [1.0, 0.0, 0.0, 0.0]
    for way in (*np.eye(3), *-np.eye(3)):
        here = lab.state.T_world_tool[:3, 3]
        for phase, share in (("start", 0.0), ("update", 0.3), ("update", 1.0), ("end", 1.0)):
            lab.post(gate.drag_target("", phase, here + share * reach * way, wxyz))  # type: ignore[arg-type]
            lab.pass_time(11)
        lab.pass_time(60)
    for index in range(len(lab.state.problem.planes.panes)):
        centre = lab.state.problem.planes.centres[index]
        for phase in ("start", "update", "end"):
            lab.post(gate.drag_plane("", phase, index, 0.3 * centre, wxyz))  # type: ignore[arg-type]
            lab.pass_time(5)
    lab.post(gate.restore_planes())


def paths(lab: Lab) -> None:
    """Play, pause and scrub every path of the arm, and follow it in the least time."""
    for name in gate.presets(lab.state.robot):
        for update in (gate.choose_path(name), gate.play(), gate.pause(), gate.scrub(0.4), gate.play()):
            lab.post(update)
            lab.pass_time(21)
        lab.post(along_fastest(lab.state))
        lab.pass_time(21)


def waypoints(lab: Lab) -> None:
    """Record waypoints of every move type, and follow them."""
    for way, posture in zip(MOVE_TYPES, [*lab.state.robot.poses, *MOVE_TYPES], strict=False):
        lab.post(gate.record(way))
        lab.post(gate.go_to(posture if posture in lab.state.robot.poses else "ready"))
        lab.pass_time(60)
    lab.post(gate.replay_through(lab.state))
    lab.pass_time(300)


def postures(lab: Lab) -> None:
    """Go to every named posture, park, and get ready again."""
    for posture in lab.state.robot.poses:
        lab.post(gate.go_to(posture))
        lab.pass_time(100)
    for update in (gate.park(), gate.get_ready()):
        lab.post(update)
        lab.pass_time(900)


def surroundings(lab: Lab) -> None:
    """Drag with obstacles, with a compared arm, and, if the arm has an instrument, with the entry point held."""
    for update in (gate.add_obstacle(), gate.add_obstacle(), gate.compare_with("damped")):
        lab.post(update)
        drags(lab)
    if "rcm" in lab.state.robot.frames:
        lab.post(gate.enforce_entry(True))
        lab.post(gate.drag_entry("", "start", lab.state.problem.entry.point))  # type: ignore[union-attr]
        lab.post(gate.drag_entry("", "end", lab.state.problem.entry.point + 0.02))  # type: ignore[union-attr]
        drags(lab)


def ways_to_drive(lab: Lab) -> None:
    """Drive with every method, every setting of it, and every secondary objective."""
    (rows,) = [panel.rows(lab.state.robot) for panel in panels.all_panels() if panel.__name__.endswith(".method")]
    for name in methods.names():
        lab.post(gate.choose_method(name))
        press(lab, [row for row in rows if not isinstance(row, Dropdown)])
        for objective in objectives.names():
            for update in (gate.choose_objective(objective), gate.objective_as_row(True), gate.grow_weights(True)):
                lab.post(update)
                lab.post(gate.set_target(lab.state.T_world_tool[:3, 3] + 0.05, [1.0, 0.0, 0.0, 0.0]))
                lab.pass_time(5)


def lessons(lab: Lab) -> None:
    """Set up every step of every lesson with this arm, and check its goal."""
    for name in content.content_folders("lessons"):
        read = lesson.load_lesson(name)
        if read.robot == lab.state.robot.name:
            for step in read.steps:
                lab.post(step.setup)
                lab.pass_time(11)
                lesson.is_goal_met(step, lab.state, lab.seat)
                lesson.mistake_made(step, lab.state, lab.seat)


def panels_pressed(lab: Lab) -> None:
    """Use every row of every panel."""
    press(lab, [row for panel in lab.panels for row in panel])


def ride(lab: Lab) -> None:
    """Random requests, also changes of limits, on an arm with planes."""
    if lab.state.robot.panes:
        rough_ride(lab.state, np.random.default_rng(0), 500)


def everything(name: str, server: viser.ViserServer) -> None:
    """Run all of these with one arm, each from `ready`."""
    for do in (drags, paths, waypoints, postures, surroundings, ways_to_drive, lessons, panels_pressed, ride):
        do(opened(name, server))
