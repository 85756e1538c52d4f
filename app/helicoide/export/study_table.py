"""The rows of a study as text: the content of each column of the table."""

from __future__ import annotations

from collections.abc import Sequence
from math import floor, isfinite, log10

from helicoide.studies.study import Fitted, Interpretation, Result, Row, Statement, Verdict
from helicoide.text import Text, join_texts, significant_digits, untranslated, with_decimal_comma

HEADINGS = (
    Text(en="quantity", pt_BR="grandeza"),
    Text(en="the source says", pt_BR="a fonte diz"),
    Text(en="here", pt_BR="aqui"),
    Text(en="verdict", pt_BR="veredito"),
)
NOTHING = "–"
WITH_PLACE, BECAUSE = untranslated("{words} ({place})"), untranslated("{said}: {why}")
READ_AS = Text(en="{words} ({place}), read as {asked}", pt_BR="{words} ({place}), lido como {asked}")
FITTED = Text(en="Chosen, each varied alone: {values}.", pt_BR="Escolhidos, cada um variado sozinho: {values}.")
TAKEN = Text(en="{name} (otherwise {otherwise})", pt_BR="{name} (senão, {otherwise})")
HOLDS = Text(
    en="{name} = {value} (the row holds at least from {least} to {most})",
    pt_BR="{name} = {value} (a linha vale ao menos de {least} a {most})",
)
BOUND, BETWEEN = untranslated("{relation} {value}"), untranslated("{value} ± {within}")
DECADE = Text(en="{value} to {end}", pt_BR="{value} a {end}")
FINEST, DIGITS = 1e-6, 6


def format_number(value: float, unit: str = "", tolerance: float = 0.0, digits: int = DIGITS) -> str:
    """A number with its unit; the tolerance sets its decimals, else it has `digits` significant digits."""
    decimals = -floor(log10(tolerance)) if FINEST <= tolerance < 0.5 else 0
    shown = f"{value:.{decimals}f}" if isfinite(value) and decimals else significant_digits(value, digits)
    return with_unit(shown, unit)


def with_unit(shown: str, unit: str) -> str:
    """A number with its unit, separated by a space unless the unit is a degree sign."""
    return f"{shown}{unit}" if unit in ("", "°") else f"{shown} {unit}"


def localized_number(value: float, unit: str = "", tolerance: float = 0.0, digits: int = DIGITS) -> Text:
    """The same number in both languages."""
    return with_decimal_comma(format_number(value, unit, tolerance, digits).replace("-", "−"))


def sorted_by_verdict(rows: Sequence[Row]) -> list[Row]:
    """Sort rows: first what the source prints, then what it shows in figures, last what is only computed here."""
    last = (Verdict.FIGURE, Verdict.OURS)
    return sorted(rows, key=lambda row: last.index(row.verdict) + 1 if row.verdict in last else 0)


def source_cell(row: Row) -> Text:
    """What the source says, and where."""
    match row.source:
        case None:
            return untranslated(NOTHING)
        case Statement(words, place) as statement if statement.is_number:
            return WITH_PLACE.format(words=_with(words, row.unit), place=place)
        case Statement(words, place) as statement:
            return READ_AS.format(words=words, place=place, asked=_asked(statement, row.unit))
    return untranslated(row.source.place)


def _with(words: Text, unit: str) -> Text:
    return Text(en=with_unit(words.en, unit), pt_BR=with_unit(words.pt_BR, unit))


def _asked(statement: Statement, unit: str) -> Text:
    value = localized_number(statement.value, unit, digits=4)
    match statement.relation:
        case "=" if statement.within:
            return BETWEEN.format(value=value, within=localized_number(statement.within, unit, digits=2))
        case "~":
            return DECADE.format(value=value, end=localized_number(10 * statement.value, unit, digits=4))
    return BOUND.format(relation=statement.relation, value=value)


def computed_cell(row: Row, digits: int = DIGITS) -> Text:
    """The computed number, to the precision of the statement."""
    return localized_number(
        row.computed, row.unit, row.source.within if isinstance(row.source, Statement) else 0.0, digits
    )


def verdict_cell(row: Row) -> Text:
    """The verdict with its reason: the chosen values, the erratum, the explanation, or why it is not a result."""
    said = row.verdict.value
    match row.verdict:
        case Verdict.FITTED:
            return BECAUSE.format(said=said, why=join_texts([value.name for value in row.fitted], ", "))
        case Verdict.ERRATUM:
            return BECAUSE.format(said=said, why=row.erratum)
        case Verdict.OURS if row.given is not None:
            return BECAUSE.format(said=said, why=row.given)
        case Verdict.DIFFERS if row.why is not None:
            return BECAUSE.format(said=said, why=row.why)
    return said


def fitted_line(result: Result) -> Text | None:
    """The values and interpretations chosen for a study, with the ranges of the values; None if there are none."""
    return FITTED.format(values=join_texts([_holds(chosen) for chosen in result.fitted])) if result.fitted else None


def _holds(chosen: Fitted | Interpretation) -> Text:
    if isinstance(chosen, Interpretation):
        return TAKEN.format(name=chosen.name, otherwise=chosen.otherwise)
    ends = {"least": localized_number(chosen.least, digits=4), "most": localized_number(chosen.most, digits=4)}
    return HOLDS.format(name=chosen.name, value=localized_number(chosen.value, chosen.unit), **ends)


def row_cells(row: Row) -> tuple[Text, Text, Text, Text]:
    """The columns of `HEADINGS`."""
    return row.quantity, source_cell(row), computed_cell(row), verdict_cell(row)
