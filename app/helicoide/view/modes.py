"""A table of the modes of a filtered inverse, one line for each singular value."""

from __future__ import annotations

import numpy as np
from markupsafe import Markup

from helicoide.ik.modal import ModalDiagnosis
from helicoide.readout import method_modes
from helicoide.text import Language, Text, untranslated
from helicoide.view import html
from helicoide.view.formula import formula_html
from helicoide.view.window_view import View

MODES = Text(en="Modes of Θ", pt_BR="Modos de Θ")
NONE = Text(
    en="The modes appear once a filtered inverse drives the arm to a target.",
    pt_BR="Os modos aparecem quando uma inversa filtrada leva o braço a um alvo.",
)
ABOUT = Text(
    en="In the singular vectors of J (Vargas 2013, §4.4), Θ has diagonal terms dᵢ and residuals rᵢⱼ. dᵢ converges to "
    "1/σᵢ, so that σᵢdᵢ converges to 1. The residuals converge to 0. τᵢ is the time constant in seconds; it is large "
    "where σᵢ is small.",
    pt_BR="Nos vetores singulares de J (Vargas 2013, §4.4), Θ tem termos diagonais dᵢ e resíduos rᵢⱼ. dᵢ converge "
    "para 1/σᵢ, de modo que σᵢdᵢ converge para 1. Os resíduos convergem para 0. τᵢ é a constante de tempo em "
    "segundos; ela é grande onde σᵢ é pequeno.",
)
LEFT = Text(
    en="Residuals ‖R‖ = {R:.3g}; V_c = {V:.3g}, lower bound {floor:.3g} in this posture.",
    pt_BR="Resíduos ‖R‖ = {R:.3g}; V_c = {V:.3g}, limite inferior {floor:.3g} nesta postura.",
)
TABLE = Markup("<table class='helicoide-instruments'><tr><th></th>{}</tr>{}</table>")
NUMBER = untranslated("{value:.3g}")
HEAD = Markup("").join(
    Markup("<th>{}</th>").format(formula_html(symbol)) for symbol in (r"\sigma_i", r"d_i", r"\sigma_i d_i", r"\tau_i")
)
LINE = Markup("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>")


def mode_table(view: View) -> Markup:
    """A table with σᵢ, dᵢ, σᵢdᵢ and τᵢ of each mode, and below it ‖R‖ and V_c."""
    language, found = view.seat.language, method_modes(view.state)
    if found is None:
        return html.note(NONE[language])
    left = LEFT.format(R=float(np.linalg.norm(found.R)), V=found.V_c, floor=found.floor)
    return html.note(ABOUT[language]) + _table(found, language) + html.note(left[language])


def _table(found: ModalDiagnosis, language: Language) -> Markup:
    with np.errstate(divide="ignore"):
        times = 1 / found.rates.diagonal()
    lines = (
        LINE.format(i + 1, *(NUMBER.format(value=float(value))[language] for value in (sigma, d, sigma * d, time)))
        for i, (sigma, d, time) in enumerate(zip(found.sigma, found.d, times, strict=True))
    )
    return TABLE.format(HEAD, Markup("").join(lines))
