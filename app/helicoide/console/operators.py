"""The operators of the console, on numbers, quaternions and multivectors."""

from __future__ import annotations

from collections.abc import Callable
from operator import add, and_, mul, or_, rshift, sub, truediv, xor

from helicoide.console.values import Value, reverse_of
from helicoide.geometry.clifford import QUATERNIONS
from helicoide.geometry.multivector import Multivector
from helicoide.text import HelicoideError, Text

MOST_POWER = 32

NEEDS_MULTIVECTORS = Text(
    en="{symbol} is {what}, and stands between multivectors, not numbers{hint}",
    pt_BR="{symbol} é {what} e fica entre multivetores, não entre números{hint}",
)
PRODUCTS = {
    "^": Text(en="the outer product", pt_BR="o produto exterior"),
    "|": Text(en="the left contraction", pt_BR="a contração à esquerda"),
    "&": Text(en="the regressive product", pt_BR="o produto regressivo"),
    ">>": Text(en="the sandwich product, by which a motor moves something", pt_BR="o produto sanduíche, que move algo"),
}
NOT_OF_QUATERNIONS = Text(
    en="{symbol} is {what}, of multivectors; quaternions have +, -, *, /, >>, ~ and **",
    pt_BR="{symbol} é {what}, de multivetores; quatérnios têm +, -, *, /, >>, ~ e **",
)
POWER_HINT = Text(en="; a power is written **", pt_BR="; a potência se escreve **")
NO_HINT = Text(en="", pt_BR="")
MIXED = Text(
    en="{left} meets {right}: rotate(q, X) rotates by a quaternion, motor(q) and quaternion(M) convert, "
    "modern(X) and sources(X) change the algebra",
    pt_BR="{left} encontra {right}: rotate(q, X) gira por um quatérnio, motor(q) e quaternion(M) convertem, "
    "modern(X) e sources(X) trocam de álgebra",
)
BY_ZERO = Text(en="a division by zero", pt_BR="uma divisão por zero")
BAD_POWER = Text(
    en="this power is not a real number: the base is negative and the exponent not whole",
    pt_BR="esta potência não é um número real: a base é negativa e o expoente não é inteiro",
)
TOO_LARGE = Text(en="this power is too large", pt_BR="esta potência é grande demais")
WHOLE_POWER = Text(
    en="the exponent of a multivector is a whole number from −{most} to {most}; use exp(s*log(M)) for others",
    pt_BR="o expoente de um multivetor é um inteiro de −{most} a {most}; para outros, use exp(s*log(M))",
)


def _power(base: Value, exponent: Value) -> Value:
    if isinstance(exponent, Multivector):
        raise HelicoideError(WHOLE_POWER.format(most=MOST_POWER))
    if isinstance(base, Multivector):
        if exponent != int(exponent) or abs(exponent) > MOST_POWER:
            raise HelicoideError(WHOLE_POWER.format(most=MOST_POWER))
        return base ** int(exponent)
    if base == 0 and exponent < 0:
        raise HelicoideError(BY_ZERO)
    if base < 0 and exponent != int(exponent):
        raise HelicoideError(BAD_POWER)
    try:
        return float(base**exponent)
    except OverflowError:
        raise HelicoideError(TOO_LARGE) from None


_BINARY: dict[str, Callable[[Value, Value], Value]] = {
    "+": add,
    "-": sub,
    "*": mul,
    "/": truediv,
    "^": xor,
    "|": or_,
    "&": and_,
    ">>": rshift,
    "**": _power,
}  # fmt: skip


def binary(symbol: str, left: Value, right: Value) -> Value:
    """The value of `left symbol right`. Raises HelicoideError."""
    if symbol in "^|&" and any(isinstance(each, Multivector) and each.algebra is QUATERNIONS for each in (left, right)):
        raise HelicoideError(NOT_OF_QUATERNIONS.format(symbol=symbol, what=PRODUCTS[symbol]))
    if isinstance(left, Multivector) and isinstance(right, Multivector):
        if left.algebra is not right.algebra and symbol != "**":
            raise HelicoideError(MIXED.format(left=_algebra(left), right=_algebra(right)))
    elif symbol in PRODUCTS:
        if not isinstance(left, Multivector):
            if not isinstance(right, Multivector) or symbol == ">>":
                hint = POWER_HINT if symbol == "^" else NO_HINT
                raise HelicoideError(NEEDS_MULTIVECTORS.format(symbol=symbol, what=PRODUCTS[symbol], hint=hint))
            left = left + 0 * right
    elif symbol == "/" and right == 0:
        raise HelicoideError(BY_ZERO)
    return _BINARY[symbol](left, right)


def unary(symbol: str, operand: Value) -> Value:
    """The value of `-operand`, or of the reverse `~operand`, which leaves a number as it is."""
    if symbol == "-":
        return -operand
    return reverse_of(operand)


def repetitions(symbol: str, operands: tuple[Value, ...]) -> int:
    """How many products an operation takes."""
    base, exponent = operands[0], operands[-1]
    if symbol != "**" or not isinstance(base, Multivector) or isinstance(exponent, Multivector):
        return 1
    return 1 + min(int(abs(exponent)), MOST_POWER)


def _algebra(value: Multivector) -> Text:
    if value.algebra is QUATERNIONS:
        return Text(en="a quaternion", pt_BR="um quatérnio")
    return Text(en=f"a multivector of {value.algebra}", pt_BR=f"um multivetor de {value.algebra}")
