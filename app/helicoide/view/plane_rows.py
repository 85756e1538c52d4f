"""Rows for the planes: how to add, measure and remove them, their zones, and files of planes."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np
from markupsafe import Markup
from viser import Icon

from helicoide import gate
from helicoide.arrays import Array
from helicoide.confinement.plane_file import encode_planes
from helicoide.confinement.zones import LEAST_CRITICAL, LEAST_DEPTH, MOST_CRITICAL, MOST_WARNING
from helicoide.kinematics.robot import Robot
from helicoide.perception import realsense
from helicoide.perception.enclosure_reading import PLANE_READINGS, PlaneReading, available_readings
from helicoide.perception.units import TITLES as UNIT_TITLES
from helicoide.perception.units import UNITS
from helicoide.readout import WHY_PRINTED_DIFFERS, printed_planes
from helicoide.state import Update
from helicoide.text import Text
from helicoide.view.layers.cloud import OFF_IT, ON_IT
from helicoide.view.requests import ForArm, ForSeat, PageRequest, ReadCloud, Save, Tour
from helicoide.view.rows import Button, DependentRows, Dropdown, Folder, HtmlRow, Row, Slider, TextEntry, Upload
from helicoide.view.window_view import View

FILE = "planes.toml"
PRINTED = Text(en="As printed in the source", pt_BR="Como impressos na fonte")
NUMBERS = Text(en="Enter {n} numbers separated by spaces.", pt_BR="Digite {n} números separados por espaços.")


def plane_rows(robot: Robot) -> Folder:
    """All rows about the planes of an arm."""
    restore = Text(en="Reset planes", pt_BR="Restaurar planos")
    rows: list[Row] = [
        Button(lambda _: restore, lambda _: ForArm(gate.restore_planes()), Icon.RESTORE, _free, _has(robot.panes)),
        *(_tours() if available_readings(robot) else []),
        HtmlRow(_read),
        *([Folder(PRINTED, [HtmlRow(_printed)], open=False)] if printed_planes(robot) else []),
        Folder(Text(en="Define a plane", pt_BR="Definir um plano"), _given(), open=False),
        Folder(
            Text(en="From a point cloud", pt_BR="De uma nuvem de pontos"),
            [
                _units(),
                *map(_upload, PLANE_READINGS),
                HtmlRow(_legend),
                Button(
                    lambda _: Text(en="Remove clouds", pt_BR="Remover nuvens"),
                    lambda _: ForArm(gate.clear_clouds()),
                    Icon.TRASH,
                    shown=_has_clouds,
                    weight="destructive",
                ),
            ],
            open=False,
        ),
        Folder(Text(en="Distances to planes", pt_BR="Distâncias aos planos"), _zones(), open=False),
        Folder(Text(en="Remove", pt_BR="Remover"), DependentRows(_movable, _removable), open=False),
        Button(lambda _: Text(en="Save planes", pt_BR="Salvar planos"), _save, Icon.DOWNLOAD),
        Upload(
            Text(en="Load planes", pt_BR="Carregar planos"),
            lambda _, name, content: ForArm(gate.take_planes_of(content, name)),
        ),
    ]
    return Folder(Text(en="Planes", pt_BR="Planos"), rows, open=False)


def _tours() -> list[Row]:
    """The tour with the simulated camera, and with the real one where its package is installed."""
    simulated = Text(en="Measure with the camera", pt_BR="Medir com a câmera")
    real = Text(en="Measure with the RealSense", pt_BR="Medir com a RealSense")
    rows: list[Row] = [Button(lambda _: simulated, lambda _: Tour(), Icon.CAMERA, _free)]
    if realsense.installed():
        rows.append(Button(lambda _: real, lambda _: Tour(real=True), Icon.CAMERA, _free))
    return rows


def _has(things: Sequence[object]) -> Callable[[View], bool]:
    return lambda _: bool(things)


def _free(view: View) -> bool:
    return not view.state.arm.parked


def _read(view: View) -> Markup:
    """What the last readings found."""
    line, language = Markup("<li>{}</li>"), view.seat.language
    lines = Markup("").join(line.format(seen.words[language]) for seen in view.state.clouds.values())
    return lines and Markup("<ul class='helicoide-note'>{}</ul>").format(lines)


def _has_clouds(view: View) -> bool:
    return bool(view.state.clouds)


def _legend(view: View) -> Markup:
    """What the colours of the clouds mean."""
    if not view.state.clouds:
        return Markup("")
    marks = ((ON_IT, POINTS_ON[view.seat.language]), (OFF_IT, POINTS_OFF[view.seat.language]))
    rows = (Markup("<li><i style='color: rgb{}'>●</i> {}</li>").format(str(colour), words) for colour, words in marks)
    return Markup("<ul class='helicoide-note'>{}</ul>").format(Markup("").join(rows))


POINTS_ON = Text(en="points on the fitted plane", pt_BR="pontos no plano ajustado")
POINTS_OFF = Text(en="other points", pt_BR="outros pontos")


def _printed(view: View) -> Markup:
    """The planes of the robot's file beside what the source prints, and why the two differ."""
    line, language = Markup("<li>{}</li>"), view.seat.language
    lines = Markup("").join(line.format(said[language]) for said in printed_planes(view.state.robot))
    why = WHY_PRINTED_DIFFERS[language]
    return Markup("<div class='helicoide-note'><ul>{}</ul><p>{}</p></div>").format(lines, why)


