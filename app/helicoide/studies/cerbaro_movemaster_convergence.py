"""The Movemaster from home to its target with five tasks, a constant share of the error a step."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.ik.method import Quantity
from helicoide.studies.cerbaro_runs import arms
from helicoide.studies.cerbaro_runs.convergence import Coming, result
from helicoide.studies.study import Progress, Result
from helicoide.text import Text

TITLE = Text(en="Convergence of the Movemaster", pt_BR="Convergência do Movemaster")
SOURCE = "Cerbaro 2022, §4.4.4, dem. 1, fig. 34"
ROBOT = "movemaster"
ABOUT = Text(
    en="From home the tool is to come to (440, 0, 200) mm, pointing 60° below level. Five joints have five tasks, and "
    "no freedom is left; damping changes the count of steps as little as the source says. The posture that is reached "
    "lies outside the limit of J3.",
    pt_BR="Da origem o efetuador deve chegar a (440, 0, 200) mm, apontando 60° abaixo da horizontal. Cinco juntas têm "
    "cinco tarefas, e não sobra liberdade; o amortecimento quase não muda o número de passos. A postura alcançada fica "
    "fora do limite de J3.",
)
TARGET, PITCH = (0.44, 0.0, 0.2), -np.pi / 3


@dataclass(frozen=True)
class Options:
    """factor: κ, which the source does not give; damping: λ of the source."""

    factor: Annotated[float, Quantity(Text(en="step factor κ", pt_BR="fator de passo κ"), 0.1, 1.0)] = 0.3
    damping: Annotated[float, Quantity(Text(en="damping λ", pt_BR="amortecimento λ"), 0.0, 10.0, "mm/rad")] = 0.1


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Damped steps to 1 mm and 0.01 rad; the short form is the whole."""
    movemaster = arms.movemaster()
    aiming = arms.with_pitch_and_roll(movemaster, arms.standing(*TARGET), PITCH)
    counts = {0.3: 17, 0.5: 9, 1.0: 4}
    coming = Coming(movemaster, aiming, 17, counts, (0, 56.424, -129.943, 13.519, 0), 3)
    return result(coming, options.factor, options.damping)
