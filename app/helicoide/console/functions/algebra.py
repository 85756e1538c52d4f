"""Parts and conjugates of multivectors, quaternions, and the conversion between the two algebras."""

from __future__ import annotations

import numpy as np

from helicoide.console.functions import Compute, Example, console_function
from helicoide.console.operators import binary
from helicoide.console.parameters import ANYTHING, GRADE, MOTOR, MULTIVECTOR, NUMBER
from helicoide.console.values import Value, finite_value, quaternion_value, reverse_of, size_of
from helicoide.geometry import pga, rigid
from helicoide.geometry.clifford import CL031, PGA, QUATERNIONS
from helicoide.geometry.multivector import Multivector
from helicoide.text import HelicoideError, Text

NO_NORM = Text(en="its norm is 0, so it has no unit size", pt_BR="a norma é 0, então não há forma unitária")
ONE_BLADE = Text(
    en="the second argument is one blade of the first one's algebra, such as e12 or e1e2e, or i, j, k of a quaternion",
    pt_BR="o segundo argumento é uma lâmina da álgebra do primeiro, como e12 ou e1e2e, ou i, j, k de um quatérnio",
)
TO_MODERN = Text(
    en="this converts multivectors of Cl(0,3,1); this one is of {algebra}",
    pt_BR="isto converte multivetores de Cl(0,3,1); este é de {algebra}",
)
TO_SOURCES = Text(
    en="this converts multivectors of Cl(3,0,1); this one is of {algebra}",
    pt_BR="isto converte multivetores de Cl(3,0,1); este é de {algebra}",
)
EVEN = Text(
    en="a motor has blades of even grade alone; modern(X) and sources(X) convert points, lines and planes",
    pt_BR="um motor só tem lâminas de grau par; modern(X) e sources(X) convertem pontos, retas e planos",
)


@console_function(
    "conj(X)", (ANYTHING,),
    Text(
        en="conjugate X*: of a quaternion, or the Clifford conjugate; of a unit motor its inverse",
        pt_BR="conjugado X*: de um quatérnio, ou o de Clifford; de um motor unitário é o inverso",
    ),
    Example("conj(1 + 2*i)", "1 - 2*i"),
)  # fmt: skip
def _conj(X: Value) -> Value:
    return X.conjugate() if isinstance(X, Multivector) else X


@console_function(
    "reverse(X)", (ANYTHING,),
    Text(en="reverse ~X, the factors in the opposite order", pt_BR="reverso ~X, fatores na ordem contrária"),
    Example("reverse(e12)", "-e12"),
)  # fmt: skip
def _reverse(X: Value) -> Value:
    return reverse_of(X)


@console_function(
    "inverse(X)", (ANYTHING,),
    Text(en="the inverse: X*inverse(X) = 1", pt_BR="o inverso: X*inverse(X) = 1"),
    Example("inverse(2*k)", "-0.5*k"),
    work=6,
)  # fmt: skip
def _inverse(X: Value) -> Value:
    return binary("/", 1.0, X)


@console_function(
    "norm(X)", (ANYTHING,),
    Text(en="norm √|⟨X~X⟩₀|; 1 of a unit motor", pt_BR="norma √|⟨X~X⟩₀|; a de um motor unitário é 1"),
    Example("norm(3*e1 + 4*e2)", "5"),
)  # fmt: skip
def _norm(X: Value) -> Value:
    return size_of(X)


@console_function(
    "unit(X)", (ANYTHING,),
    Text(en="X divided by its norm", pt_BR="X dividido pela norma"),
    Example("unit(2*e3 + 4*e)", "e3 + 2*e"),
)  # fmt: skip
def _unit(X: Value) -> Value:
    size = size_of(X)
    finite_value(size)  # 1/∞ would make it 0
    if size < 1e-300:
        raise HelicoideError(NO_NORM)
    return X * (1 / size)


@console_function(
    "grade(X, k)", (MULTIVECTOR, GRADE),
    Text(en="the part of grade k", pt_BR="a parte de grau k"),
    Example("grade(1 + e12, 2)", "e12"),
)  # fmt: skip
def _grade(X: Multivector, k: int) -> Value:
    return X.grade(k)


@console_function(
    "dual(X)", (MULTIVECTOR,),
    Text(en="Hodge star ⋆X: blade*dual(blade) = e1e2e3e", pt_BR="estrela de Hodge ⋆X: lâmina*dual(lâmina) = e1e2e3e"),
    Example("dual(e1)", "e2e3e"),
)  # fmt: skip
def _dual(X: Multivector) -> Value:
    return X.dual()


