"""The contract of a study: an experiment of a source, what the source prints, and what is computed here."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, replace
from enum import Enum
from typing import Any, Literal, Protocol

from helicoide.arrays import Array
from helicoide.text import Text

Progress = Callable[[float], None]
SINGLE_RUN = Text(en="the run", pt_BR="a execução")
INPUT_VALUE = Text(en="it was put in", pt_BR="é dado de entrada")
BY_CONSTRUCTION = Text(en="it holds by construction", pt_BR="vale por construção")
Relation = Literal["=", "~", "<", "≤", ">", "≥"]

_NUMBER = re.compile(r"([~≈<≤>≥=])?\s*([-−]?\d+(?:[.,]\d+)?)(?:\s*[×·]\s*10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+))?")
_LOWERED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")


class Verdict(Enum):
    """How the computed number compares with what the source prints."""

    PRINTED = Text(en="as printed", pt_BR="como impresso")
    FITTED = Text(
        en="as printed, with a fitted value or reading", pt_BR="como impresso, com valor ou leitura escolhidos"
    )
    DIFFERS = Text(en="differs", pt_BR="difere")
    ERRATUM = Text(en="a slip in print or in our copy", pt_BR="lapso no impresso ou na nossa cópia")
    FIGURE = Text(en="only in a figure", pt_BR="só em figura")
    OURS = Text(en="here", pt_BR="aqui")


@dataclass(frozen=True)
class Statement:
    """What a source prints about a quantity.

    words: the statement in both languages; place: such as "fig. 3.11" or "§4.2.1"; value: the number that the words
    require, in the unit of the row; relation: "=" to within `within`, "~" in the same power of ten, or a bound.
    """

    words: Text
    place: str
    value: float
    relation: Relation = "="
    within: float = 0.0

    @property
    def is_number(self) -> bool:
        """Whether the source prints a number, not a sentence that is read as one."""
        return _NUMBER.fullmatch(self.words.en) is not None

    def holds(self, number: float) -> bool:
        """Whether a number agrees with the statement; NaN never does."""
        match self.relation:
            case "=":
                return abs(number - self.value) <= self.within
            case "~":
                return self.value <= number < 10 * self.value
            case "<":
                return number < self.value
            case "≤":
                return number <= self.value + self.within
            case ">":
                return number > self.value
            case "≥":
                return number >= self.value - self.within


def printed_statement(words: str, place: str) -> Statement:
    """The statement of a printed number, such as "< 1,2", "≈ 9" or "8,3 × 10⁻⁴".

    The tolerance is half a unit of the last digit, a whole unit after "≈". Raises ValueError for words that are not a
    number.
    """
    if not (match := _NUMBER.fullmatch(words.strip())):
        raise ValueError(f"{words!r} is no number with a relation, such as '< 1,2'")
    sign, digits, power = match[1] or "=", match[2].replace(",", ".").replace("−", "-"), match[3]
    scale = 10.0 ** int((power or "0").translate(_LOWERED))
    unit = scale * 10.0 ** -len(digits.partition(".")[2])
    relation: Relation = "=" if sign == "≈" else sign  # type: ignore[assignment]
    within = {"=": 0.5, "≈": 1.0}.get(sign, 0.0) * unit * (1 + 1e-9)
    said = Text(en=words.replace(",", "."), pt_BR=words.replace(".", ","))
    return Statement(said, place, float(digits) * scale, relation, within)


@dataclass(frozen=True)
class Figure:
    """A quantity that the source shows only in a figure, at `place`."""

    place: str


@dataclass(frozen=True)
class Fitted:
    """A value that the source omits, chosen so that its statements hold; they hold from `least` to `most`."""

    name: Text
    value: float
    least: float
    most: float
    unit: str = ""


@dataclass(frozen=True)
class Interpretation:
    """The interpretation chosen where the source allows more than one, such as the instant at which an error is read.

    otherwise: the result of another interpretation.
    """

    name: Text
    otherwise: Text


@dataclass(frozen=True)
class Row:
    """A quantity: what the source prints, if anything, and what is computed here (`computed`), in the same unit.

    fitted: the chosen values and interpretations under which the statement holds; erratum: the error of the source that
    explains a difference, such as "vargas-2"; why: another explanation of a difference, if known; given: why `computed`
    is not a result and gets no verdict, such as `INPUT_VALUE`.
    """

    quantity: Text
    computed: float
    unit: str = ""
    source: Statement | Figure | None = None
    fitted: tuple[Fitted | Interpretation, ...] = ()
    erratum: str = ""
    why: Text | None = None
    given: Text | None = None

    @property
    def verdict(self) -> Verdict:
        """How `computed` compares with what the source prints; NaN always differs."""
        if self.computed != self.computed:
            return Verdict.DIFFERS
        if self.given is not None:
            return Verdict.OURS
        match self.source:
            case None:
                return Verdict.OURS
            case Figure():
                return Verdict.FIGURE
            case Statement() as statement if statement.holds(self.computed):
                return Verdict.FITTED if self.fitted else Verdict.PRINTED
        return Verdict.ERRATUM if self.erratum else Verdict.DIFFERS


def without_statements(rows: tuple[Row, ...]) -> tuple[Row, ...]:
    """The rows without their statements, for a study with settings other than those of its source."""
    return tuple(replace(row, source=None, fitted=(), erratum="", why=None, given=None) for row in rows)


@dataclass(frozen=True, eq=False)
class ChartLine:
    """A curve of a chart: x (k,) and y (k,)."""

    title: Text
    x: Array
    y: Array


@dataclass(frozen=True)
class ChartBand:
    """A horizontal band of a chart, from lower to upper, one of them possibly infinite. serious: not only a warning."""

    title: Text
    lower: float
    upper: float
    serious: bool = True


@dataclass(frozen=True, eq=False)
class Chart:
    """Curves over a common quantity; `x_label` and `y_label` label the axes, with units.

    figure: the figure of the source to compare with, such as "fig. 3.11"; log: whether the vertical axis is
    logarithmic; bands: values that the curves should not have; y_range: of the vertical axis, None to fit the curves;
    phase: whether the curves may turn back, as in a phase plane.
    """

    title: Text
    x_label: Text
    y_label: Text
    lines: tuple[ChartLine, ...]
    figure: str = ""
    log: bool = False
    bands: tuple[ChartBand, ...] = ()
    y_range: tuple[float, float] | None = None
    phase: bool = False


@dataclass(frozen=True, eq=False)
class Motion:
    """The motion of a robot in one run: times (k,), s, and joint values (k, n), rad or m.

    robot: its name; parameters: changed lengths, mm, in the form that `load` takes; title: the name of the run.
    """

    robot: str
    times: Array
    q: Array
    parameters: tuple[str, ...] = ()
    title: Text = SINGLE_RUN


@dataclass(frozen=True, eq=False)
class Result:
    """The results of a study: rows, charts, and the motion of the arm in each run."""

    rows: tuple[Row, ...]
    charts: tuple[Chart, ...] = ()
    motions: tuple[Motion, ...] = ()

    @property
    def fitted(self) -> tuple[Fitted | Interpretation, ...]:
        """All values and interpretations chosen so that printed statements hold, each once."""
        return tuple(dict.fromkeys(value for row in self.rows for value in row.fitted))


class Study(Protocol):
    """A module of `studies/`.

    SOURCE: author, year, section; or that it is your own. Options: annotated with the settings of `ik.method`, like the
    options of a method.
    """

    TITLE: Text
    SOURCE: str
    ABOUT: Text
    ROBOT: str

    @property
    def Options(self) -> type:
        """The class of its settings; defaults are the values of the source, or chosen values where it gives none."""

    def run(self, options: Any, short: bool, progress: Progress) -> Result:
        """Run the study. short: a quick run of a few seconds, which leaves out rows that it cannot judge.

        progress: called with the completed fraction, 0 to 1.
        """
