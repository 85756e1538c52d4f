"""The notebook of a scene: it is valid, it runs, and its values are those of the state at three times of a motion."""

from __future__ import annotations

import ast
import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import nbformat
import numpy as np
import pytest
from tests.driving import after
from tests.notebooks import ran

from helicoide import gate, readout
from helicoide.arrays import frozen
from helicoide.console.scene_names import scene_names
from helicoide.export.notebook import NotebookCell, notebook_file
from helicoide.export.scene_notebook import scene_notebook
from helicoide.foresight import advance_with_search
from helicoide.geometry import rotation
from helicoide.kinematics.library import load_robot
from helicoide.state import State, initial_state, with_joints
from helicoide.text import LANGUAGES, Text, untranslated

RCM_ARM = "dia10"
COMPARED = """
import json
print(json.dumps({
    "q": here.q.tolist(),
    "T": here.T.tolist(),
    "multivectors": {key: one.values.tolist() for key, one in here.multivectors.items()},
    "distances": here.distances.tolist(),
    "instruments": here.instruments,
    "method": here.state.request.controller.method,
    "damping": here.state.request.controller.options("damped").damping,
    "scene": {
        "normals": here.state.problem.planes.normals.tolist(),
        "offsets": here.state.problem.planes.offsets.tolist(),
        "ends": here.state.problem.obstacles.ends.tolist(),
        "radii": here.state.problem.obstacles.radii.tolist(),
        "zones": [here.state.problem.zones.critical, here.state.problem.zones.warning],
        "entry": None if here.state.problem.entry is None else here.state.problem.entry.point.tolist(),
        "gains": here.state.request.controller.gains,
        "gain": here.state.request.controller.options("guarded").gain,
        "objective": (second := here.state.request.controller.secondary)
        and [second.objective, second.weight, second.as_row, second.adapts],
        "steps": [here.after(0.01 * k).q.tolist() for k in (1, 2, 3)],
    },
    "target": None if "target" not in globals() else target,
}))
"""


def values_of(state: State, folder: Path) -> dict[str, Any]:
    """What the notebook of a state computes, printed by one more cell."""
    document = json.loads(scene_notebook(state, "en"))
    document["cells"] += json.loads(notebook_file([NotebookCell("code", COMPARED)]))["cells"]
    document["cells"][-1]["id"] = "compared"
    cells = ran(json.dumps(document).encode(), folder)
    found: dict[str, Any] = json.loads(cells[-1].outputs[0].text)
    return found


def moving(robot: str, seconds: float) -> State:
    """An arm on its way to a target by damped least squares."""
    state = initial_state(load_robot(robot))
    T = with_joints(state, state.arm.q + 0.15).T_world_tool
    asked = gate.set_target(T[:3, 3], rotation.from_matrix(T[:3, :3]))
    for update in (gate.choose_method("damped"), gate.set_option("damped", "damping", 0.125), asked):
        state = update(state)
    return after(state, seconds)


@pytest.mark.parametrize(("robot", "seconds"), [("movemaster", 0.05), ("movemaster", 0.3), ("puma560", 0.1)])
def test_the_values_are_those_of_the_state(robot: str, seconds: float, tmp_path: Path) -> None:
    state = moving(robot, seconds)
    assert state.arm.moving
    found = values_of(state, tmp_path)
    np.testing.assert_array_equal(found["q"], state.arm.q)
    np.testing.assert_allclose(found["T"], state.T_world_tool, atol=1e-12)
    named = {name: one.at(state) for name, one in scene_names(state).items()}
    for name, coefficients in found["multivectors"].items():
        np.testing.assert_allclose(coefficients, named[name].values, atol=1e-12)
    assert {"M_tool", "L1", "M_link1"} <= found["multivectors"].keys()
    np.testing.assert_allclose(found["distances"], readout.plane_distances(state), atol=1e-12)
    np.testing.assert_allclose(found["target"], readout.target_pose(state), atol=1e-15)
    assert (found["method"], found["damping"]) == ("damped", 0.125)
    shown = {one.symbol: one.value for one in readout.instruments(state)}
    for symbol in ("e_p", "e_o", r"\kappa", "w", r"\sigma_{\min}"):
        assert found["instruments"][symbol] == pytest.approx(shown[symbol], abs=1e-9)


