"""The Movemaster from home to its target with five tasks, a constant share of the error a step."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

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

TITLE = Text(en="Convergence of the Movemaster", pt_BR="Convergência do Movemaster")
SOURCE = "Cerbaro 2022, §4.4.4, dem. 1, fig. 34"
ROBOT = "movemaster"
ABOUT = Text(
    en="From home the end effector is to come to (440, 0, 200) mm, pointing 60° below level. Five joints have five "
    "tasks, and no freedom is left. How many steps it takes depends on the share κ of the error that each step "
    "removes, which the source leaves open: with 0.3 it takes the 17 that are printed; with 0.56, which suits the "
    "ORCA, it takes 8. The posture that is reached lies outside the limit of J3. The λ that is printed has no unit: "
    "we suppose that of J, mm/rad.",
    pt_BR="Da posição de origem (home) o efetuador deve chegar a (440, 0, 200) mm, apontando 60° abaixo da horizontal. "
    "Cinco juntas têm cinco tarefas, e não sobra liberdade. Quantos passos são precisos depende da fração κ do erro "
    "que cada um percorre, e a fonte a deixa em aberto: com 0,3 são os 17 impressos, com o 0,56 que serve ao ORCA, 8. "
    "A postura alcançada fica fora do limite de J3. O λ impresso não tem unidade: supomos a de J, mm/rad.",
)
TARGET, PITCH = (0.44, 0.0, 0.2), -np.pi / 3
# Found by tests/studies/fits/cerbaro_convergence.py.
FACTOR = 0.3
OPEN = Interpretation(
    INFERRED.format(factor=FACTOR, count=17, least=0.288, most=0.302),
    OTHER_FACTOR.format(count=8, factor=0.56, other="ORCA"),
)


@dataclass(frozen=True)
class Options:
    """factor: κ, which the source does not give; damping: λ of the source."""

    factor: Annotated[float, Quantity(STEP_FACTOR, 0.1, 1.0)] = FACTOR
    damping: Annotated[float, Quantity(Text(en="damping λ", pt_BR="amortecimento λ"), 0.0, 10.0, "mm/rad")] = 0.1


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Damped steps to 1 mm and 0.01 rad; a quick run is the whole."""
    movemaster = setups.movemaster()
    aiming = setups.pitch_and_roll_task(movemaster, setups.fixed_point(*TARGET), PITCH)
    coming = ConvergenceCase(
        movemaster, aiming, Statement(untranslated("17"), "§4.4.4, fig. 34", 17), OPEN, (0.5, 0.56, 1.0), "fig. 34"
    )
    return convergence_result(coming, options.factor, options.damping)
