"""Interpretations of Vargas 2013 on which whole simulations depend."""

from __future__ import annotations

from helicoide.studies.study import Interpretation
from helicoide.text import Text


def links(otherwise: Text) -> Interpretation:
    """The link lengths of the planar arm, which the source omits; otherwise: the result with 1, 2, 1."""
    return Interpretation(Text(en="links 2, 1, 1", pt_BR="elos 2; 1; 1"), otherwise)


LINKS = links(Text(en="with 1, 2, 1 it holds too", pt_BR="com 1; 2; 1 também vale"))
EXACT_STEP = Interpretation(
    Text(en="exact step of Θ", pt_BR="passo exato de Θ"),
    Text(
        en="by tab. 4.1, in steps of 0.15 ms, the error of sim. 11 is 0.25 mm as well",
        pt_BR="pela tab. 4.1, em passos de 0,15 ms, o erro da sim. 11 também é 0,25 mm",
    ),
)
EXPONENT = Interpretation(
    Text(en="exponent 1 in eq. 3.11", pt_BR="expoente 1 na eq. 3.11"),
    Text(
        en="with 2 the damped arm reaches 0.71 rad/s in sim. 7, and the damping of sim. 11b goes off at 11.5 s",
        pt_BR="com 2, o braço amortecido chega a 0,71 rad/s na sim. 7, e o amortecimento da sim. 11b sai em 11,5 s",
    ),
)
TRANSPOSE = Interpretation(
    Text(en="Jᵀ in eq. 3.19", pt_BR="Jᵀ na eq. 3.19"),
    Text(
        en="J z is no product with three joints and two coordinates",
        pt_BR="J z não é um produto com três juntas e duas coordenadas",
    ),
)
