"""The Algebra tab: the inspected object in all its forms, and the current multivectors of the scene."""

from __future__ import annotations

from functools import partial

from markupsafe import Markup
from viser import Icon

from helicoide import readout
from helicoide.arrays import Array
from helicoide.ik import Contact
from helicoide.kinematics.robot import Robot
from helicoide.readout import Nature
from helicoide.readout.shared_meanings import SharedMeaning
from helicoide.seat import Notation, Selection, SelectionKind, ShownAlgebra
from helicoide.state import State
from helicoide.text import Language, Text, number_text
from helicoide.view import html
from helicoide.view.code_rows import code_rows
from helicoide.view.console_rows import console_rows
from helicoide.view.formula import ZERO, blade_words, coefficient, coefficient_grid, formula_html, general_formula
from helicoide.view.inspector_rows import highlight_row, inspected, inspector_rows, shown
from helicoide.view.notation_rows import notation_rows
from helicoide.view.playground_rows import playground_rows
from helicoide.view.pose_form_rows import pose_form_rows
from helicoide.view.rows import Folder, HtmlRow, Row
from helicoide.view.stage_rows import stage_rows
from helicoide.view.term_rows import term_rows
from helicoide.view.window_view import View

TITLE = Text(en="Algebra", pt_BR="Álgebra")
ORDER = 2
ICON = Icon.MATH_FUNCTION

INTRODUCTION: dict[ShownAlgebra, Text] = {
    "Cl(0,3,1)": Text(
        en="All values are multivectors of Cl(0,3,1): e₁, e₂ and e₃ square to −1, {null} to 0. Lengths are in metres.",
        pt_BR="Todos os valores são multivetores de Cl(0,3,1): e₁, e₂ e e₃ têm quadrado −1, e {null} tem quadrado 0. "
        "Comprimentos em metros.",
    ),
    "Cl(3,0,1)": Text(
        en="All values are multivectors of Cl(3,0,1): e₁, e₂ and e₃ square to 1, {null} to 0. Lengths are in metres.",
        pt_BR="Todos os valores são multivetores de Cl(3,0,1): e₁, e₂ e e₃ têm quadrado 1, e {null} tem quadrado 0. "
        "Comprimentos em metros.",
    ),
}
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
        HtmlRow(_legend),
        highlight_row(),
        *inspector_rows(),
        Folder(MEANINGS, [HtmlRow(_meanings, computed=True)], open=False),
        pose_form_rows(),
        term_rows(),
        code_rows(),
        notation_rows(),
        console_rows(),
        playground_rows(),
        *([Folder(DISTANCE, [HtmlRow(_distance, computed=True)])] if robot.panes else []),
        *(
            Folder(title, [HtmlRow(partial(_all, kind), computed=True)], open=kind == "tool")
            for kind, title in KINDS.items()
            if robot.panes or kind != "plane"
        ),
        stage_rows(),
    ]


MEANINGS = Text(en="What the numbers mean", pt_BR="O que os números significam")
KINDS: dict[SelectionKind, Text] = {
    "tool": Text(en="End-effector motor", pt_BR="Motor do efetuador"),
    "joint": Text(en="Joint screw axes", pt_BR="Eixos helicoidais das juntas"),
    "plane": Text(en="Planes", pt_BR="Planos"),
    "point": Text(en="Monitored points", pt_BR="Pontos monitorados"),
}
OPPOSITE = Text(
    en="{said} In this notation the sign of {names} is opposite.",
    pt_BR="{said} Nesta notação o sinal de {names} é o oposto.",
)
NATURES: dict[SelectionKind, Nature] = {"tool": "motor", "joint": "line", "plane": "plane", "point": "point"}


def _legend(view: View) -> Markup:
    language, notation = view.seat.language, view.seat.notation
    null = "e" if notation.naming == "factors" else "e₀"
    said = INTRODUCTION[notation.algebra].format(null=null)[language]
    names = (Markup('<i class="g{}">{}</i>').format(k, name[language]) for k, name in enumerate(GRADES))
    legend = Markup('<p class="helicoide-legend">{}</p>').format(Markup(" ").join(names))
    return html.note(said) + legend


def _meanings(view: View) -> Markup:
    """Each coefficient of the inspected object that is not zero, in words; without an object, the tool's."""
    element = inspected(view) or readout.elements(view.state)[0]
    language, values = view.seat.language, element.values(view.state)
    known = readout.coefficients(element.nature, view.seat.notation)
    present = [one for one in known if abs(values[one.place]) >= ZERO]
    lines = (_meaning(shared, values, language) for shared in readout.shared_meanings(element.nature, values, present))
    first = readout.INTRODUCTION[language] if element.nature == "motor" else ""
    return Markup("<div class='helicoide-note helicoide-meanings'><p>{}</p><ul>{}</ul></div>").format(
        first, Markup("").join(lines)
    )


def _meaning(shared: SharedMeaning, values: Array, language: Language) -> Markup:
    """The coefficients of one meaning with their values, and the meaning."""
    numbers = (
        f"{blade_words(one.name)} = {coefficient(one.sign * float(values[one.place]), language)}"
        for one in shared.coefficients
    )
    opposite = ", ".join(blade_words(one.name) for one in shared.opposite)
    said = OPPOSITE.format(said=shared.text, names=opposite) if opposite else shared.text
    listed = Markup("; ").join(Markup("<b>{}</b>").format(number) for number in numbers)
    return Markup("<li>{} {}</li>").format(listed, said[language])


def _all(kind: SelectionKind, view: View) -> Markup:
    found = [element for element in readout.elements(view.state) if element.selection.kind == kind]
    formula = general_formula(NATURES[kind], view.seat.notation)
    return formula + Markup("").join(shown(view, element) for element in found)


def _pair(view: View) -> Contact:
    """The point and the plane of the distance: the inspected one and the one nearest to it, or the nearest pair."""
    element, table = inspected(view), readout.plane_distances(view.state)
    match None if element is None else element.selection:
        case Selection("plane", k):
            return Contact(k, int(table[:, k].argmin()))
        case Selection("point", j):
            return Contact(int(table[j].argmin()), j)
        case _:
            return readout.nearest_point_and_plane(view.state)


def _distance(view: View) -> Markup:
    state: State = view.state
    pair = _pair(view)
    pane, point = state.problem.planes.panes[pair.plane], state.robot.monitored[pair.point]
    product, language = readout.distance_product(state, pair.point, pair.plane), view.seat.language
    known = readout.coefficients("point", Notation(naming=view.seat.notation.naming))
    pair_said = BETWEEN.format(point=point.title, name=pane.name, pane=pane.title)[language]
    return formula_html(r"\ell = \tfrac{1}{2}\star(\pi p - p\pi),\quad \pi p - p\pi = 2\ell\, e_1e_2e_3e") + Markup(
        '<div class="helicoide-reading"><p>{}: <b>{} mm</b></p>{}</div>'
    ).format(pair_said, number_text(500 * product[-1], ".1f")[language], coefficient_grid(product, known, language))
