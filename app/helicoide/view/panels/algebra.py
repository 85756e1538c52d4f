"""The current multivectors of the scene: all of them in a list, and one that is chosen and highlighted."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache, partial

from markupsafe import Markup
from viser import Icon

from helicoide import readout
from helicoide.ik import Contact
from helicoide.kinematics.robot import Robot
from helicoide.readout import Reading
from helicoide.state import State
from helicoide.text import Language, Text, number_text
from helicoide.view import html
from helicoide.view.console_rows import console_rows
from helicoide.view.formula import coefficient_grid, formula_html
from helicoide.view.rows import Dropdown, Folder, ForSeat, HtmlRow, Row, View
from helicoide.view.stage_rows import stage_rows

TITLE = Text(en="Algebra", pt_BR="Álgebra")
ORDER = 2
ICON = Icon.MATH_FUNCTION

NOTHING = Text(en="none", pt_BR="nenhum")
INTRODUCTION = Text(
    en="All values are multivectors of Cl(0,3,1): e₁, e₂ and e₃ square to −1, e to 0. Lengths are in metres.",
    pt_BR="Todos os valores são multivetores de Cl(0,3,1): e₁, e₂ e e₃ têm quadrado −1; o gerador e, 0. Comprimentos "
    "em metros.",
)
DISTANCE = Text(en="Distance point–plane (eq. 20)", pt_BR="Distância ponto–plano (eq. 20)")
BETWEEN = Text(en="{point} and plane {name} ({pane})", pt_BR="{point} e plano {name} ({pane})")
GRADES = (
    Text(en="scalar", pt_BR="escalar"),
    Text(en="vector", pt_BR="vetor"),
    Text(en="bivector", pt_BR="bivetor"),
    Text(en="trivector", pt_BR="trivetor"),
    Text(en="pseudoscalar", pt_BR="pseudoescalar"),
)


def rows(robot: Robot) -> list[Row]:
    """The panel for one robot."""
    return [
        HtmlRow(lambda view: html.note(INTRODUCTION[view.seat.language]) + _legend(view)),
        Dropdown(
            Text(en="Highlight", pt_BR="Destacar"),
            lambda view: [("", NOTHING), *((one.key, one.title) for one in readout.readings(view.state))],
            lambda view: _key(view) or "",
            lambda key: ForSeat(lambda seat: replace(seat, selected=key or None)),
        ),
        HtmlRow(_selected, computed=True),
        *([Folder(DISTANCE, [HtmlRow(_distance, computed=True)])] if robot.panes else []),
        *(
            Folder(title, [HtmlRow(partial(_all, kind), computed=True)], open=kind == "tool")
            for kind, title in KINDS.items()
            if robot.panes or kind != "plane"
        ),
        console_rows(),
        stage_rows(),
    ]


KINDS = {
    "tool": Text(en="End-effector motor", pt_BR="Motor do efetuador"),
    "joint": Text(en="Joint screw axes", pt_BR="Eixos helicoidais das juntas"),
    "plane": Text(en="Planes", pt_BR="Planos"),
    "point": Text(en="Monitored points", pt_BR="Pontos monitorados"),
}
FORMULAS = {
    "tool": r"M = g + \tfrac{1}{2}\, t\, g\, e",
    "joint": r"\ell = v_x e_2e_3 + v_y e_3e_1 + v_z e_1e_2 + u_x e_1e + u_y e_2e + u_z e_3e",
    "plane": r"\pi = n_x e_1 + n_y e_2 + n_z e_3 + d\, e",
    "point": r"p = e_1e_2e_3 + x\, e_2e_3e + y\, e_3e_1e + z\, e_1e_2e",
}

SAID = {kind: formula_html(formula) for kind, formula in FORMULAS.items()}
READING = Markup('<div class="helicoide-reading"><header>%s</header>%s</div>')


def _legend(view: View) -> Markup:
    names = (Markup('<i class="g{}">{}</i>').format(k, name[view.seat.language]) for k, name in enumerate(GRADES))
    return Markup('<p class="helicoide-legend">{}</p>').format(Markup(" ").join(names))


def _shown(view: View, reading: Reading) -> Markup:
    return READING % (
        _header(reading, view.seat.language),
        coefficient_grid(reading.at(view.state), view.seat.language),
    )


@lru_cache(maxsize=1024)  # panels need it several times a second, and it does not change
def _header(reading: Reading, language: Language) -> Markup:
    return Markup("{}<span>{}</span>").format(formula_html(reading.symbol, reading.index), reading.title[language])


def _key(view: View) -> str | None:
    """The key of the highlighted multivector; None if it does not exist any more."""
    reading = readout.chosen_reading(view.state, view.seat.selected)
    return None if reading is None else reading.key


def _selected(view: View) -> Markup:
    reading = readout.chosen_reading(view.state, view.seat.selected)
    if reading is None:
        return Markup("")
    return Markup('<div class="helicoide-lit">{}</div>').format(_shown(view, reading))


def _all(kind: str, view: View) -> Markup:
    readings = [reading for reading in readout.readings(view.state) if reading.key.startswith(kind)]
    return SAID[kind] + Markup("").join(_shown(view, reading) for reading in readings)


def _pair(view: View) -> Contact:
    """The point and the plane of the distance: the highlighted one and the one nearest to it, or the nearest pair."""
    kind, _, number = (_key(view) or "").partition(" ")
    table = readout.plane_distances(view.state)
    if kind == "plane":
        return Contact(int(number), int(table[:, int(number)].argmin()))
    if kind == "point":
        return Contact(int(table[int(number)].argmin()), int(number))
    return readout.nearest_point_and_plane(view.state)


def _distance(view: View) -> Markup:
    state: State = view.state
    pair = _pair(view)
    pane, point = state.problem.planes.panes[pair.plane], state.robot.monitored[pair.point]
    product, language = readout.distance_product(state, pair.point, pair.plane), view.seat.language
    pair_said = BETWEEN.format(point=point.title, name=pane.name, pane=pane.title)[language]
    return formula_html(r"\ell = \tfrac{1}{2}\star(\pi p - p\pi),\quad \pi p - p\pi = 2\ell\, e_1e_2e_3e") + Markup(
        '<div class="helicoide-reading"><p>{}: <b>{} mm</b></p>{}</div>'
    ).format(pair_said, number_text(500 * product[-1], ".1f")[language], coefficient_grid(product, language))