def test_lengths_that_were_changed_come_along(tmp_path: Path) -> None:
    state = initial_state(load_robot("planar3r", settings=("l1=1500",)))
    np.testing.assert_allclose(values_of(state, tmp_path)["T"], state.T_world_tool, atol=1e-12)


def scene(robot: str, method: str) -> State:
    """An arm with a box, two spheres, other distances and gains, an objective, and a target."""
    state = initial_state(load_robot(robot))
    T = with_joints(state, state.arm.q + 0.15).T_world_tool
    updates = [
        gate.add_obstacle(),
        gate.set_zones(0.078, 0.12),
        gate.set_option("guarded", "gain", 9.5),
        gate.choose_method(method),
        *(gate.set_gain(k, 3.25 + k) for k in range(4)),
        gate.choose_objective("manipulability"),
        gate.weigh_objective(2.5),
        gate.set_target(T[:3, 3], rotation.from_matrix(T[:3, :3])),
    ]
    if "rcm" in state.robot.frames:
        updates.insert(0, gate.enforce_entry(True))
    for update in updates:
        state = update(replace(state, notice=None))
        assert state.notice is None
    return state


@pytest.mark.parametrize(("robot", "method"), [("movemaster", "damped"), ("puma560", "guarded"), (RCM_ARM, "guarded")])
def test_what_it_makes_again_is_the_scene_and_steps_alike(robot: str, method: str, tmp_path: Path) -> None:
    state = scene(robot, method)
    found = values_of(state, tmp_path)["scene"]
    problem, controller = state.problem, state.request.controller
    np.testing.assert_allclose(np.reshape(found["normals"], (-1, 3)), problem.planes.normals, atol=1e-12)
    np.testing.assert_allclose(found["offsets"], problem.planes.offsets, atol=1e-12)
    np.testing.assert_array_equal(found["ends"], problem.obstacles.ends)
    np.testing.assert_array_equal(found["radii"], problem.obstacles.radii)
    assert len(found["radii"]) == 1
    assert found["zones"] == [problem.zones.critical, problem.zones.warning]
    assert found["entry"] == (None if problem.entry is None else problem.entry.point.tolist())
    assert (found["entry"] is not None) == (robot == RCM_ARM)
    assert found["gains"] == list(controller.gains)
    assert found["gain"] == controller.options("guarded").gain == 9.5
    assert found["objective"] == ["manipulability", 2.5, False, False]
    for step in found["steps"]:
        state = advance_with_search(state, 0.01)
        np.testing.assert_allclose(step, state.arm.q, rtol=0, atol=1e-10)
    assert state.arm.moving


@pytest.mark.parametrize("language", LANGUAGES)
def test_names_are_data(language: Any) -> None:
    """Quotes and line ends in the name of a plane or a robot stay inside their strings."""
    hostile = '\'); raise SystemExit #\n"""\\'
    state = initial_state(load_robot("movemaster"))
    panes = tuple(
        replace(pane, name=hostile + pane.name, title=untranslated(hostile)) for pane in state.problem.planes.panes
    )
    robot = replace(state.robot, name=hostile, title=Text(en=hostile, pt_BR=hostile))
    problem = replace(state.problem, robot=robot, planes=replace(state.problem.planes, panes=panes))
    state = replace(state, problem=problem)
    notebook = nbformat.reads(scene_notebook(state, language).decode(), as_version=4)
    nbformat.validate(notebook)
    first, planes, *_ = (ast.parse(cell.source) for cell in notebook.cells if cell.cell_type == "code")
    called = [node for node in ast.walk(first) if isinstance(node, ast.Call)]
    assert [ast.unparse(call.func) for call in called] == ["helicoide.robot"]
    keys = [key.value for node in ast.walk(planes) if isinstance(node, ast.Dict) for key in node.keys]  # type: ignore[union-attr]
    assert keys == ["plane_1", "plane_2", "plane_3", "plane_4"]


def test_it_is_made_from_any_state() -> None:
    """Also of an arm that is parked, without planes, or in a singular posture, where a number is infinite."""
    state = initial_state(load_robot("planar2r"))
    for q in (state.arm.q, frozen(np.zeros(2))):
        nbformat.validate(nbformat.reads(scene_notebook(with_joints(state, q), "pt_BR").decode(), as_version=4))
