"""Rows for the path that the target follows: which path, its time scaling, its duration, the place on it."""

from __future__ import annotations

from collections.abc import Callable

from viser import Icon

from helicoide import gate
from helicoide.command import FollowPath
from helicoide.kinematics.robot import Robot
from helicoide.state import Update
from helicoide.text import Text
from helicoide.trajectory import Path
from helicoide.trajectory.time_optimal import TimingShape
from helicoide.view.requests import ForArm, PlayFastest
from helicoide.view.rows import Button, Dropdown, Folder, Row, Slider
from helicoide.view.window_view import View

PLAY = Text(en="Play", pt_BR="Reproduzir")
PAUSE = Text(en="Pause", pt_BR="Pausar")
PLACE = Text(en="{s:.1f} of {end:g} s [%]", pt_BR="{s:.1f} de {end:g} s [%]")


def path_rows(robot: Robot) -> Folder:
    """Rows to choose, play, time and scrub one of the preset paths of an arm."""
    known = gate.presets(robot)
    rows: list[Row] = [
        Dropdown(
            Text(en="Path", pt_BR="Trajetória"),
            [(key, preset.title) for key, preset in known.items()],
            lambda view: view.state.request.path_choice.name or next(iter(known)),
            lambda key: ForArm(gate.choose_path(key)),
        ),
        Button(
            lambda view: PAUSE if _playing(view) else PLAY,
            lambda view: ForArm(gate.pause() if _playing(view) else gate.play()),
            enabled=_free,
            weight="primary",
        ),
        Slider(
            label=lambda view: PLACE.format(s=view.state.request.path_s, end=_path(view).duration),
            lower=0.0,
            upper=100.0,
            step=0.1,
            value=lambda view: 100 * view.state.request.path_s / _path(view).duration,
            request=lambda percent: ForArm(gate.scrub(percent / 100)),
            enabled=_free,
        ),
        scaling(lambda view: view.state.request.path_choice.shape, gate.choose_scaling),
        Slider(
            Text(en="Duration [s]", pt_BR="Duração [s]"),
            gate.SHORTEST,
            gate.LONGEST,
            1.0,
            lambda view: _path(view).duration,
            lambda seconds: ForArm(gate.set_duration(seconds)),
            _free,
        ),
        Button(
            lambda _: Text(en="Time-optimal", pt_BR="Tempo mínimo"),
            lambda _: PlayFastest(),
            Icon.BOLT,
            _free,
        ),
    ]
    return Folder(Text(en="Path", pt_BR="Trajetória"), rows)


def scaling(shape: Callable[[View], TimingShape], choose: Callable[[TimingShape], Update]) -> Dropdown:
    """The choice of a time scaling."""
    shapes: dict[str, TimingShape] = {shape: shape for shape in gate.LAWS}
    return Dropdown(
        Text(en="Time scaling", pt_BR="Lei de tempo"),
        [(key, title) for key, (title, _) in gate.LAWS.items()],
        shape,
        lambda key: ForArm(choose(shapes[key])),
    )


def _free(view: View) -> bool:
    return not view.state.arm.parked


def _playing(view: View) -> bool:
    return isinstance(view.state.request.command, FollowPath) and view.state.request.command.playing


def _path(view: View) -> Path:
    return gate.path_of(view.state.robot, view.state.request.path_choice)
