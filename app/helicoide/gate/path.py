"""The path that the target follows: which one, how fast, and where on it."""

from __future__ import annotations

from dataclasses import replace

from helicoide.command import Along, Course, Hold
from helicoide.gate.check import driven, finite
from helicoide.gate.presets import path_of, title_of
from helicoide.state import State, Update, commanded
from helicoide.text import HelicoideError, Text
from helicoide.trajectory.fastest import Shape


def play() -> Update:
    """Follow the path from where its parameter stands, or an open one that has ended from its start."""

    def wish(state: State) -> State:
        path = path_of(state.robot, state.request.course)
        ended = state.request.path_s >= path.duration and not path.is_closed
        s = 0.0 if ended else state.request.path_s
        return commanded(state, Along(path, s, playing=True, title=title_of(state.robot, state.request.course)))

    return driven(wish)


def pause() -> Update:
    """Stay at this place of the path."""

    def wish(state: State) -> State:
        if not isinstance(state.request.command, Along):
            return state
        return commanded(state, replace(state.request.command, playing=False))

    return driven(wish)


def scrub(share: float) -> Update:
    """Another place of the path, as a share of its time, 0 to 1; playing goes on from there."""

    def wish(state: State) -> State:
        (value,) = finite([share], (1,))
        if not 0.0 <= value <= 1.0:
            raise HelicoideError(
                Text(
                    en="A place on the path is 0 to 100 % of its time.",
                    pt_BR="Um ponto da trajetória fica entre 0 e 100 % do seu tempo.",
                )
            )
        path = path_of(state.robot, state.request.course)
        s = float(value) * path.duration
        playing = isinstance(state.request.command, Along) and state.request.command.playing
        title = title_of(state.robot, state.request.course)
        return commanded(
            replace(state, request=replace(state.request, path_s=s)), Along(path, s, playing=playing, title=title)
        )

    return driven(wish)


def choose_path(name: str) -> Update:
    """Another path of `presets`, from its start and in its own time; an arm that follows a path stops."""
    return driven(lambda state: _from_start(state, replace(state.request.course, name=name, duration=None)))


def choose_scaling(shape: Shape) -> Update:
    """Another time scaling of the path, from its start; an arm that follows a path stops."""
    return driven(lambda state: _from_start(state, replace(state.request.course, shape=shape)))


def set_duration(seconds: float) -> Update:
    """How long the path takes; an arm that follows it goes on from where it is, slower or faster."""

    def wish(state: State) -> State:
        (value,) = finite([seconds], (1,))
        request = state.request
        course = replace(request.course, duration=float(value))
        before, after = path_of(state.robot, request.course), path_of(state.robot, course)
        s, command = request.path_s * after.duration / before.duration, request.command
        if isinstance(command, Along):
            command = replace(command, path=after, s=s)
        return replace(state, request=replace(request, command=command, course=course, path_s=s), notice=None)

    return driven(wish)


def _from_start(state: State, course: Course) -> State:
    path_of(state.robot, course)
    state = replace(state, request=replace(state.request, course=course, path_s=0.0), notice=None)
    return commanded(state, Hold()) if isinstance(state.request.command, Along) else state
