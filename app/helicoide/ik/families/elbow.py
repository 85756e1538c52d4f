"""Two links and the elbow between them, in their plane: the triangle to which most closed forms reduce.

Both derivations of the source: algebraic, by x² + y² and polar coordinates, and geometric, by the law of cosines.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import atan2, hypot, pi, sqrt

import numpy as np

from helicoide.ik.postures.branch import wrap
from helicoide.text import Text

# A point nearer to an edge than this fraction of the outer radius is on it. Rounding would otherwise change θ₂ from 0
# or π by its square root.
EDGE = 1e-12

UP = Text(en="elbow up", pt_BR="cotovelo para cima")
DOWN = Text(en="elbow down", pt_BR="cotovelo para baixo")
STRETCHED = Text(en="stretched", pt_BR="esticado")
FOLDED = Text(en="folded", pt_BR="dobrado")


@dataclass(frozen=True)
class Annulus:
    """The points that two links reach: |l₁ − l₂| ≤ r ≤ l₁ + l₂, m. Source: Campos 1998, s.8–10, s.53."""

    l1: float
    l2: float

    @property
    def inner(self) -> float:
        """Radius of the hole, m."""
        return abs(self.l1 - self.l2)

    @property
    def outer(self) -> float:
        """Radius of the outer edge, m."""
        return self.l1 + self.l2

    def beyond(self, r: float) -> float:
        """How far a point at the distance r, m, lies outside: max(r − (l₁ + l₂), |l₁ − l₂| − r, 0)."""
        far = max(r - self.outer, self.inner - r)
        return far if far > EDGE * self.outer else 0.0

    def on_edge(self, r: float) -> bool:
        """Whether the distance r, m, is one of the radii."""
        return min(abs(r - self.outer), abs(r - self.inner)) <= EDGE * self.outer

    def at_centre(self, r: float) -> bool:
        """Whether equal links are folded with their end on the first axis, so that θ₁ is free."""
        return r <= EDGE * self.outer and self.inner <= EDGE * self.outer

    def elbows(self, r: float) -> tuple[int, ...]:
        """The signs of θ₂ for a point at the distance r, m: two inside, one on either edge, none outside."""
        if self.beyond(r):
            return ()
        return (1,) if self.on_edge(r) else (1, -1)

    def words(self, r: float) -> Text | None:
        """How far a point at the distance r, m, lies beyond an edge, in words; None inside."""
        if not self.beyond(r):
            return None
        return (_OUTSIDE if r > self.outer else _IN_HOLE).format(
            far=1000 * self.beyond(r), inner=1000 * self.inner, outer=1000 * self.outer
        )


_OUTSIDE = Text(
    en="Out of reach: {far:.3g} mm beyond the outer radius {outer:.4g} mm of the two links.",
    pt_BR="Fora do alcance: {far:.3g} mm além do raio externo {outer:.4g} mm dos dois elos.",
)
_IN_HOLE = Text(
    en="Out of reach: {far:.3g} mm inside the inner radius {inner:.4g} mm of the two links.",
    pt_BR="Fora do alcance: {far:.3g} mm para dentro do raio interno {inner:.4g} mm dos dois elos.",
)


@dataclass(frozen=True)
class Algebraic:
    """The steps of the algebraic derivation; angles in rad, lengths in m."""

    c2: float
    s2: float
    theta2: float
    k1: float
    k2: float
    r: float
    gamma: float
    theta1: float


@dataclass(frozen=True)
class Geometric:
    """The steps of the geometric derivation, rad: β the direction of the point, ψ from there to the first link."""

    c2: float
    theta2: float
    beta: float
    cos_psi: float
    psi: float
    theta1: float


def cosine_of_elbow(x: float, y: float, links: Annulus) -> float:
    """c₂ = (x² + y² − l₁² − l₂²) / 2l₁l₂, exactly ±1 on the edges; beyond [−1, 1] out of reach.

    Args: x, y, m. Source: Campos 1998, s.44 and s.52.
    """
    l1, l2 = links.l1, links.l2
    cosine = (x**2 + y**2 - l1**2 - l2**2) / (2 * l1 * l2)
    return float(np.sign(cosine)) if links.on_edge(hypot(x, y)) else cosine


def algebraic(x: float, y: float, links: Annulus, sign: int, kept: float) -> Algebraic:
    """s₂ = ±√(1 − c₂²), k₁ = l₁ + l₂c₂, k₂ = l₂s₂, γ = Atan2(k₂, k₁), θ₁ = Atan2(y, x) − γ.

    Args: x, y, m, within reach; sign: of s₂; kept: θ₁, rad, where it is free.
    Source: Campos 1998, s.44–48.
    """
    c2 = cosine_of_elbow(x, y, links)
    s2 = sign * sqrt(1 - c2**2)
    k1, k2 = links.l1 + links.l2 * c2, links.l2 * s2
    gamma = atan2(k2, k1)
    theta1 = kept if links.at_centre(hypot(x, y)) else float(wrap(atan2(y, x) - gamma))
    return Algebraic(c2, s2, atan2(s2, c2), k1, k2, hypot(k1, k2), gamma, theta1)


def geometric(x: float, y: float, links: Annulus, sign: int, kept: float) -> Geometric:
    """cos ψ = (x² + y² + l₁² − l₂²) / 2l₁√(x² + y²), θ₁ = β ± ψ with + where θ₂ < 0 and − where θ₂ > 0.

    Args as in `algebraic`. Source: Campos 1998, s.52–54.
    """
    c2, r = cosine_of_elbow(x, y, links), hypot(x, y)
    theta2 = sign * float(np.arccos(c2))
    beta = atan2(y, x)
    if links.at_centre(r):
        return Geometric(c2, theta2, beta, 0.0, pi / 2, kept)
    cos_psi = (r**2 + (links.l1**2 - links.l2**2)) / (2 * links.l1 * r)
    if links.on_edge(r):
        cos_psi = float(np.sign(cos_psi))
    psi = float(np.arccos(cos_psi))
    return Geometric(c2, theta2, beta, cos_psi, psi, float(wrap(beta + psi if theta2 < 0 else beta - psi)))


@dataclass(frozen=True)
class ElbowPosture:
    """One posture of the two links for a point: its name and the steps of both derivations."""

    name: Text
    algebraic: Algebraic
    geometric: Geometric

    @property
    def values(self) -> dict[str, float]:
        """The steps by symbol, rad and m, in the order of the source."""
        one, two = self.algebraic, self.geometric
        steps = {"c₂": one.c2, "s₂": one.s2, "θ₂": one.theta2, "k₁": one.k1, "k₂": one.k2, "r": one.r, "γ": one.gamma}
        return {**steps, "θ₁": one.theta1, "β": two.beta, "cos ψ": two.cos_psi, "ψ": two.psi}


def elbow_postures(x: float, y: float, links: Annulus, kept: float) -> tuple[ElbowPosture, ...]:
    """Every posture of the links for a point: two inside, one on an edge, none outside. Args as in `algebraic`."""
    r = hypot(x, y)
    return tuple(
        ElbowPosture(_name(sign, links, r), algebraic(x, y, links, sign, kept), geometric(x, y, links, sign, kept))
        for sign in links.elbows(r)
    )


def _name(sign: int, links: Annulus, r: float) -> Text:
    """The name of a posture: for θ₂ > 0 the elbow is right of the line to the point, that is below it if x > 0."""
    if not links.on_edge(r):
        return DOWN if sign > 0 else UP
    return STRETCHED if abs(r - links.outer) < abs(r - links.inner) else FOLDED


def free_or_edge(x: float, y: float, links: Annulus) -> Text | None:
    """The sentence for a point with only one posture; None for others."""
    r = hypot(x, y)
    if links.at_centre(r):
        return _FREE
    return _ON_EDGE if links.on_edge(r) else None


_FREE = Text(
    en="One posture, folded; the rotation about the axis through the point is arbitrary.",
    pt_BR="Uma postura, dobrada; a rotação em torno do eixo que passa pelo ponto é arbitrária.",
)
_ON_EDGE = Text(
    en="One posture: the point is on the boundary of the workspace.",
    pt_BR="Uma postura: o ponto está na borda do espaço de trabalho.",
)
