"""The interface of a method of inverse kinematics: its task, solution, promises and settings."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, fields, replace
from enum import Enum
from math import isfinite
from types import MappingProxyType
from typing import Annotated, Any, Protocol, TypeVar, get_origin, get_type_hints

from helicoide.arrays import Array
from helicoide.ik import Problem, Reason
from helicoide.text import HelicoideError, Text, untranslated

Settings = TypeVar("Settings")


@dataclass(frozen=True, eq=False)
class Task:
    """What is asked in one instant: joint velocities q̇ with J q̇ = ν, ν = ẋ_d + Λ e.

    q (n,), rad or m; J (r, n); rate: ν (r,), 1/s; dt: how long the solution is applied, s. In J and ν lengths are
    divided by the characteristic length ℓ of the problem; a prismatic joint is measured in ℓ.
    """

    q: Array
    J: Array
    rate: Array
    dt: float


@dataclass(frozen=True, eq=False)
class OnDemand(Mapping[str, float]):
    """Figures that cost more than the solution: each is computed when it is read."""

    computed: Mapping[str, Callable[[], float]]

    def __getitem__(self, symbol: str) -> float:
        return self.computed[symbol]()

    def __iter__(self) -> Iterator[str]:
        return iter(self.computed)

    def __len__(self) -> int:
        return len(self.computed)


@dataclass(frozen=True, eq=False)
class Solution:
    """The result of a method: q̇ (n,), rad/s, or ℓ/s for a prismatic joint.

    figures: numbers of this instant by symbol, such as the damping; inverse: B (n, r) where q̇ = B ν; reasons: the
    constraints that limited q̇.
    """

    rates: Array
    figures: Mapping[str, float] = field(default_factory=lambda: MappingProxyType({}))
    inverse: Array | None = None
    reasons: tuple[Reason, ...] = ()


class Promise(Enum):
    """What a method can promise, in words; a contract test checks each method against the promises that it names."""

    CONVERGES = Text(en="reaches a reachable goal", pt_BR="alcança um objetivo alcançável")
    EXACT = Text(
        en="gives exactly the asked velocity where the arm is not singular",
        pt_BR="dá exatamente a velocidade pedida onde o braço não é singular",
    )
    BOUNDED = Text(
        en="joint velocities stay below a hundred times the asked velocity, also in singular postures",
        pt_BR="as velocidades de junta ficam abaixo de cem vezes a velocidade pedida, também em posturas singulares",
    )
    KEEPS_LIMITS = Text(
        en="respects joint limits, joint speeds and distances by itself",
        pt_BR="respeita por si limites, velocidades de junta e distâncias",
    )
    LEAVES_SINGULAR = Text(en="leaves a singular start posture", pt_BR="sai de uma postura inicial singular")
    STAYS_SINGULAR = Text(
        en="never leaves an exactly singular start posture along the lost direction",
        pt_BR="nunca sai, pela direção perdida, de uma postura inicial exatamente singular",
    )


@dataclass(frozen=True)
class Quantity:
    """A setting that is a number: a slider from lower to upper.

    unit: as written on the screen. lengths: the power of the length in that unit, so that what is shown in mm, mm² or
    mm³ is the stored number times ℓ, ℓ² or ℓ³. decades: the slider is logarithmic.
    """

    title: Text
    lower: float
    upper: float
    unit: str = ""
    lengths: int = 0
    decades: bool = False


@dataclass(frozen=True)
class OneOf:
    """A setting that is one of several words, each with the text shown for it."""

    title: Text
    choices: Mapping[str, Text]


@dataclass(frozen=True)
class YesNo:
    """A setting that is on or off."""

    title: Text


Setting = Quantity | OneOf | YesNo


def settings(options: type) -> dict[str, Setting]:
    """The settings of an options class by field name, read from its annotations."""
    hints = get_type_hints(options, include_extras=True)
    return {
        one.name: next(part for part in hints[one.name].__metadata__ if isinstance(part, Quantity | OneOf | YesNo))
        for one in fields(options)
        if get_origin(hints[one.name]) is Annotated
    }


def changed(options: Settings, name: str, value: object) -> Settings:
    """The same options with one setting changed.

    Raises HelicoideError for an unknown setting or an invalid value; the message says what is valid.
    """
    known = settings(type(options))
    if name not in known:
        raise HelicoideError(
            Text(
                en="There is no setting {name}; settings: {known}.", pt_BR="Não há ajuste {name}; ajustes: {known}."
            ).format(name=name, known=", ".join(known) or "–")
        )
    if not _is_valid(known[name], value):
        raise HelicoideError(_valid(known[name]).format(title=known[name].title, value=repr(value)))
    return replace(options, **{name: value})  # type: ignore[type-var]


def _is_valid(setting: Setting, value: object) -> bool:
    match setting:
        case Quantity(_, lower, upper):
            is_number = isinstance(value, int | float) and not isinstance(value, bool) and isfinite(value)
            return is_number and lower <= float(value) <= upper  # type: ignore[arg-type]
        case OneOf(_, choices):
            return value in choices
        case YesNo():
            return isinstance(value, bool)


def _valid(setting: Setting) -> Text:
    match setting:
        case Quantity(_, lower, upper):
            takes = untranslated("{lower:g} … {upper:g}").format(lower=lower, upper=upper)
        case OneOf(_, choices):
            takes = untranslated(", ".join(choices))
        case YesNo():
            takes = untranslated("True, False")
    return Text(
        en="{title} takes " + takes.en + ", not {value}.", pt_BR="{title} aceita " + takes.pt_BR + ", não {value}."
    )


class Method(Protocol):
    """A module of `ik/methods/`.

    SOURCE: a reference, or the author of the module. EQUATION: in TeX. PROMISES: if empty, the module has NO_PROMISES,
    a Text that says why. REMEMBERS: what its memory holds between steps, None for no memory. FIGURES: titles of the
    figures of its solutions, by symbol.
    """

    TITLE: Text
    SOURCE: str
    EQUATION: str
    REMEMBERS: Text | None
    PROMISES: frozenset[Promise]
    FIGURES: Mapping[str, Text]

    @property
    def Options(self) -> type:
        """The class of its settings."""

    def applies(self, task: Task) -> Text | None:
        """Why the method does not apply to a task of this shape; None where it does."""

    def start(self, task: Task, options: Any) -> Any:
        """The memory before the first step."""

    def step(self, problem: Problem, task: Task, memory: Any, options: Any) -> tuple[Solution, Any]:
        """The solution of one task, and the memory for the next."""


@dataclass(frozen=True, eq=False)
class ConfiguredMethod:
    """A method of inverse kinematics with its options."""

    method: Method
    options: Any

    def answered(self, problem: Problem, task: Task, memory: Any) -> tuple[Solution, Any]:
        """The solution of one task and the memory for the next. memory: None for the method's initial memory."""
        memory = self.method.start(task, self.options) if memory is None else memory
        return self.method.step(problem, task, memory, self.options)
