"""“Why this number”: the terms of a coefficient of a motor chain, each with its joints in their colours."""

from __future__ import annotations

from collections.abc import Hashable, Iterator, Sequence
from dataclasses import replace

from markupsafe import Markup

from helicoide import readout
from helicoide.readout import Chain, ChainTerms, Term
from helicoide.text import Language, Text, number_text
from helicoide.view import html
from helicoide.view.formula import blade_words, formula_html
from helicoide.view.inspector_rows import chosen_coefficient, inspected
from helicoide.view.requests import ForSeat
from helicoide.view.rows import Dropdown, Folder, HtmlRow
from helicoide.view.settings import NONE
from helicoide.view.window_view import View

TITLE = Text(en="Why this number", pt_BR="Por que este número")
CHOOSE = Text(
    en="Choose the end effector, a link or a frame, and a coefficient of its motor.",
    pt_BR="Escolha o efetuador, um elo ou um referencial e um coeficiente do seu motor.",
)
EXPANDED = Text(
    en="The motor is the product of the joint motors and the frame at zero, M₀. Each factor is cos(θ/2) + sin(θ/2) ℓ, "
    "so the product has a term for each choice of cosine or sine. The coefficient of {blade} is the sum:",
    pt_BR="O motor é o produto dos motores das juntas e do referencial no zero, M₀. Cada fator é cos(θ/2) + sen(θ/2) "
    "ℓ; assim o produto tem um termo para cada escolha de cosseno ou seno. O coeficiente de {blade} é a soma:",
)
TOGETHER = Text(
    en="The first {n} joints are kept as one factor, inside the constants.",
    pt_BR="As primeiras {n} juntas ficam em um só fator, dentro das constantes.",
)
REST = Text(en="{value}  {n} smaller terms", pt_BR="{value}  {n} termos menores")
TOTAL = Text(en="{value}  in all", pt_BR="{value}  ao todo")
NO_TERM = Text(en="All terms are 0.", pt_BR="Todos os termos são 0.")
LIGHT = Text(en="Highlight a joint", pt_BR="Destacar uma junta")
JOINT = Text(en="joint {n} ({joint})", pt_BR="junta {n} ({joint})")
SINE = Text(en="sin", pt_BR="sen")
MOST = 8


def term_rows() -> Folder:
    """The terms, and the choice of a joint that is highlighted in the scene."""
    return Folder(
        TITLE,
        [
            HtmlRow(_why, computed=True),
            Dropdown(
                LIGHT,
                _joints,
                lambda view: view.seat.term_joint if view.seat.term_joint in _numbers_of(view) else None,
                lambda joint: ForSeat(lambda seat: replace(seat, term_joint=joint)),
            ),
        ],
        open=False,
    )


def chain_shown(view: View) -> Chain | None:
    """The product that makes the inspected frame; None if it is not one of the arm."""
    element = inspected(view)
    return None if element is None else readout.chain_of(view.state, element)


def _numbers_of(view: View) -> Sequence[int]:
    element = inspected(view)
    return range(0 if element is None else readout.joints_before(view.state.robot, element.selection))


def _joints(view: View) -> Sequence[tuple[Hashable, Text]]:
    joints = view.state.robot.joints
    return [(None, NONE), *((i, JOINT.format(n=i + 1, joint=joints[i].title)) for i in _numbers_of(view))]


def _why(view: View) -> Markup:
    language, chosen = view.seat.language, chosen_coefficient(view)
    chain = None if chosen is None else chain_shown(view)
    if chosen is None or chain is None:
        return html.note(CHOOSE[language])
    _, one = chosen
    found = readout.chain_terms(chain, one.place)
    written = Markup("<div class='helicoide-note helicoide-terms'>{}<p>{}</p><ol>{}</ol>{}</div>")
    said = EXPANDED.format(blade=blade_words(one.name))[language]
    return written.format(
        formula_html(_product_tex(chain)),
        said,
        Markup("").join(_lines(chain, found, one.sign, language)),
        TOGETHER.format(n=found.together)[language] if found.together else "",
    )


def _product_tex(chain: Chain) -> str:
    n = len(chain.values)
    factors = [
        rf"(1 + \tfrac{{1}}{{2}} x_{{{i + 1}}} s_{{{i + 1}}} e)"
        if joint.is_prismatic
        else rf"e^{{\theta_{{{i + 1}}} \ell_{{{i + 1}}} / 2}}"
        for i, joint in enumerate(chain.robot.joints[:n])
    ]
    return rf"M = {'-' if chain.sign < 0 else ''}{' '.join(factors)}\, M_0"


def _lines(chain: Chain, found: ChainTerms, sign: float, language: Language) -> Iterator[Markup]:
    """The largest terms, the sum of the others, and the total; sign: with which the coefficient is displayed."""
    scale = sign * chain.sign
    if not found.terms:
        yield Markup("<li>{}</li>").format(NO_TERM[language])
    for term in found.terms[:MOST]:
        yield Markup("<li><b>{}</b> = {}{}</li>").format(
            _signed(scale * term.value, language),
            _signed(scale * term.constant, language),
            _factors(chain, term, language),
        )
    rest = found.terms[MOST:]
    if rest:
        value = _signed(scale * sum(term.value for term in rest), language)
        yield Markup("<li>{}</li>").format(REST.format(value=value, n=len(rest))[language])
    if len(found.terms) > 1:
        value = _signed(scale * sum(term.value for term in found.terms), language)
        yield Markup("<li class='total'>{}</li>").format(TOTAL.format(value=value)[language])


def _factors(chain: Chain, term: Term, language: Language) -> Markup:
    """The factors of a term in the order of the joints, each in the colour of its joint."""
    factors: dict[int, str] = {i: f"cos(θ{_below(i)}/2)" for i in term.cosines}
    for i in term.sines:
        slides = chain.robot.joints[i].is_prismatic
        factors[i] = f"x{_below(i)}/2" if slides else f"{SINE[language]}(θ{_below(i)}/2)"
    said = (Markup(' ·\u00a0<span class="joint-{}">{}</span>').format(i % 8, factors[i]) for i in sorted(factors))
    return Markup("").join(said)


def _below(i: int) -> str:
    return blade_words(str(i + 1)) if i else "₁"


def _signed(value: float, language: Language) -> str:
    return number_text(value, "+.4f")[language].replace("-", "−")
