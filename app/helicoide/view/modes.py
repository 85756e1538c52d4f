"""What the filtered inverse has learnt of each singular value, as a table."""

from __future__ import annotations

import numpy as np
from markupsafe import Markup

from helicoide.ik.modal import Diagnosis
from helicoide.readout import modes
from helicoide.text import Language, Text, untranslated
from helicoide.view import html
from helicoide.view.formula import formula_html
from helicoide.view.rows import View

MODES = Text(en="Modes of Θ", pt_BR="Modos de Θ")
NONE = Text(
    en="A filtered inverse has modes, once it drives the arm to a target.",
    pt_BR="Uma inversa filtrada tem modos, assim que leva o braço a um alvo.",
)
ABOUT = Text(
    en="In the axes of J (Vargas 2013, §4.4) Θ is a diagonal dᵢ on its way to 1/σᵢ, so that σᵢdᵢ comes to 1, and "
    "residuals rᵢⱼ on their way to 0. A small σ learns slowly: τ, in seconds, is its time constant.",
    pt_BR="Nos eixos de J (Vargas 2013, §4.4) Θ é uma diagonal dᵢ que vai para 1/σᵢ, de modo que σᵢdᵢ chega a 1, e "
    "resíduos rᵢⱼ que vão para 0. Um σ pequeno aprende devagar: τ, em segundos, é a sua constante de tempo.",
)
LEFT = Text(
    en="Residuals ‖R‖ = {R:.3g}; V_c = {V:.3g}, at least {floor:.3g} with these joints.",
    pt_BR="Resíduos ‖R‖ = {R:.3g}; V_c = {V:.3g}, no mínimo {floor:.3g} com estas juntas.",
)
TABLE = Markup("<table class='helicoide-instruments'><tr><th></th>{}</tr>{}</table>")
NUMBER = untranslated("{value:.3g}")
HEAD = Markup("").join(
    Markup("<th>{}</th>").format(formula_html(symbol)) for symbol in (r"\sigma_i", r"d_i", r"\sigma_i d_i", r"\tau_i")
)
LINE = Markup("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>")


def mode_table(view: View) -> Markup:
    """σᵢ, dᵢ, σᵢdᵢ and the time constant of each mode, and what is left besides."""
    language, found = view.seat.language, modes(view.state)
    if found is None:
        return html.note(NONE[language])
    left = LEFT.format(R=float(np.linalg.norm(found.R)), V=found.V_c, floor=found.floor)
    return html.note(ABOUT[language]) + _table(found, language) + html.note(left[language])


def _table(found: Diagnosis, language: Language) -> Markup:
    with np.errstate(divide="ignore"):
        times = 1 / found.rates.diagonal()
    lines = (
        LINE.format(i + 1, *(NUMBER.format(value=float(value))[language] for value in (sigma, d, sigma * d, time)))
        for i, (sigma, d, time) in enumerate(zip(found.sigma, found.d, times, strict=True))
    )
    return TABLE.format(HEAD, Markup("").join(lines))