@console_function(
    "undual(X)", (MULTIVECTOR,),
    Text(en="inverse of dual: undual(dual(X)) = X", pt_BR="inverso de dual: undual(dual(X)) = X"),
    Example("undual(e2e3e)", "e1"),
)  # fmt: skip
def _undual(X: Multivector) -> Value:
    return X.inverse_dual()


@console_function(
    "part(X, blade)", (ANYTHING, ANYTHING),
    Text(en="the coefficient of a blade in X", pt_BR="o coeficiente de uma lâmina em X"),
    Example("part(point(1, 2, 3), e1e2e)", "3"),
)  # fmt: skip
def _part(X: Value, blade: Value) -> Value:
    if not isinstance(X, Multivector) or not isinstance(blade, Multivector) or X.algebra is not blade.algebra:
        raise HelicoideError(ONE_BLADE)
    (places,) = np.nonzero(blade.values)
    if len(places) != 1 or abs(blade.values[places[0]]) != 1:
        raise HelicoideError(ONE_BLADE)
    return float(X.values[places[0]] * blade.values[places[0]])


@console_function(
    "quaternion(w, x, y, z)", (ANYTHING, NUMBER, NUMBER, NUMBER),
    Text(
        en="the quaternion w + x i + y j + z k; quaternion(M) is the rotation of a motor",
        pt_BR="o quatérnio w + x i + y j + z k; quaternion(M) é a rotação de um motor",
    ),
    Example("quaternion(rotor(0, 0, 1, pi))", "k"),
    least=1,
)  # fmt: skip
def _quaternion(w: Value, x: float = 0.0, y: float = 0.0, z: float = 0.0) -> Value:
    if isinstance(w, Multivector) and w.algebra is not QUATERNIONS:
        return quaternion_value(rigid.dual_quaternion(MOTOR(w))[:4])
    return quaternion_value(np.array([NUMBER(w), x, y, z]))


def _converted(name: str, about: Text, example: Example, into_modern: bool, as_motor: bool) -> Compute:
    """A conversion between the algebras, of points, lines and planes or of motors."""
    start, end = (CL031, PGA) if into_modern else (PGA, CL031)
    convert = {
        (True, False): pga.to_modern,
        (False, False): pga.from_modern,
        (True, True): pga.motor_to_modern,
        (False, True): pga.motor_from_modern,
    }[into_modern, as_motor]

    @console_function(f"{name}(X)", (MULTIVECTOR,), about, example)
    def converts(X: Multivector) -> Value:
        if X.algebra is not start:
            raise HelicoideError((TO_MODERN if into_modern else TO_SOURCES).format(algebra=X.algebra))
        if as_motor and X.values[CL031.grades % 2 == 1].any():
            raise HelicoideError(EVEN)
        return Multivector(convert(X.values), end)

    return converts


_modern = _converted(
    "modern",
    Text(en="a point, line or plane in Cl(3,0,1)", pt_BR="um ponto, reta ou plano em Cl(3,0,1)"),
    Example("modern(e1)*modern(e1)", "modern(1)"),
    into_modern=True,
    as_motor=False,
)
_modern_motor = _converted(
    "modern_motor",
    Text(en="a motor in Cl(3,0,1), of the same motion", pt_BR="um motor em Cl(3,0,1), do mesmo movimento"),
    Example("sources(modern_motor(rotor(0,0,1,1)) >> modern(e1))", "rotor(0,0,1,1) >> e1"),
    into_modern=True,
    as_motor=True,
)
_sources = _converted(
    "sources",
    Text(
        en="a point, line or plane of Cl(3,0,1) in Cl(0,3,1)", pt_BR="um ponto, reta ou plano de Cl(3,0,1) em Cl(0,3,1)"
    ),
    Example("sources(modern(point(1, 2, 3)))", "point(1, 2, 3)"),
    into_modern=False,
    as_motor=False,
)
_sources_motor = _converted(
    "sources_motor",
    Text(en="a motor of Cl(3,0,1) in Cl(0,3,1)", pt_BR="um motor de Cl(3,0,1) em Cl(0,3,1)"),
    Example("sources_motor(modern_motor(rotor(0,0,1,1)))", "rotor(0,0,1,1)"),
    into_modern=False,
    as_motor=True,
)
