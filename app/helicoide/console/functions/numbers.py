"""Functions of numbers. Angles are in radians; `deg` converts from degrees."""

from __future__ import annotations

import math
from collections.abc import Callable

from helicoide.console.functions import Compute, Example, console_function
from helicoide.console.parameters import ANYTHING, NUMBER
from helicoide.console.values import Value, size_of
from helicoide.text import HelicoideError, Text

DOMAIN = Text(en="{name} of this number is not a real number", pt_BR="{name} deste número não é um número real")


def _real(compute: Callable[[float], float], about: Text, example: Example) -> Compute:
    """A function of one number, called as `math` names it. It raises HelicoideError outside its domain."""
    name = compute.__name__

    @console_function(f"{name}(x)", (NUMBER,), about, example)
    def real(x: float) -> Value:
        try:
            return compute(x)
        except (ValueError, OverflowError):
            raise HelicoideError(DOMAIN.format(name=name)) from None

    return real


_sin = _real(
    math.sin, Text(en="sine of an angle in radians", pt_BR="seno de um ângulo em radianos"), Example("sin(pi/6)", "0.5")
)
_cos = _real(
    math.cos,
    Text(en="cosine of an angle in radians", pt_BR="cosseno de um ângulo em radianos"),
    Example("cos(pi/3)", "0.5"),
)
_tan = _real(
    math.tan,
    Text(en="tangent of an angle in radians", pt_BR="tangente de um ângulo em radianos"),
    Example("tan(pi/4)", "1"),
)
_asin = _real(
    math.asin,
    Text(en="angle in radians with this sine", pt_BR="ângulo em radianos com este seno"),
    Example("asin(1)", "pi/2"),
)
_acos = _real(
    math.acos,
    Text(en="angle in radians with this cosine", pt_BR="ângulo em radianos com este cosseno"),
    Example("acos(0)", "pi/2"),
)
_sqrt = _real(math.sqrt, Text(en="square root", pt_BR="raiz quadrada"), Example("sqrt(2)**2", "2"))


@console_function(
    "atan2(y, x)", (NUMBER, NUMBER),
    Text(en="angle of the vector (x, y), in radians", pt_BR="ângulo do vetor (x, y), em radianos"),
    Example("atan2(1, 1)", "pi/4"),
)  # fmt: skip
def _atan2(y: float, x: float) -> Value:
    return math.atan2(y, x)


@console_function(
    "deg(x)", (NUMBER,), Text(en="x degrees, in radians", pt_BR="x graus, em radianos"), Example("deg(180)", "pi")
)  # fmt: skip
def _deg(x: float) -> Value:
    return math.radians(x)


@console_function(
    "abs(x)", (ANYTHING,),
    Text(en="absolute value of a number; norm of anything else", pt_BR="valor absoluto de um número; senão, a norma"),
    Example("abs(-2)", "2"),
)  # fmt: skip
def _abs(x: Value) -> Value:
    return size_of(x)
