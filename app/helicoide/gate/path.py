"""The path that the target follows."""

from __future__ import annotations

from dataclasses import replace

from helicoide.gate.check import LATCH, driven, finite
from helicoide.state import PATH, Along, State, Update, commanded
from helicoide.text import HelicoideError, Text


def play() -> Update:
    """Follow the path from where its parameter stands."""
    return driven(lambda state: commanded(state, Along(PATH, state.path_s, playing=True)))


def pause() -> Update:
    """Stay at this place of the path."""

    def wish(state: State) -> State:
        if not isinstance(state.command, Along):
            return state
        return commanded(state, replace(state.command, playing=False))

    return driven(wish)


def scrub(s: float) -> Update:
    """Another place of the path, in seconds from its start; playing goes on from there."""

    def wish(state: State) -> State:
        if state.t < state.latched:
            return replace(state, latched=state.t + LATCH)
        (value,) = finite([s], (1,))
        if not 0.0 <= value <= PATH.duration:
            raise HelicoideError(
                Text(en="The path takes 0 to {end:g} s.", pt_BR="A trajetória aceita de 0 a {end:g} s.").format(
                    end=PATH.duration
                )
            )
        playing = isinstance(state.command, Along) and state.command.playing
        return commanded(replace(state, path_s=value), Along(PATH, value, playing=playing))

    return driven(wish)
