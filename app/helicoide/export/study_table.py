"""The rows of a study in words: what stands in each column of its table."""

from __future__ import annotations

from math import floor, isfinite, log10

from helicoide.studies.study import Row, Verdict
from helicoide.text import Language, Text

HEADINGS = (
    Text(en="quantity", pt_BR="grandeza"),
    Text(en="source", pt_BR="fonte"),
    Text(en="digest", pt_BR="síntese"),
    Text(en="ours", pt_BR="nosso"),
    Text(en="verdict", pt_BR="veredito"),
)
NOTHING = "–"
RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
FINEST, DIGITS = 1e-6, 6


def number(value: float, unit: str = "", tolerance: float = 0.0, digits: int = DIGITS) -> str:
    """Decimals as far as the tolerance lets them count, else some digits; a degree sign stands close, a unit apart."""
    decimals = -floor(log10(tolerance)) if FINEST <= tolerance < 1 else 0
    shown = f"{value:.{decimals}f}" if isfinite(value) and decimals else short(value, digits)
    return f"{shown}{unit}" if unit in ("", "°") else f"{shown} {unit}"


def short(value: float, digits: int) -> str:
    """A number of so many digits; a power of ten is written as one, with raised digits."""
    mantissa, e, exponent = f"{value + 0.0:.{digits}g}".partition("e")  # + 0.0: no -0
    return f"{mantissa}×{raised(int(exponent))}" if e else mantissa


def raised(exponent: int) -> str:
    """The power of ten, such as 10⁻⁶."""
    return "10" + str(exponent).translate(RAISED)


def source(row: Row, language: Language) -> str:
    """What the source prints."""
    said = row.source[language] if isinstance(row.source, Text) else row.source
    return said or NOTHING


def digest(row: Row) -> str:
    """What the digest asks for: a number and how far one may be from it, or a bound."""
    if row.digest is None:
        return NOTHING
    if row.relation != "=":
        return f"{row.relation} {number(row.digest, row.unit)}"
    return number(row.digest, row.unit, row.tolerance) + (f" ± {short(row.tolerance, 2)}" if row.tolerance else "")


def alone(row: Row) -> bool:
    """Whether our number stands alone."""
    return row.digest is None and row.agrees


def verdict(row: Row, language: Language) -> str:
    """The verdict, with the doubt or the assumption that excuses it; none where there is nothing to compare with."""
    found = row.verdict
    if alone(row):
        return NOTHING
    said = found.value[language]
    if found is Verdict.DOUBT:
        return f"{said} ({row.doubt})"
    if found is Verdict.ASSUMED and row.assumed is not None:
        return f"{said}: {row.assumed[language]}"
    return said


def cells(row: Row, language: Language) -> tuple[str, str, str, str, str]:
    """The columns of `HEADINGS`."""
    ours = number(row.ours, row.unit, row.tolerance if row.relation == "=" else 0.0)
    return row.quantity[language], source(row, language), digest(row), ours, verdict(row, language)
