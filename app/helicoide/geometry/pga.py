"""Conversion between the algebra of the sources, Cl(0,3,1), and modern projective geometric algebra, Cl(3,0,1).

Over the complex numbers the two algebras are isomorphic: Φ(eᵢ) = i fᵢ, Φ(e) = −i f₀ preserves every product. It maps a
blade of grade k to iᵏ times a real blade, Φ(X) = iᵏ ψ(X), which gives two real maps:

- ψ, for points, lines and planes: linear on all 16 blades, ψ(a ∧ b) = ψ(a) ∧ ψ(b), and ψ(a ∨ b) = −ψ(a) ∨ ψ(b) since
  it changes the sign of the volume e1e2e3e; it does not preserve the geometric product in general;
- Φ itself on even multivectors (iᵏ = ±1), for motors: linear, Φ(M N) = Φ(M) Φ(N), an isomorphism of the even algebras.

They agree on motions, ψ(M X M*) = Φ(M) ψ(X) Φ(M)~, and on reflections, ψ(π X π*) = ψ(π) ψ(X) ψ(π). On bivectors they
differ in sign, Φ(L) = −ψ(L): ψ maps a line as an element, Φ maps it as a generator of rotations. Therefore a rotation
by +θ about the same line is exp(+θL/2) in the sources and exp(−θL/2) in modern algebra.
"""

from __future__ import annotations

from helicoide.geometry import rigid
from helicoide.geometry.clifford import CL031, Array


def to_modern(X: Array) -> Array:
    """Point, line or plane of Cl(0,3,1) as one of Cl(3,0,1): ψ(X), e → −e₀ in each blade.

    A plane n·r = d becomes n_x e1 + n_y e2 + n_z e3 − d e0, a line v_x e23 + v_y e31 + v_z e12 + u_x e01 + u_y e02 +
    u_z e03, a point e123 + x e032 + y e013 + z e021; the null generator stands last in the blades here, e01 = −e1e.
    X: (..., 16) of `CL031`; returns (..., 16) of `PGA`. Source: Gunn 2017; Cerbaro 2022, eqs. 16–18.
    """
    return rigid.null_negated(X)


def from_modern(X: Array) -> Array:
    """Point, line or plane of Cl(3,0,1) as one of Cl(0,3,1), inverse of `to_modern`. X: (..., 16) of `PGA`."""
    return rigid.null_negated(X)


def motor_to_modern(M: Array) -> Array:
    """Motor of Cl(0,3,1) as the motor of Cl(3,0,1) of the same pose: Φ(M), the reverse of ψ(M).

    exp(+θL/2) becomes exp(−θ ψ(L)/2). M: even (..., 16) of `CL031`; returns (..., 16) of `PGA`.
    Source: Gunn 2017; Cerbaro 2022, eq. 96.
    """
    return CL031.reverse(to_modern(M))


def motor_from_modern(M: Array) -> Array:
    """Motor of Cl(3,0,1) as that of Cl(0,3,1), inverse of `motor_to_modern`. M: even (..., 16) of `PGA`."""
    return from_modern(CL031.reverse(M))
