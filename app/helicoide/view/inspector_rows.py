"""The inspected object: its multivector, what a coefficient of it means, and a field to change it by a number."""

from __future__ import annotations

import math
from collections.abc import Callable, Hashable, Sequence
from dataclasses import replace
from functools import lru_cache

from markupsafe import Markup

from helicoide import gate, readout
from helicoide.readout import Coefficient, Element, Nature
from helicoide.seat import Notation, Selection, SelectionKind
from helicoide.text import HelicoideError, Language, Text, untranslated
from helicoide.view import html
from helicoide.view.formula import blade_words, coefficient_grid, formula_html, general_formula, sum_of_blades
from helicoide.view.requests import ForArm, ForSeat, PageRequest
from helicoide.view.rows import DependentRows, Dropdown, Folder, HtmlRow, Row, TextEntry
from helicoide.view.window_view import View

NOTHING = Text(en="none", pt_BR="nenhum")
CHOOSE = Text(
    en="Click an object in the scene, or choose it in “Highlight”.",
    pt_BR="Clique em um objeto na cena ou escolha-o em “Destacar”.",
)
COPY = Text(en="Copy exact coefficients", pt_BR="Copiar os coeficientes exatos")
COPIED = Text(en="Copied", pt_BR="Copiado")
CHANGE = Text(en="Change it", pt_BR="Mudar")
JOINT = Text(en="Joint value", pt_BR="Valor da junta")
SET = Text(en="Set", pt_BR="Aplicar")
NEW_VALUE = Text(en="New value of {blade}", pt_BR="Novo valor de {blade}")
NEW_LENGTH = Text(en="New value of {blade} [m]", pt_BR="Novo valor de {blade} [m]")
NEW_SCALAR = Text(en="New value of the scalar", pt_BR="Novo valor do escalar")
JOINT_VALUE = Text(en="New value of joint {n} [{unit}]", pt_BR="Novo valor da junta {n} [{unit}]")
NO_NUMBER = Text(en="Enter one number, such as 0.25.", pt_BR="Digite um número, como 0,25.")
FIRST_A_COEFFICIENT = Text(
    en="Choose a coefficient above, then type its new value here.",
    pt_BR="Escolha um coeficiente acima e digite aqui o novo valor.",
)
ZERO_BLADE = Text(
    en="This coefficient is always 0 for this kind of object and cannot be changed.",
    pt_BR="Este coeficiente é sempre 0 para este tipo de objeto e não pode ser mudado.",
)
FIXED_PLANE = Text(
    en="This plane is fixed by the robot's file and cannot be moved.",
    pt_BR="Este plano é fixado pelo arquivo do robô e não pode ser movido.",
)
AXIS_FOLLOWS = Text(
    en="The axis of a joint cannot be moved by itself: it is carried by the links before it. Change joint values "
    "instead.",
    pt_BR="O eixo de uma junta não se move sozinho: os elos anteriores o carregam. Mude valores de juntas.",
)
AXIS_DRIVEN = Text(
    en="This joint follows another one, so its value cannot be set.",
    pt_BR="Esta junta acompanha outra, portanto seu valor não pode ser ajustado.",
)
PATH_FOLLOWS = Text(
    en="This point moves along the path, which the tab Robot sets.",
    pt_BR="Este ponto se move pela trajetória, que a aba Robô define.",
)
READING = Markup('<div class="helicoide-reading"><header>%s</header>%s</div>')
# The natures of the objects that a number can move.
MOVABLE: dict[SelectionKind, Nature] = {"tool": "motor", "target": "motor", "plane": "plane", "entry": "point"}


def highlight_row() -> Dropdown:
    """The choice of the object, for the keyboard; a click in the scene does the same."""
    return Dropdown(
        Text(en="Highlight", pt_BR="Destacar"),
        lambda view: [(None, NOTHING), *((one.selection, one.title) for one in readout.elements(view.state))],
        lambda view: None if (element := inspected(view)) is None else element.selection,
        lambda selection: ForSeat(lambda seat: seat.inspecting(selection)),
    )


def inspector_rows() -> list[Row]:
    """The multivector of the inspected object, the meaning of a coefficient, and the field to change it."""
    return [
        HtmlRow(_selected, computed=True),
        Dropdown(
            Text(en="Coefficient", pt_BR="Coeficiente"),
            _blades,
            lambda view: view.seat.coefficient if inspected(view) else None,
            lambda blade: ForSeat(lambda seat: replace(seat, coefficient=blade)),
        ),
        HtmlRow(_meaning, computed=True),
        Folder(CHANGE, DependentRows(_change_key, _change_rows)),
    ]


def inspected(view: View) -> Element | None:
    """The inspected object; None if there is none."""
    return readout.element_of(view.state, view.seat.selected)


def shown(view: View, element: Element, chosen: str | None = None) -> Markup:
    """An element's symbol, title and grid of coefficients."""
    language, coefficients = view.seat.language, readout.coefficients(element.nature, view.seat.notation)
    return READING % (
        _header(element, language),
        coefficient_grid(element.values(view.state), coefficients, language, chosen),
    )


@lru_cache(maxsize=1024)  # panels need it several times a second, and it does not change
def _header(element: Element, language: Language) -> Markup:
    return Markup("{}<span>{}</span>").format(formula_html(element.symbol, element.index), element.title[language])


