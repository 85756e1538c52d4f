"""The path that the target follows: its choice, its time scaling and duration, and the place on it."""

from __future__ import annotations

from dataclasses import replace

from helicoide.command import FollowPath, HoldPosition, PathChoice
from helicoide.gate.check import driven, finite
from helicoide.gate.presets import path_of, title_of
from helicoide.state import State, Update, with_command
from helicoide.text import HelicoideError, Text
from helicoide.trajectory.time_optimal import TimingShape


def play() -> Update:
    """Follow the path from its present parameter; an open path that has ended restarts."""

    def change(state: State) -> State:
        path = path_of(state.robot, state.request.path_choice)
        ended = state.request.path_s >= path.duration and not path.is_closed
        s = 0.0 if ended else state.request.path_s
        return with_command(
            state, FollowPath(path, s, playing=True, title=title_of(state.robot, state.request.path_choice))
        )

    return driven(change)


def pause() -> Update:
    """Stop at the present place of the path."""

    def change(state: State) -> State:
        if not isinstance(state.request.command, FollowPath):
            return state
        return with_command(state, replace(state.request.command, playing=False))

    return driven(change)


def scrub(share: float) -> Update:
    """Go to a place of the path, a fraction of its duration from 0 to 1. A path that plays continues from there."""

    def change(state: State) -> State:
        (value,) = finite([share], (1,))
        if not 0.0 <= value <= 1.0:
            raise HelicoideError(
                Text(
                    en="The position on the path must be 0 to 100 % of its duration.",
                    pt_BR="A posição na trajetória vai de 0 a 100 % da duração.",
                )
            )
        path = path_of(state.robot, state.request.path_choice)
        s = float(value) * path.duration
        playing = isinstance(state.request.command, FollowPath) and state.request.command.playing
        title = title_of(state.robot, state.request.path_choice)
        return with_command(
            replace(state, request=replace(state.request, path_s=s)), FollowPath(path, s, playing=playing, title=title)
        )

    return driven(change)


def choose_path(name: str) -> Update:
    """Choose a path of `presets`, at its start and with its own duration. An arm that follows a path stops."""
    return driven(lambda state: _from_start(state, replace(state.request.path_choice, name=name, duration=None)))


def choose_scaling(shape: TimingShape) -> Update:
    """Choose the time scaling, at the start of the path. An arm that follows a path stops."""
    return driven(lambda state: _from_start(state, replace(state.request.path_choice, shape=shape)))


def set_duration(seconds: float) -> Update:
    """Set the duration of the path, s. An arm that follows it continues from its place, slower or faster."""

    def change(state: State) -> State:
        (value,) = finite([seconds], (1,))
        request = state.request
        course = replace(request.path_choice, duration=float(value))
        before, after = path_of(state.robot, request.path_choice), path_of(state.robot, course)
        s, command = request.path_s * after.duration / before.duration, request.command
        if isinstance(command, FollowPath):
            command = replace(command, path=after, s=s)
        return replace(state, request=replace(request, command=command, path_choice=course, path_s=s), notice=None)

    return driven(change)


def _from_start(state: State, course: PathChoice) -> State:
    path_of(state.robot, course)
    state = replace(state, request=replace(state.request, path_choice=course, path_s=0.0), notice=None)
    return with_command(state, HoldPosition()) if isinstance(state.request.command, FollowPath) else state
