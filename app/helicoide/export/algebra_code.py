"""A multivector as LaTeX, and as Python code for kingdon or galaga that computes it with all digits.

The motor of a frame of the arm is written as the product of its joint motors, so that the joint values can be changed.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from helicoide.arrays import Array
from helicoide.geometry import pga, rigid
from helicoide.geometry.notation import blade_latex, displayed_blades
from helicoide.readout import ALGEBRAS, SYMBOLS, Chain, Nature, coefficients, in_algebra
from helicoide.seat import Notation

VARIABLES: dict[Nature, str] = {"motor": "M", "line": "L", "plane": "P", "point": "X"}
KINGDON = """\
from math import cos, sin

from kingdon import Algebra

algebra = Algebra({p}, {q}, 1)
e1, e2, e3, e = (algebra.blades[name] for name in ("e1", "e2", "e3", "e0"))
"""
GALAGA = """\
from math import cos, sin

from galaga import Algebra

algebra = Algebra(({square}, {square}, {square}, 0))
e1, e2, e3, e = algebra.basis_vectors()
"""


@dataclass(frozen=True, eq=False)
class Formula:
    """A multivector (16,) of `CL031` to be written in a notation, and the product that made it, None without one."""

    nature: Nature
    values: Array
    notation: Notation
    chain: Chain | None = None


def kingdon_code(formula: Formula) -> str:
    """A Python program with the package kingdon."""
    algebra = ALGEBRAS[formula.notation.algebra]
    return KINGDON.format(p=algebra.p, q=algebra.q) + _body(formula)


def galaga_code(formula: Formula) -> str:
    """A Python program with the package galaga."""
    return GALAGA.format(square=ALGEBRAS[formula.notation.algebra].squares[0]) + _body(formula)


def _body(formula: Formula) -> str:
    symbol, chain = VARIABLES[formula.nature], formula.chain
    if chain is None:
        values = in_algebra(formula.nature, formula.values, formula.notation.algebra)
        return f"\n{symbol} = {_sum(values, formula.notation)}\nprint({symbol})\n"
    start = in_algebra("motor", chain.at_zero, formula.notation.algebra)
    product = " * ".join([*(f"M{i + 1}" for i in range(len(chain.values))), "M0"])
    lines = [*_joint_lines(chain, formula.notation), f"M0 = {_sum(start, formula.notation)}"]
    return "\n" + "\n".join([*lines, f"M = {'-1.0 * ' if chain.sign < 0 else ''}{product}", "print(M)", ""])


def _joint_lines(chain: Chain, notation: Notation) -> Iterator[str]:
    """The line and the motor of each joint: cos(θ/2) ± sin(θ/2) L, or 1 + ½ x (s e)."""
    sources = notation.algebra == "Cl(0,3,1)"
    for i, (joint, value) in enumerate(zip(chain.robot.joints, chain.values, strict=False), 1):
        if joint.is_prismatic:
            slide = 2 * rigid.null_part(rigid.translator(joint.direction))
            yield f"x{i} = {float(value)!r}"
            yield f"S{i} = {_sum(in_algebra('motor', slide, notation.algebra), notation)}"
            yield f"M{i} = 1.0 + x{i} / 2 * S{i}"
        else:
            line = rigid.line(joint.direction, joint.point)
            yield f"theta{i} = {float(value)!r}"
            yield f"L{i} = {_sum(line if sources else pga.to_modern(line), notation)}"
            yield f"M{i} = cos(theta{i} / 2) {'+' if sources else '-'} sin(theta{i} / 2) * L{i}"


def _sum(values: Array, notation: Notation) -> str:
    """The blades that are not zero, as products of generators, with all digits."""
    algebra = ALGEBRAS[notation.algebra]
    terms = [
        repr(float(blade.sign * values[blade.place]))
        + "".join(f" * e{digit}" for digit in blade.name.removeprefix("1").split("e")[1:])
        for blade in displayed_blades(algebra)
        if values[blade.place] != 0
    ]
    return " + ".join(terms if np.any(values[1:]) else [*terms, "0.0 * e1"])  # not a bare number


def latex_text(formula: Formula) -> str:
    """The multivector as a sum of blades, with all digits; for a frame of the arm, its product first."""
    known = coefficients(formula.nature, formula.notation)
    terms = [
        _tex_number(one.sign * formula.values[one.place]) + ("" if one.name == "1" else rf"\,{blade_latex(one.name)}")
        for one in known
        if formula.values[one.place] != 0
    ]
    total = f"{SYMBOLS[formula.nature]} &= {' '.join(terms).removeprefix('+') or '0'}"
    lines = [*([] if formula.chain is None else _chain_latex(formula.chain)), total]
    body = " \\\\\n".join(lines)
    return f"% {formula.notation.algebra}\n\\begin{{align*}}\n{body}\n\\end{{align*}}\n"


def _chain_latex(chain: Chain) -> Iterator[str]:
    signs = "-" if chain.sign < 0 else ""
    factors = []
    for i, (joint, value) in enumerate(zip(chain.robot.joints, chain.values, strict=False), 1):
        if joint.is_prismatic:
            factors.append(rf"\left(1 + \tfrac12 x_{{{i}}} s_{{{i}}} e\right)")
            yield rf"x_{{{i}}} &= {_tex_number(value, '')}\,\mathrm{{m}}"
        else:
            factors.append(rf"e^{{\theta_{{{i}}}\ell_{{{i}}}/2}}")
            yield rf"\theta_{{{i}}} &= {_tex_number(np.degrees(value), '')}^\circ"
    yield f"M &= {signs}{' '.join(factors)}\\, M_0"


def _tex_number(value: float, plus: str = "+") -> str:
    """A number with 17 digits, a power of ten as such. plus: the sign of a positive one."""
    digits, _, power = f"{value:{plus}.17g}".partition("e")
    return digits + (rf" \times 10^{{{int(power)}}}" if power else "")