def _selected(view: View) -> Markup:
    element = inspected(view)
    if element is None:
        return html.note(CHOOSE[view.seat.language])
    notation, language = view.seat.notation, view.seat.language
    values = element.values(view.state)
    copy = Markup('<button type="button" class="helicoide-copy" data-text="{}" data-done="{}">{}</button>')
    return Markup('<div class="helicoide-lit">{}{}{}{}</div>').format(
        shown(view, element, view.seat.coefficient),
        general_formula(element.nature, notation),
        sum_of_blades(values, readout.coefficients(element.nature, notation), language),
        copy.format(readout.exact_text(element.nature, values, notation), COPIED[language], COPY[language]),
    )


def _blades(view: View) -> Sequence[tuple[Hashable, Text]]:
    element = inspected(view)
    if element is None:
        return [(None, NOTHING)]
    known = readout.coefficients(element.nature, view.seat.notation)
    return [(None, NOTHING), *((one.blade, untranslated(blade_words(one.name))) for one in known)]


def chosen_coefficient(view: View) -> tuple[Element, Coefficient] | None:
    """The inspected object and its chosen coefficient; None if one of them is missing."""
    element = inspected(view)
    if element is None or view.seat.coefficient is None:
        return None
    known = readout.coefficients(element.nature, view.seat.notation)
    return next(((element, one) for one in known if one.blade == view.seat.coefficient), None)


def _meaning(view: View) -> Markup:
    chosen = chosen_coefficient(view)
    if chosen is None:
        element = inspected(view)
        is_motor = element is not None and element.nature == "motor"
        return html.note(readout.INTRODUCTION[view.seat.language]) if is_motor else Markup("")
    element, one = chosen
    said = readout.meaning(element.nature, element.values(view.state), one.blade, one.sign)
    return Markup('<p class="helicoide-note helicoide-meaning"><b>{}</b> {}</p>').format(
        blade_words(one.name), said[view.seat.language]
    )


ChangeKey = tuple[Selection | None, str | None, Notation, Text | None]


def _change_key(view: View) -> ChangeKey:
    """The object, the coefficient, the notation, and why the coefficient cannot be changed."""
    element = inspected(view)
    if element is None:
        return None, None, view.seat.notation, CHOOSE
    return element.selection, view.seat.coefficient, view.seat.notation, _why_fixed(view, element)


def _why_fixed(view: View, element: Element) -> Text | None:
    state, selection = view.state, element.selection
    match selection.kind:
        case "plane" if not state.problem.planes.panes[selection.index].movable:
            return FIXED_PLANE
        case "joint":
            return AXIS_FOLLOWS
        case "path":
            return PATH_FOLLOWS
        case kind if kind not in MOVABLE:
            return gate.FOLLOWS
    if view.seat.coefficient is None:
        return FIRST_A_COEFFICIENT
    return ZERO_BLADE if readout.role_of(element.nature, view.seat.coefficient) is None else None


def _change_rows(key: ChangeKey) -> Sequence[Row]:
    selection, blade, notation, fixed = key
    rows: list[Row] = []
    if fixed is not None:
        rows.append(HtmlRow(lambda view: html.note(fixed[view.seat.language])))
    elif selection is not None and blade is not None:
        rows.append(_coefficient_entry(selection, blade, notation))
    if selection is not None and selection.kind == "joint":
        index = selection.index
        rows.append(Folder(JOINT, DependentRows(lambda view: _joint_key(view, index), _joint_rows)))
    return rows


def _coefficient_entry(selection: Selection, blade: str, notation: Notation) -> TextEntry:
    nature = MOVABLE[selection.kind]
    (one,) = (one for one in readout.coefficients(nature, notation) if one.blade == blade)
    role = readout.role_of(nature, blade)
    metres = role is not None and role.part in ("dual", "slide", "offset", "coordinate")
    label = NEW_SCALAR if one.name == "1" else (NEW_LENGTH if metres else NEW_VALUE).format(blade=blade_words(one.name))
    return TextEntry(
        label,
        lambda _: "",
        SET,
        _number_request(lambda value: ForArm(gate.set_coefficient(selection, blade, one.sign * value))),
    )


def _joint_key(view: View, index: int) -> tuple[int, int | None, bool]:
    """The joint, its variable, and whether it slides; no variable for a joint that follows another one."""
    robot = view.state.robot
    joint = robot.joints[index]
    variable = next((k for k, one in enumerate(robot.variables) if one is joint), None)
    return index, variable, joint.is_prismatic


def _joint_rows(key: tuple[int, int | None, bool]) -> Sequence[Row]:
    index, variable, slides = key
    if variable is None:
        return [HtmlRow(lambda view: html.note(AXIS_DRIVEN[view.seat.language]))]
    scale, unit = (0.001, "mm") if slides else (math.pi / 180, "°")
    label = JOINT_VALUE.format(n=index + 1, unit=unit)
    request = _number_request(lambda value: ForArm(gate.set_joint(variable, scale * value)))
    return [TextEntry(label, lambda _: "", SET, request)]


def _number_request(request: Callable[[float], PageRequest]) -> Callable[[str], PageRequest]:
    """The request for a typed number; anything else is refused in words."""

    def typed(text: str) -> PageRequest:
        try:
            return request(number_typed(text))
        except HelicoideError as refusal:
            return ForArm(gate.say(refusal.text))

    return typed


def number_typed(text: str) -> float:
    """A finite number with a decimal point or comma; raises HelicoideError for anything else."""
    try:
        value = float(text.strip().replace(",", ".").replace("−", "-"))
    except ValueError as error:
        raise HelicoideError(NO_NUMBER) from error
    if not math.isfinite(value):
        raise HelicoideError(NO_NUMBER)
    return value