def numbers(text: str, count: int) -> list[float] | None:
    """The `count` numbers of a line; None if the line holds anything else."""
    words = text.replace(",", " ").replace(";", " ").split()
    try:
        found = [float(word) for word in words]
    except ValueError:
        return None
    return found if len(found) == count else None


def _typed(count: int, request: Callable[[Array], Update]) -> Callable[[str], PageRequest]:
    def act(text: str) -> PageRequest:
        found = numbers(text, count)
        return ForArm(gate.say(NUMBERS.format(n=count)) if found is None else request(np.array(found)))

    return act


def _given() -> list[Row]:
    put = Text(en="Add", pt_BR="Adicionar")
    return [
        Button(_pick_label, _pick, Icon.POINTER, _free),
        TextEntry(
            Text(en="a b c d: ax + by + cz = d [mm]", pt_BR="a b c d: ax + by + cz = d [mm]"),
            lambda _: "0 0 -1 -600",
            put,
            _typed(4, lambda v: gate.add_plane([*v[:3], v[3] / 1000])),
        ),
        TextEntry(
            Text(en="Three points: x y z each [mm]", pt_BR="Três pontos: x y z de cada um [mm]"),
            lambda _: "500 300 0  700 300 0  500 300 400",
            put,
            _typed(9, lambda v: gate.add_plane_through(v.reshape(3, 3) / 1000)),
        ),
        TextEntry(
            Text(en="Box: two corners, x y z each [mm]", pt_BR="Caixa: dois vértices, x y z de cada um [mm]"),
            lambda _: "200 -320 0  900 320 640",
            Text(en="Add box", pt_BR="Adicionar caixa"),
            _typed(6, lambda v: gate.set_box(v[:3] / 1000, v[3:] / 1000)),
        ),
    ]


PICK = Text(en="Pick three points", pt_BR="Clicar três pontos")
PICKING = Text(en="Point {n} of 3 (press to cancel)", pt_BR="Ponto {n} de 3 (pressione para cancelar)")


def _pick_label(view: View) -> Text:
    picked = view.seat.picked_points
    return PICK if picked is None else PICKING.format(n=len(picked) + 1)


def _pick(view: View) -> PageRequest:
    picked = () if view.seat.picked_points is None else None
    return ForSeat(lambda seat: replace(seat, picked_points=picked))


def _units() -> Dropdown:
    """The unit of a file that does not state its unit."""
    return Dropdown(
        Text(en="Unit of the file", pt_BR="Unidade do arquivo"),
        [("", Text(en="automatic", pt_BR="automática")), *((unit, UNIT_TITLES[unit]) for unit in UNITS)],
        lambda view: view.seat.cloud_unit,
        lambda unit: ForSeat(lambda seat: replace(seat, cloud_unit=unit if unit in UNITS else "")),
    )


def _upload(reading: PlaneReading) -> Upload:
    def request(view: View, name: str, content: bytes) -> PageRequest:
        unit = next((unit for unit in UNITS if unit == view.seat.cloud_unit), None)
        return ReadCloud(name, content, reading.name, unit)

    return Upload(
        Text(en="Fit to a cloud: {title}", pt_BR="Ajustar a uma nuvem: {title}").format(title=reading.title), request
    )


def _zones() -> list[Row]:
    def critical(mm: float) -> PageRequest:
        near = mm / 1000
        return ForArm(lambda state: gate.set_zones(near, max(state.problem.zones.warning, near + LEAST_DEPTH))(state))

    def warning(mm: float) -> PageRequest:
        return ForArm(lambda state: gate.set_zones(state.problem.zones.critical, mm / 1000)(state))

    return [
        Slider(
            Text(en="Safety distance [mm]", pt_BR="Distância de segurança [mm]"),
            1000 * LEAST_CRITICAL,
            1000 * MOST_CRITICAL,
            1.0,
            lambda view: 1000 * view.state.problem.zones.critical,
            critical,
        ),
        Slider(
            Text(en="Warning distance [mm]", pt_BR="Distância de aviso [mm]"),
            1000 * (LEAST_CRITICAL + LEAST_DEPTH),
            1000 * MOST_WARNING,
            1.0,
            lambda view: 1000 * view.state.problem.zones.warning,
            warning,
        ),
    ]


def _movable(view: View) -> tuple[tuple[int, str], ...]:
    """The number and the name of each plane that can be removed."""
    return tuple((k, pane.name) for k, pane in enumerate(view.state.problem.planes.panes) if pane.movable)


def _removable(planes: tuple[tuple[int, str], ...]) -> list[Row]:
    return [_remove(k, name) for k, name in planes]


def _remove(index: int, name: str) -> Button:
    label = Text(en="Remove plane {name}", pt_BR="Remover o plano {name}").format(name=name)
    return Button(lambda _: label, lambda _: ForArm(gate.remove_plane(index)), Icon.TRASH, _free, weight="destructive")


def _save(view: View) -> Save:
    planes = view.state.problem.planes
    return Save(FILE, encode_planes(planes.names, planes).encode())
