"""Files of what a window shows, made in threads: a notebook, a clip or a picture."""

from __future__ import annotations

import asyncio
import logging
from dataclasses import replace
from math import ceil
from typing import assert_never

import numpy as np

from helicoide.export.scene_notebook import scene_notebook
from helicoide.kinematics.library import load_robot
from helicoide.session.display import CLIP_STEP
from helicoide.session.visitor import Visitor
from helicoide.session.workcell import FAILED
from helicoide.state import State, initial_state, with_joints
from helicoide.studies.study import Motion
from helicoide.text import HelicoideError, Text
from helicoide.view.audience import Server
from helicoide.view.clip import clip_html
from helicoide.view.picture import scene_picture
from helicoide.view.requests import FileRequest, Save, SaveClip, SaveNotebook, SavePicture
from helicoide.view.scene import outlook

MOST_FRAMES = 1500
NOTEBOOK, CLIP, PICTURE = "helicoide.ipynb", "helicoide.html", "helicoide.png"
MAKING = Text(en="Making the file…", pt_BR="Preparando o arquivo…")
BUSY = Text(en="The last file is not finished yet.", pt_BR="O arquivo anterior ainda não ficou pronto.")
UNDRAWN = Text(
    en="The page did not draw the picture: bring its tab to the front and try again.",
    pt_BR="A página não desenhou a imagem: traga a aba para a frente e tente de novo.",
)
log = logging.getLogger("helicoide")


class Exporting:
    """Makes one file at a time for each window, and one clip at a time for all. Use it only on the event loop."""

    def __init__(self, server: Server) -> None:
        self.server = server
        self._clips = asyncio.Lock()
        self._tasks: dict[Visitor, asyncio.Task[None]] = {}

    def begin(self, visitor: Visitor, request: Save | FileRequest) -> None:
        """Make a file, unless it is made already, and have the page of the visitor download it."""
        if isinstance(request, Save):
            visitor.window.client.send_file_download(request.name, request.content)
        elif visitor in self._tasks:
            visitor.window.tell(BUSY)
        else:
            task = self._tasks[visitor] = asyncio.get_running_loop().create_task(self._export(visitor, request))
            task.add_done_callback(lambda _: self._tasks.pop(visitor))

    async def _export(self, visitor: Visitor, request: FileRequest) -> None:
        try:
            name, content = await self._made(visitor, request)
        except HelicoideError as refusal:
            visitor.window.tell(refusal.text)
        except TimeoutError:
            visitor.window.tell(UNDRAWN)
        except Exception:
            if not visitor.window.gone:
                log.exception("a file could not be made")
                visitor.window.tell(FAILED)
        else:
            visitor.window.client.send_file_download(name, content)

    async def _made(self, visitor: Visitor, request: FileRequest) -> tuple[str, bytes]:
        """The name and the content of the file."""
        state, seat = visitor.bay.workcell.state, visitor.place.seat
        match request:
            case SaveNotebook():
                return NOTEBOOK, await asyncio.to_thread(scene_notebook, state, seat.language)
            case SavePicture(size):
                return PICTURE, await asyncio.to_thread(scene_picture, visitor.window.client, size)
            case SaveClip(motion):
                visitor.window.tell(MAKING)
                drawn = _drawn(visitor, state)
                async with self._clips:
                    return CLIP, await asyncio.to_thread(self._clip, visitor, drawn, motion)
            case _:
                assert_never(request)

    def _clip(self, visitor: Visitor, drawn: list[State], motion: Motion | None) -> bytes:
        """A clip of a motion, or of the states that were drawn. Of the robot in the window it has the window's view."""
        camera, states = visitor.window.client.camera, drawn if motion is None else motion_states(motion)
        in_window = states[0].robot is drawn[0].robot
        view = (camera.position, camera.look_at) if in_window else outlook(states[0].robot)
        return clip_html(self.server, states, visitor.place.seat, view)


def _drawn(visitor: Visitor, state: State) -> list[State]:
    """The states of the last seconds that led to this one, and this one."""
    recent = () if visitor.bay.display is None else visitor.bay.display.recent
    return [*(one for one in recent if one.robot is state.robot and one.t < state.t), state]


def motion_states(motion: Motion) -> list[State]:
    """A motion as states of its own robot, at most `MOST_FRAMES`, evenly spaced in time; its first time becomes 0."""
    state = initial_state(load_robot(motion.robot, None, motion.parameters))
    times = motion.times - motion.times[0]
    count = min(MOST_FRAMES, ceil(times[-1] / CLIP_STEP) + 1)
    at = np.linspace(0.0, times[-1], count)
    q = np.column_stack([np.interp(at, times, values) for values in motion.q.T])
    return [replace(with_joints(state, row), t=float(t)) for t, row in zip(at, q, strict=True)]
