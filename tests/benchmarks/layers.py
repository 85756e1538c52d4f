"""What each layer of the scene costs in a frame while the arm moves, for all arms; time of this thread alone."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from time import thread_time_ns
from types import ModuleType

import numpy as np
import viser
from tests.benchmarks.report import p50, verdict

from helicoide import content, gate
from helicoide.foresight import advance_with_search
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.session.planning import plan_motion
from helicoide.session.postures import list_postures
from helicoide.session.preparing import TICK, exercise, rehearse
from helicoide.state import State, initial_state
from helicoide.text import untranslated
from helicoide.view import layers, shapes
from helicoide.view.layers import Stage
from helicoide.view.window import new_seat
from helicoide.view.window_view import View

TITLE = "Layers of the scene, µs per update while the arm moves"
FRAMES, EVERY, GOAL = 60, 2, 1000.0


def _motion(robot: Robot) -> Iterator[State]:
    """A state for each frame: the first joint moves, beside an obstacle, with a list of postures and a plan."""
    state = gate.add_obstacle()(initial_state(robot))
    if "rcm" in robot.frames:
        state = gate.enforce_entry(True)(state)
    there = gate.set_joint(0, float(robot.poses["ready"][0]) + 0.6)
    state = plan_motion(state, there, untranslated("there"))(state)
    state = there(list_postures(state)(state))
    for tick in range(FRAMES * EVERY):
        state = advance_with_search(state, TICK)
        if tick % EVERY == 0:
            yield state


def _cost(server: viser.ViserServer, robot: Robot, layer: ModuleType, states: list[State]) -> float:
    """The median time of an update, µs; the first one, which adds the nodes, does not count."""
    server.scene.reset()
    stage = Stage(server.scene, robot, shapes.load_shapes(robot), lambda request: None, "1")
    seat = new_seat("", "en", None)
    for optional in layers.optional():
        seat = seat.with_layer(optional.NAME, True)
    built, shown, took = layer.build(stage), None, []
    for frame, state in enumerate(states):
        view = View(replace(state), seat, time=0.05 * frame)  # a new state, so that nothing is cached for the layer
        with server.atomic():
            began = thread_time_ns()
            built.update(shown, view)
            took.append((thread_time_ns() - began) / 1000)
        shown = view
    return p50(took[1:])


def run() -> None:
    exercise()
    server = viser.ViserServer(host="127.0.0.1", port=0, verbose=False)
    names = sorted(content.content_folders("robots"))
    costs: dict[str, list[float]] = {layer.NAME: [] for layer in layers.all_layers()}
    for name in names:
        robot = load_robot(name)
        rehearse(robot)
        states = list(_motion(robot))
        for layer in layers.all_layers():
            costs[layer.NAME].append(_cost(server, robot, layer, states))
    server.stop()
    print(f"  {'':20}" + "".join(f"{name[:10]:>11}" for name in names))
    for name, row in sorted(costs.items(), key=lambda item: -max(item[1])):
        print(f"  {name:20}" + "".join(f"{cost:11.0f}" for cost in row))
    print(f"  {'all':20}" + "".join(f"{cost:11.0f}" for cost in np.sum(list(costs.values()), axis=0)))
    verdict("dearest layer", max(max(row) for row in costs.values()), GOAL, " µs")
