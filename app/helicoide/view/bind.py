"""All callbacks of viser. Each copies the data of its event and passes it on.

viser runs plain functions on many threads and out of order, so every callback is a coroutine on its event loop. An
event without a client is caused by a value that Python wrote.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import viser

from helicoide.arrays import Array
from helicoide.gate import Phase
from helicoide.view.pose import send_pose

Drag = Callable[[Phase, Array, Array], None]


def on_value(handle: Any, act: Callable[[Any], None]) -> None:
    """Call `act` with each value that a user gives to a slider, box, checkbox or dropdown."""

    async def changed(event: viser.GuiEvent[Any]) -> None:
        if event.client is not None:
            act(event.target.value)

    handle.on_update(changed)


def on_press(button: viser.GuiButtonHandle | viser.GuiButtonGroupHandle, act: Callable[[], None]) -> None:
    """Call `act` at each press of a button."""

    async def pressed(event: viser.GuiEvent[Any]) -> None:
        if event.client is not None:
            act()

    button.on_click(pressed)


def on_upload(button: viser.GuiUploadButtonHandle, act: Callable[[str, bytes], None]) -> None:
    """Call `act` with name and content of each uploaded file."""

    async def uploaded(event: viser.GuiEvent[Any]) -> None:
        file = event.target.value
        act(file.name, file.content)

    button.on_upload(uploaded)


def on_drag(gizmo: viser.TransformControlsHandle, act: Drag) -> None:
    """Call `act` with phase, position (3,) m and wxyz at every event of a gizmo.

    The end has the pose of the last update: the handle may have been moved since, by a frame of a state in which the
    drag had not begun. Such a frame reaches the page too, so the pose of the end is sent back.
    """
    last: tuple[Array, Array] | None = None

    async def dragged(event: viser.TransformControlsEvent) -> None:
        nonlocal last
        if event.phase != "end" or last is None:
            last = np.array(event.target.position), np.array(event.target.wxyz)
        act(event.phase, *last)
        if event.phase == "end":
            send_pose(gizmo, *last)

    gizmo.on_update(dragged)


def on_trigger(command: viser.CommandHandle, act: Callable[[], None]) -> None:
    """Call `act` when a command of the palette is chosen."""

    async def triggered(event: object) -> None:
        act()

    command.on_trigger(triggered)


def on_instance(mesh: viser.BatchedMeshHandle, act: Callable[[int], None]) -> None:
    """Call `act` with the number of each instance of a mesh that is clicked."""

    async def clicked(event: viser.SceneNodePointerEvent[viser.BatchedMeshHandle]) -> None:
        if event.instance_index is not None:
            act(event.instance_index)

    mesh.on_click(clicked)


def on_pick(scene: viser.SceneApi, act: Callable[[Array, Array], None]) -> None:
    """Call `act`, and nothing else, with the ray of each click in a scene: its start (3,), m, and direction (3,)."""

    async def picked(event: viser.SceneClickEvent) -> None:
        act(np.array(event.ray_origin), np.array(event.ray_direction))

    scene.remove_click_callback()  # that of layers before these
    register: Any = scene.on_click()  # it takes coroutines, although its type does not say so
    register(picked)
