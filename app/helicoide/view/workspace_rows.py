"""The map of the workspace: its rows, its notes and its colour scale."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from markupsafe import Markup
from numpy.typing import NDArray
from viser import Icon

from helicoide import gate
from helicoide.arrays import Array
from helicoide.kinematics.grid import Counts
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.workspace import MAP_KINDS, MapKind, WorkspaceMap, fixed_tool_text, plane_normal
from helicoide.text import Text, number_text, rounded_text, significant_text, untranslated
from helicoide.view import html
from helicoide.view.requests import CountMap, ForArm, ForSeat
from helicoide.view.rows import Bar, Button, Dropdown, Folder, HtmlRow, Row, Slider
from helicoide.view.window_view import View

# From low to high, each lighter than the one before, so that they differ without colour vision too.
ANCHORS = np.array([(59, 28, 110), (49, 94, 160), (30, 148, 139), (118, 196, 88), (250, 222, 60)], dtype=np.float64)

TITLES: dict[MapKind, Text] = {
    "reachable": Text(en="Reachable positions", pt_BR="Posições alcançáveis"),
    "dexterous": Text(en="Dexterity", pt_BR="Destreza"),
    "manipulability": Text(en="Manipulability", pt_BR="Manipulabilidade"),
}
ABOUT: dict[MapKind, Text] = {
    "reachable": Text(
        en="Positions that the end effector can reach, sampled with random postures within the joint limits.",
        pt_BR="Posições que o efetuador alcança, amostradas com posturas aleatórias dentro dos limites das juntas.",
    ),
    "dexterous": Text(
        en="Share of all orientations that the end effector can take at each position.",
        pt_BR="Parcela de todas as orientações que o efetuador assume em cada posição.",
    ),
    "manipulability": Text(
        en="Largest manipulability w found at each position.",
        pt_BR="Maior manipulabilidade w encontrada em cada posição.",
    ),
}
COUNT = Text(en="Compute map", pt_BR="Calcular mapa")
END = Text(en="End calculation", pt_BR="Encerrar o cálculo")
CLEAR = Text(en="Remove map", pt_BR="Remover mapa")
COUNTED = Text(en="{title}: computing.", pt_BR="{title}: calculando.")
FOUND = Text(
    en="{title}: {measure} reached by {samples} postures, in cells of {size:.0f} mm.",
    pt_BR="{title}: {measure} com {samples} posturas, em células de {size:.0f} mm.",
)
HEIGHT = Text(en="height above the base frame [mm]", pt_BR="altura sobre o referencial da base [mm]")
DISTANCE = Text(en="distance from the first axis [mm]", pt_BR="distância ao primeiro eixo [mm]")
NIMBLENESS = Text(en="manipulability w{unit}", pt_BR="manipulabilidade w{unit}")
CUT = Text(en="Cut [% of the reach]", pt_BR="Corte [% do alcance]")
SHARE = Text(en="share of all orientations [%]", pt_BR="parcela de todas as orientações [%]")


@dataclass(frozen=True)
class Scale:
    """The colour scale of a map, from the least to the greatest value."""

    title: Text
    least: float
    greatest: float

    def colours(self, values: Array) -> NDArray[np.uint8]:
        """The colours (k, 3) of values (k,)."""
        return colours((values - self.least) / max(self.greatest - self.least, 1e-12))


def colours(shares: Array) -> NDArray[np.uint8]:
    """The colours (k, 3) of shares (k,), from 0, dark, to 1, light."""
    steps = np.linspace(0.0, 1.0, len(ANCHORS))
    return np.stack([np.interp(shares, steps, channel) for channel in ANCHORS.T], axis=-1).round().astype(np.uint8)


def middles(found: WorkspaceMap, steps: Counts | Array) -> Array:
    """The centres (k, 3), m, base frame, of the cells with the indices `steps` (k, d)."""
    return np.asarray(found.cells.origin + found.cells.size * (steps + 0.5) @ found.cells.axes)


def values(found: WorkspaceMap, steps: Counts) -> Array:
    """The values (k,) that colour the cells with the indices `steps` (k, d), in the unit of the scale.

    A reachable map has no values: its cells are coloured by a length that shows the shape, which is the height, or for
    an arm in a plane the distance from the centre.
    """
    match found.kind, len(found.cells.shape):
        case "reachable", 3:
            return 1000 * middles(found, steps)[:, 2]
        case "reachable", _:
            return np.asarray(
                1000 * found.cells.size * np.linalg.norm(steps + 0.5 - np.array(found.cells.shape) / 2, axis=1)
            )
        case kind, _:
            there = found.values.reshape(found.cells.shape)[tuple(steps.T)]
            return np.asarray(there * (100.0 if kind == "dexterous" else 1.0))


@lru_cache(maxsize=4)
def scale(found: WorkspaceMap, slides: bool) -> Scale:
    """The colour scale of a map. slides: whether the arm has prismatic joints, so that w has no single unit."""
    there = values(found, np.argwhere(found.reached.reshape(found.cells.shape)))
    d = len(found.cells.shape)
    title = {
        "reachable": HEIGHT if d == 3 else DISTANCE,
        "dexterous": SHARE,
        "manipulability": NIMBLENESS.format(unit="" if slides else " [m³]" if d == 3 else " [m²]"),
    }[found.kind]
    return Scale(title, float(there.min()), float(there.max()))


def scale_of(robot: Robot, found: WorkspaceMap) -> Scale:
    """The colour scale of a map of an arm."""
    return scale(found, any(joint.is_prismatic for joint in robot.joints))


def workspace_rows(robot: Robot) -> Folder:
    """All rows about the workspace of an arm. The map of an arm that moves in a plane has no cut."""
    rows: list[Row] = [
        Dropdown(
            Text(en="Map", pt_BR="Mapa"),
            [(kind, TITLES[kind]) for kind in MAP_KINDS],
            lambda view: view.seat.map_kind,
            lambda kind: ForSeat(gate.choose_map(kind)),
        ),
        HtmlRow(_about),
        Button(
            lambda view: END if _counting(view) else COUNT,
            lambda view: ForArm(gate.end_map()) if _counting(view) else CountMap(view.seat.map_kind),
            Icon.MAP_2,
        ),
        Bar(_share),
        HtmlRow(_found),
        *([_cut()] if plane_normal(robot) is None else []),
        Button(lambda _: CLEAR, lambda _: ForArm(gate.clear_map()), Icon.TRASH, shown=_has_map, weight="destructive"),
    ]
    return Folder(Text(en="Workspace", pt_BR="Espaço de trabalho"), rows, open=False)


def _cut() -> Slider:
    return Slider(
        CUT, -100.0, 100.0, 1.0, lambda view: 100 * view.seat.cut, lambda share: ForSeat(gate.cut_map(share / 100))
    )


def _counting(view: View) -> bool:
    return view.state.workspace.progress is not None


def _share(view: View) -> float | None:
    counting = view.state.workspace.progress
    return None if counting is None else counting.share


def _has_map(view: View) -> bool:
    return view.state.workspace.map is not None


def _about(view: View) -> Markup:
    """What the chosen map shows, or which map is being computed, whoever asked for it."""
    counting, language = view.state.workspace.progress, view.seat.language
    if counting is None:
        return html.note(ABOUT[view.seat.map_kind][language])
    return html.note(COUNTED.format(title=TITLES[counting.kind])[language])


def _found(view: View) -> Markup:
    """The total of the map, and what its colours mean."""
    found, language = view.state.workspace.map, view.seat.language
    if found is None:
        return Markup("")
    robot, title = view.state.robot, TITLES[found.kind]
    if robot.fixed_tool_point:
        words = untranslated("{stays}.").format(stays=fixed_tool_text(robot, title))
    else:
        samples = f"{found.samples:,}".replace(",", "\u202f")
        words = FOUND.format(title=title, measure=measure_title(found), samples=samples, size=1000 * found.cells.size)
    said = scale_of(robot, found)
    stops = ", ".join(f"rgb({r} {g} {b})" for r, g, b in ANCHORS.astype(int))
    return Markup(
        "<div class='helicoide-note'>{}<div class='helicoide-scale'>{}"
        "<i style='background: linear-gradient(to right, {})'></i><b>{}</b><b>{}</b></div></div>"
    ).format(
        words[language],
        said.title[language],
        stops,
        _number(found, said.least)[language],
        _number(found, said.greatest)[language],
    )


def measure_title(found: WorkspaceMap) -> Text:
    """The reachable volume in litres or m³, or the area in cm² or m²."""
    flat = len(found.cells.shape) == 2
    large, small, parts = ("m²", "cm²", 1e4) if flat else ("m³", "L", 1e3)
    value, unit = (found.measure, large) if found.measure >= 1.0 else (parts * found.measure, small)
    decimals = 2 if value < 10 else 1 if value < 100 else 0
    return untranslated("{value} {unit}").format(value=number_text(value, f".{decimals}f"), unit=unit)


def _number(found: WorkspaceMap, value: float) -> Text:
    return significant_text(value, 3) if found.kind == "manipulability" else rounded_text(value, 0)
