"""The rows of a study in words: what stands in each column of its table."""

from __future__ import annotations

from collections.abc import Sequence
from math import floor, isfinite, log10

from helicoide.studies.study import Fitted, Result, Row, Statement, Verdict
from helicoide.text import Text, joined, same

HEADINGS = (
    Text(en="quantity", pt_BR="grandeza"),
    Text(en="the source prints", pt_BR="a fonte imprime"),
    Text(en="ours", pt_BR="nosso"),
    Text(en="verdict", pt_BR="veredito"),
)
NOTHING = "–"
PLACED, BECAUSE = same("{words} ({place})"), same("{said}: {why}")
FITTED = Text(en="Fitted values: {values}.", pt_BR="Valores ajustados: {values}.")
HOLDS = Text(en="{name} = {value} (holds from {least} to {most})", pt_BR="{name} = {value} (vale de {least} a {most})")
RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
FINEST, DIGITS = 1e-6, 6


def number(value: float, unit: str = "", tolerance: float = 0.0, digits: int = DIGITS) -> str:
    """Decimals as far as the tolerance lets them count, else some digits; a degree sign stands close, a unit apart."""
    decimals = -floor(log10(tolerance)) if FINEST <= tolerance < 1 else 0
    shown = f"{value:.{decimals}f}" if isfinite(value) and decimals else short(value, digits)
    return f"{shown}{unit}" if unit in ("", "°") else f"{shown} {unit}"


def written(value: float, unit: str = "", tolerance: float = 0.0, digits: int = DIGITS) -> Text:
    """The same number in both languages."""
    digits_and_unit = number(value, unit, tolerance, digits).replace("-", "−")
    return Text(en=digits_and_unit, pt_BR=digits_and_unit.replace(".", ","))


def short(value: float, digits: int) -> str:
    """A number of so many digits; a power of ten is written as one, with raised digits."""
    mantissa, e, exponent = f"{value + 0.0:.{digits}g}".partition("e")  # + 0.0: no -0
    return f"{mantissa}×{raised(int(exponent))}" if e else mantissa


def raised(exponent: int) -> str:
    """The power of ten, such as 10⁻⁶."""
    return "10" + str(exponent).translate(RAISED)


def in_order(rows: Sequence[Row]) -> list[Row]:
    """What the source prints first, then what it shows in figures, and ours apart at the end."""
    last = (Verdict.FIGURE, Verdict.OURS)
    return sorted(rows, key=lambda row: last.index(row.verdict) + 1 if row.verdict in last else 0)


def source(row: Row) -> Text:
    """What the source prints, and where."""
    match row.source:
        case None:
            return same(NOTHING)
        case Statement(words, place):
            return PLACED.format(words=words, place=place)
    return same(row.source.place)


def ours(row: Row, digits: int = DIGITS) -> Text:
    """Our number, as far as it counts."""
    return written(row.ours, row.unit, row.source.within if isinstance(row.source, Statement) else 0.0, digits)


def verdict(row: Row) -> Text:
    """The verdict, with the names of the values that were fitted, the erratum, or why it differs."""
    said = row.verdict.value
    match row.verdict:
        case Verdict.FITTED:
            return BECAUSE.format(said=said, why=joined([value.name for value in row.fitted], ", "))
        case Verdict.ERRATUM:
            return BECAUSE.format(said=said, why=row.erratum)
        case Verdict.DIFFERS if row.why is not None:
            return BECAUSE.format(said=said, why=row.why)
    return said


def fitted(result: Result) -> Text | None:
    """The values that were chosen for a study, and how far each lets the statements hold; None without any."""
    return FITTED.format(values=joined([_holds(chosen) for chosen in result.fitted])) if result.fitted else None


def _holds(chosen: Fitted) -> Text:
    ends = {"least": written(chosen.least, digits=3), "most": written(chosen.most, digits=3)}
    return HOLDS.format(name=chosen.name, value=written(chosen.value, chosen.unit), **ends)


def cells(row: Row) -> tuple[Text, Text, Text, Text]:
    """The columns of `HEADINGS`."""
    return row.quantity, source(row), ours(row), verdict(row)
