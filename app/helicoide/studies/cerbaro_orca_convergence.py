"""The ORCA from home to its target, a constant share of the error a step."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from helicoide.ik.method import Quantity
from helicoide.studies.cerbaro_runs import setups
from helicoide.studies.cerbaro_runs.convergence import (
    INFERRED,
    OTHER_FACTOR,
    STEP_FACTOR,
    ConvergenceCase,
    convergence_result,
)
from helicoide.studies.study import Interpretation, Progress, Result, Statement
from helicoide.text import Text, untranslated

TITLE = Text(en="Convergence of the ORCA", pt_BR="Convergência do ORCA")
SOURCE = "Cerbaro 2022, §4.4.3, dem. 1, fig. 30"
ROBOT = "orca"
ABOUT = Text(
    en="From home the arm is to come to (260, 180) mm with its gripper level. Each step goes a constant share of the "
    "way that the Jacobian shows; the larger the share, the fewer the steps, as long as the arm bends little.",
    pt_BR="Da posição de origem (home) o braço deve chegar a (260, 180) mm com a garra nivelada. Cada passo percorre "
    "uma fração constante do caminho que o jacobiano indica; quanto maior a fração, menos passos, enquanto o braço se "
    "dobra pouco no trajeto.",
)
TARGET = (0.26, 0.18)
# Found by tests/studies/fits/cerbaro_convergence.py.
FACTOR = 0.56
OPEN = Interpretation(
    INFERRED.format(factor=FACTOR, count=7, least=0.532, most=0.59),
    OTHER_FACTOR.format(count=15, factor=0.3, other="Movemaster"),
)


@dataclass(frozen=True)
class Options:
    """factor: κ, which the source does not give."""

    factor: Annotated[float, Quantity(STEP_FACTOR, 0.1, 1.0)] = FACTOR


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Newton's steps (λ = 0) to 1 mm and 0.01 rad; a quick run is the whole."""
    orca = setups.orca()
    aiming = setups.heading_task(orca, setups.fixed_point(*TARGET))
    coming = ConvergenceCase(
        orca, aiming, Statement(untranslated("7"), "§4.4.3, fig. 30", 7), OPEN, (0.3, 0.5, 1.0), "fig. 30"
    )
    return convergence_result(coming, options.factor, 0.0)
