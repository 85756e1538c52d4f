"""S3: through a singularity of the wrist beyond the entry point, by one inverse of the constrained Jacobian."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated

from helicoide.ik.method import OneOf
from helicoide.ik.rcm.follow import PSEUDOINVERSE, Inverse
from helicoide.studies._coutinho_rows import STEP, STEPS, charts_of, motion_of, rows_of, samples_of
from helicoide.studies._coutinho_runs import DLS, FILTERED, ROBOT, VARIABLE, control
from helicoide.studies._coutinho_runs import run as run_along
from helicoide.studies.study import Progress, Result
from helicoide.text import Text

TITLE = Text(en="S3: through a singularity", pt_BR="S3: através de uma singularidade")
SOURCE = "Coutinho 2015, §4.1.2, eqs. 4.3, 4.4; §3.6"
ABOUT = Text(
    en="The tool is turned so that the two axes around the bend beyond the trocar come into line, θ₇ = 0, where one "
    "motion of the tool is lost. The plain inverse makes the joints race; damping or the filtered inverse keep them "
    "calm at the cost of some hundredths of a millimetre at the tip, and the entry point notices nothing.",
    pt_BR="A ponta gira até que os dois eixos em torno da flexão além do trocarte se alinhem, θ₇ = 0, onde se perde um "
    "movimento. A inversa simples faz as juntas dispararem; o amortecimento ou a inversa filtrada as mantêm calmas ao "
    "custo de alguns centésimos de milímetro na ponta, e o ponto de entrada nada sente.",
)
__all__ = ["ABOUT", "ROBOT", "SOURCE", "TITLE", "Options", "run"]

INVERSES: Mapping[str, tuple[Text, Inverse]] = {
    "plain": (Text(en="plain inverse", pt_BR="inversa simples"), PSEUDOINVERSE),
    "damped": (Text(en="damped, κ = 0.05", pt_BR="amortecida, κ = 0,05"), DLS),
    "variable": (Text(en="variably damped", pt_BR="com amortecimento variável"), VARIABLE),
    "filtered": (Text(en="filtered inverse, Γ = 5", pt_BR="inversa filtrada, Γ = 5"), FILTERED),
}
# The digest's filtered rows are of another integration of Θ: so many units of the last digit.
FILTERED_LAST = 3.0

_ALIKE = {
    "lateral": "0.0042", "slip": "≤1e-12", "q7_min": "-1.169", "q7_max": "0.269", "outside_min": "0.063",
    "outside_max": "0.163", "rate": "0.0351 ± 0.0002",
}  # fmt: skip
# By sample time, ms, and inverse.
TABLE: Mapping[tuple[int, str], Mapping[str, str]] = {
    (20, "plain"): {"q7_max": "1.17 ± 0.01", "lateral": "0.042", "slip": "≤1e-7", "rate": "≥1000"},
    (20, "damped"): {**_ALIKE, "rate": "0.0351 ± 0.0001", "tip": "≤0.08", "lateral": "0.042"},
    (2, "plain"): {"tip": "0.0135", "angle": "0.0037", "lateral": "0.0042", "slip": "≤1e-8", "rate": "≥1000"},
    (2, "damped"): {"tip": "0.0784", "angle": "0.0016", **_ALIKE},
    (2, "variable"): {"tip": "0.0541", "angle": "0.0012", **_ALIKE},
    (2, "filtered"): {"tip": "0.0503", "angle": "0.0010", **_ALIKE},
}
SAMPLES = {
    0: ("0.1500", "-0.6164", "0.8325", "0.02828"),
    25: ("0.1607", "-0.0009", "0.0010", "0.02483"),
    50: ("0.1387", "0.2685", "0.5051", "0.02334"),
    100: ("0.1038", "-0.4778", "2.1849", "0.02028"),
    150: ("0.0653", "-1.1636", "15.0794", "0.01793"),
    200: ("0.1500", "-0.6170", "0.8332", "0.02829"),
}
# Over the first crossing at 20 ms.
_CROSSED = {"q7_min": "≤0", "q7_max": "≥0", "slip": "≤1e-12"}
SECONDS = 30.0
SHORT: Mapping[str, Mapping[str, str]] = {
    "plain": {"rate": "≥1000", "slip": "≤1e-7"},
    "damped": {**_CROSSED, "rate": "≤0.0352", "tip": "≤0.08"},
    "variable": {**_CROSSED, "rate": "≤0.038", "tip": "≤0.06"},
    "filtered": {**_CROSSED, "rate": "≤0.038", "tip": "≤0.06"},
}
INVERSE = Text(en="inverse of J^r", pt_BR="inversa de J^r")


@dataclass(frozen=True)
class Options:
    """The sample time, ms, and how J^r is inverted."""

    step: Annotated[str, OneOf(STEP, STEPS)] = "2"
    inverse: Annotated[str, OneOf(INVERSE, {name: title for name, (title, _) in INVERSES.items()})] = "damped"


def run(options: Options, short: bool, progress: Progress) -> Result:
    """One run; short: 30 s of it at 20 ms."""
    name, step = options.inverse, 20 if short else int(options.step)
    title, of_tool = INVERSES[name]
    printed = SHORT[name] if short else TABLE.get((step, name), {})
    got = run_along("S3", control(of_tool=of_tool), step / 1000, seconds=SECONDS if short else None, progress=progress)
    samples = SAMPLES if (step, name) == (20, "damped") else {}
    last = FILTERED_LAST if name == "filtered" else 0.55
    return Result(
        rows=(*rows_of(got, title, printed, last), *samples_of(got, step / 1000, samples)),
        charts=charts_of({title: got}),
        motion=motion_of(got),
    )
