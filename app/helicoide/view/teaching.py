"""Rows for teaching by showing: record where the arm stands, put the points in order, go through them."""

from __future__ import annotations

from collections.abc import Sequence

from viser import Icon

from helicoide import gate
from helicoide.text import Text
from helicoide.trajectory.waypoint_file import encoded
from helicoide.trajectory.waypoints import WAYS, Way
from helicoide.view.rows import Button, Changing, Entry, Folder, ForArm, PlayTaught, Row, Save, Upload, View

FILE = "waypoints.toml"


def teaching_rows() -> Folder:
    """Record in each way of coming there, the points themselves, and what can be done with all of them."""
    rows: list[Row] = [
        *map(_record, WAYS),
        Folder(Text(en="Points", pt_BR="Pontos"), Changing(_names, _points)),
        Button(
            lambda _: Text(en="Go through the points", pt_BR="Percorrer os pontos"),
            lambda _: PlayTaught(),
            Icon.PLAYER_PLAY,
            lambda view: bool(view.state.waypoints) and not view.state.parked,
        ),
        Button(
            lambda _: Text(en="Save the points", pt_BR="Salvar os pontos"),
            lambda view: Save(FILE, encoded(view.state.taught)),
            Icon.DOWNLOAD,
            lambda view: bool(view.state.waypoints),
        ),
        Upload(
            Text(en="Load points", pt_BR="Carregar pontos"), lambda _, content: ForArm(gate.take_waypoints(content))
        ),
    ]
    return Folder(Text(en="Teach a path", pt_BR="Ensinar uma trajetória"), rows, open=False)


def _record(way: Way) -> Button:
    label = Text(en="Record, by: {way}", pt_BR="Gravar, por: {way}").format(way=WAYS[way])
    return Button(lambda _: label, lambda _: ForArm(gate.record(way)), Icon.PLUS)


def _names(view: View) -> str:
    return "\n".join(waypoint.name for waypoint in view.state.waypoints)


def _points(names: str) -> Sequence[Row]:
    listed = names.split("\n") if names else []
    return [row for place, name in enumerate(listed) for row in _point(place, name)]


def _point(place: int, name: str) -> list[Row]:
    earlier = Text(en="{name}: one place earlier", pt_BR="{name}: uma posição antes").format(name=name)
    away = Text(en="{name}: take away", pt_BR="{name}: tirar").format(name=name)
    return [
        Entry(
            Text(en="point {n}", pt_BR="ponto {n}").format(n=place + 1),
            lambda _: name,
            Text(en="Rename", pt_BR="Renomear"),
            lambda typed: ForArm(gate.rename_waypoint(name, typed)),
        ),
        *(
            [Button(lambda _: earlier, lambda _: ForArm(gate.move_waypoint(name, place - 1)), Icon.ARROW_UP)]
            if place
            else []
        ),
        Button(lambda _: away, lambda _: ForArm(gate.delete_waypoint(name)), Icon.TRASH),
    ]
