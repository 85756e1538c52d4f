"""A table of the modes of a filtered inverse, one line for each singular value."""

from __future__ import annotations

import numpy as np
from markupsafe import Markup

from helicoide.ik.modal import ModalDiagnosis
from helicoide.kinematics.manipulability import RANK_TOLERANCE
from helicoide.markup import typeset
from helicoide.readout import method_modes
from helicoide.text import Language, Text, significant_text
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
    en="Residuals ‖R‖ = {R}; V_c = {V}, lower bound {floor} in this posture.",
    pt_BR="Resíduos ‖R‖ = {R}; V_c = {V}, limite inferior {floor} nesta postura.",
)
TABLE = Markup("<table class='helicoide-instruments'><tr><th></th>{}</tr>{}</table>")
DIGITS = 3
HEAD = Markup("").join(
    Markup("<th>{}</th>").format(formula_html(symbol)) for symbol in (r"\sigma_i", r"d_i", r"\sigma_i d_i", r"\tau_i")
)
LINE = Markup("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>")


def mode_table(view: View) -> Markup:
    """A table with σᵢ, dᵢ, σᵢdᵢ and τᵢ of each mode, and below it ‖R‖ and V_c."""
    language, found = view.seat.language, method_modes(view.state)
    if found is None:
        return html.note(NONE[language])
    numbers = {"R": float(np.linalg.norm(found.R)), "V": found.V_c, "floor": found.floor}
    left = LEFT.format(**{name: significant_text(value, DIGITS) for name, value in numbers.items()})
    return html.note(ABOUT[language]) + _table(found, language) + html.note(typeset(left[language]))


def _table(found: ModalDiagnosis, language: Language) -> Markup:
    """The lines of the modes. A σ that is 0 but for rounding is 0, and so is its rate."""
    sigma = np.where(found.sigma > RANK_TOLERANCE * found.sigma[0], found.sigma, 0.0)
    with np.errstate(divide="ignore"):
        times = 1 / np.where(sigma > 0.0, found.rates.diagonal(), 0.0)
    lines = (
        LINE.format(i, *(significant_text(float(value), DIGITS)[language] for value in values))
        for i, values in enumerate(zip(sigma, found.d, sigma * found.d, times, strict=True), 1)
    )
    return TABLE.format(HEAD, Markup("").join(lines))
