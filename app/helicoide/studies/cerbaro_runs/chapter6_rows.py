"""Statements of §6.2 and §6.3 about the paths in an enclosure, and numbers that distinguish the rules."""

from __future__ import annotations

import numpy as np

from helicoide.ik.adaptation import CAP, MARGIN
from helicoide.ik.limit_gains import GROWTH
from helicoide.studies.cerbaro_runs.chapter6_runs import (
    CONSTRAINED_STEP,
    CRITICAL,
    ConfinedRuns,
    Options,
    RuleKind,
    run_title,
)
from helicoide.studies.cerbaro_runs.confined import (
    CEILING,
    ELLIPSE,
    WALLS_AND_BENCH,
    ConfinedRun,
    confined_problem,
    limit_margins,
)
from helicoide.studies.cerbaro_runs.runs import FARTHER, NEAREST, mean_cost
from helicoide.studies.study import BY_CONSTRUCTION, Fitted, Interpretation, Row, Statement, printed_statement
from helicoide.text import Text, untranslated
from helicoide.trajectory import Ellipse

SAID = "§6.2–6.3"
NEVER_BELOW = Statement(
    Text(en="never below the critical 80 mm", pt_BR="nunca abaixo da crítica, de 80 mm"), SAID, CRITICAL, "≥", 1e-3
)
INSIDE = Statement(
    Text(en="without crossing the physical limits", pt_BR="sem cruzar os limites físicos"), "§6.3", 0.0, "≥", 1e-3
)
OUTSIDE = Statement(Text(en="case 1 leaves the joint limits", pt_BR="o caso 1 sai dos limites"), SAID, 0.0, "<")
# A degree: where a target gives way in one case only, the two lead the tool through slightly different points.
NOT_J1 = Statement(Text(en="J1 never changes", pt_BR="J1 nunca muda"), SAID, 1.0, "<")
# A tenth of the path at least, that what is said of it can be seen.
ON_BORDER = Statement(
    Text(en="parts stay on the border critical / warning", pt_BR="partes ficam na borda entre crítica e alerta"),
    "§6.2.2",
    10.0,
    "≥",
)
CASE_1_MORE = Statement(
    Text(en="case 1 deviates more than cases 2 and 3", pt_BR="o caso 1 desvia mais que os casos 2 e 3"),
    "§6.3",
    0.0,
    ">",
)
GAIN = Fitted(untranslated("k₀"), Options().gain, 1300.0, 3000.0, "1/s")
SAMPLED = Interpretation(
    Text(en="301 points to 1 mm", pt_BR="301 pontos a 1 mm"),
    Text(
        en="with 30 000 points to 10 mm, as in the source, case 2 passes a limit by 0.4° on the circle, and the other "
        "sentences come out alike",
        pt_BR="com 30 000 pontos a 10 mm, como na fonte, o caso 2 passa 0,4° de um limite no círculo, e as outras "
        "frases saem iguais",
    ),
)
EQ_36 = Interpretation(
    Text(en="eq. 36 put right", pt_BR="eq. 36 corrigida"),
    Text(
        en="with its normal inward and its tenth as printed, the arm comes to rest 72.7 mm from the ceiling",
        pt_BR="com a normal para dentro e o décimo como impresso, o braço para a 72,7 mm do teto",
    ),
)
EQ_37 = Interpretation(
    Text(en="eq. 37 by the wanted path", pt_BR="eq. 37 pelo caminho desejado"),
    Text(
        en="with the former target as it ended, a point of the arm is on the border during 0.3 % of the ellipse",
        pt_BR="com o alvo anterior já adaptado, um ponto do braço fica na borda durante 0,3 % da elipse",
    ),
)
BORDER = Interpretation(
    Text(en="border = 80 to 88 mm", pt_BR="borda = 80 a 88 mm"),
    Text(en="80 to 82 mm during 25 % of the path", pt_BR="de 80 a 82 mm durante 25 % do caminho"),
)
RULE_INTERPRETATIONS, GAIN_INTERPRETATIONS = (SAMPLED, EQ_36, EQ_37), (GAIN, SAMPLED, EQ_36, EQ_37)
BEYOND_REACH = Text(
    en="with the orientation held, part of the path is beyond reach, whatever the gains; what is done there is not "
    "told",
    pt_BR="com a orientação mantida, parte do caminho está fora do alcance, sejam quais forem os ganhos; o que se faz "
    "ali não é informado",
)
FOLLOWED = Text(
    en="held, the arm stays below the ceiling and is trimmed at the walls alone; free, its elbow rises to the ceiling",
    pt_BR="com a orientação mantida, o braço fica abaixo do teto e só é recortado nas paredes; livre, o cotovelo sobe "
    "até o teto",
)
HELD_BACK_TARGET = Text(
    en="in this reading one target holds back all that follow, and the arm stays away from the border",
    pt_BR="nesta leitura um alvo retém todos os seguintes, e o braço fica longe da borda",
)


def sentence_rows(runs: ConfinedRuns, path: Ellipse, options: Options) -> tuple[Row, ...]:
    """Rows about the sentences of the source, by its rule with eq. 36 corrected, for the points that it monitors."""
    cases, ratchets = runs.cases, options.former == "adapted"
    least = {case: limit_margins(confined_problem(), course.q) for case, course in cases.items()}
    worst = int(least[1].argmin())
    more = cases[1].deviation - max(cases[2].deviation, cases[3].deviation)
    staying = ON_BORDER if path is ELLIPSE else None
    free = (cases[2], cases[3])
    return (
        Row(_TOOL_TO_WALLS, min(tool_wall_clearance(course) for course in free), "mm", NEVER_BELOW, (GAIN, SAMPLED)),
        Row(
            _TO_CEILING.format(of=_FREE),
            min(ceiling_clearance(course) for course in free),
            "mm",
            NEVER_BELOW,
            GAIN_INTERPRETATIONS,
        ),
        *(Row(_TO_WALLS.format(case=case), float(cases[case].least_distances[1:].min()), "mm") for case in (2, 3)),
        _error(Text(en="case 1", pt_BR="caso 1"), float(1000 * cases[1].errors.max()), options),
        _error(_FREE, float(1000 * max(cases[case].errors.max() for case in (2, 3))), options),
        Row(_MARGIN.format(case=1, joint=f"J{worst + 1}"), float(least[1].min()), "°", OUTSIDE, RULE_INTERPRETATIONS),
        Row(_MARGIN.format(case=2, joint=_A_JOINT), float(least[2].min()), "°", INSIDE, GAIN_INTERPRETATIONS),
        Row(_FARTHER_BY, limit_margin_gain(cases[3], cases[2]), "°", FARTHER, (NEAREST, *GAIN_INTERPRETATIONS)),
        Row(_J1, float(np.degrees(np.abs(cases[3].q - cases[2].q)[:, 0].max())), "°", NOT_J1, GAIN_INTERPRETATIONS),
        Row(
            _SHARE.format(of=_CASE_3),
            border_share(cases[3]),
            "%",
            staying,
            (BORDER, *GAIN_INTERPRETATIONS) if staying else (),
            why=HELD_BACK_TARGET if ratchets else None,
        ),
        Row(_MORE, more, "mm", CASE_1_MORE, GAIN_INTERPRETATIONS, why=HELD_BACK_TARGET if ratchets else FOLLOWED),
    )


def number_rows(runs: ConfinedRuns) -> tuple[Row, ...]:
    """Rows about eq. 36 as printed, and numbers that distinguish the rules."""
    rows: list[Row] = []
    for (kind, case), course in runs.runs.items():
        of = run_title(kind, case)
        if kind is RuleKind.PRINTED:
            least = ceiling_clearance(course)
            rows.append(Row(_TO_CEILING.format(of=of), least, "mm", NEVER_BELOW, erratum="cerbaro-23"))
            rows.append(Row(_GIVEN_UP, int((course.target_moves >= CAP).sum())))
        elif kind is RuleKind.STEADY:
            rows.append(Row(_FARTHER_STEADY, limit_margin_gain(course, runs.cases[2]), "°"))
        elif kind is not RuleKind.TRIMMED:
            rows.append(_deviation(of, course))
        if kind in (RuleKind.TRIMMED, RuleKind.PLANES):
            rows.append(Row(_NEAREST.format(of=of), float(course.least_distances.min()), "mm"))
    one, grown = (mean_cost(confined_problem(), runs.cases[case].q) for case in (2, 3))
    rows.append(Row(_MEAN, grown / one))
    rows.append(Row(_CLIPS, float(np.log(runs.cases[3].gains / runs.cases[2].gains).sum() / np.log(GROWTH))))
    rows.append(Row(_SHARE.format(of=run_title(RuleKind.OTHER, 3)), border_share(runs.runs[RuleKind.OTHER, 3]), "%"))
    guard = runs.constrained
    rows.append(Row(_NEAREST.format(of=CONSTRAINED_STEP), float(guard.least_distances.min()), "mm"))
    rows.append(Row(_INSIDE.format(of=CONSTRAINED_STEP), float(limit_margins(confined_problem(), guard.q).min()), "°"))
    return (*rows, _deviation(CONSTRAINED_STEP, guard))


def tool_wall_clearance(course: ConfinedRun) -> float:
    """Least distance of the tool to walls and bench, mm; the source monitors only the tool for them."""
    planes, others = confined_problem().planes, list(WALLS_AND_BENCH)
    return float(1000 * (course.tool @ planes.normals[others].T - planes.offsets[others]).min())


def ceiling_clearance(course: ConfinedRun) -> float:
    """Least distance of any point to the ceiling, mm."""
    return float(course.least_distances[CEILING])


def limit_margin_gain(course: ConfinedRun, other: ConfinedRun) -> float:
    """The least margin to a joint limit minus that of another run, degrees."""
    return float(limit_margins(confined_problem(), course.q).min() - limit_margins(confined_problem(), other.q).min())


def border_share(course: ConfinedRun) -> float:
    """Share of samples, %, whose nearest point is between δ_c and 1.1 δ_c, the distance set by eq. 36."""
    near = 1000 * course.distances.min(axis=1)
    return float(100 * ((near >= CRITICAL - 1e-6) & (near <= MARGIN * CRITICAL)).mean())


_FREE = Text(en="cases 2 and 3", pt_BR="casos 2 e 3")
_CASE_3 = Text(en="case 3", pt_BR="caso 3")
_A_JOINT = Text(en="any joint", pt_BR="qualquer junta")
_MARGIN = Text(
    en="case {case}: least margin of {joint} to its limits", pt_BR="caso {case}: menor folga de {joint} aos limites"
)
_FARTHER_BY = Text(en="least margin of case 3 less that of case 2", pt_BR="menor folga do caso 3 menos a do caso 2")
_FARTHER_STEADY = Text(
    en="least margin of case 3 with gains that do not grow, less that of case 2",
    pt_BR="menor folga do caso 3 com ganhos que não crescem, menos a do caso 2",
)
_MEAN = Text(
    en="mean of −w (eq. 12) in case 3, over that in case 2", pt_BR="média de −w (eq. 12) no caso 3, sobre a do caso 2"
)
_J1 = Text(en="largest difference of J1 between cases 2 and 3", pt_BR="maior diferença de J1 entre os casos 2 e 3")
_SHARE = Text(
    en="{of}: share of the path with a point at 80 to 88 mm",
    pt_BR="{of}: fração do caminho com um ponto entre 80 e 88 mm",
)
_MORE = Text(
    en="mean deviation of case 1 less the larger of cases 2 and 3",
    pt_BR="desvio médio do caso 1 menos o maior dos casos 2 e 3",
)
_CLIPS = Text(
    en="how often Algorithm 1 clips a joint, from home on",
    pt_BR="quantas vezes o Algoritmo 1 satura uma junta, desde a posição de origem",
)
_GIVEN_UP = Text(
    en="samples at which eq. 36 with its tenth as printed is given up",
    pt_BR="amostras em que se desiste da eq. 36 com o décimo impresso",
)
_NEAREST = Text(en="{of}: least distance", pt_BR="{of}: menor distância")
_TO_CEILING = Text(en="{of}: least distance to the ceiling", pt_BR="{of}: menor distância ao teto")
_TOOL_TO_WALLS = Text(
    en="cases 2 and 3: least distance of the end effector to walls and bench",
    pt_BR="casos 2 e 3: menor distância do efetuador a paredes e bancada",
)
_TO_WALLS = Text(
    en="case {case}: least distance of any point, monitored or not, to walls and bench",
    pt_BR="caso {case}: menor distância de qualquer ponto, monitorado ou não, a paredes e bancada",
)
_INSIDE = Text(en="{of}: least joint margin", pt_BR="{of}: menor folga de junta")


def _error(of: Text, largest: float, options: Options) -> Row:
    """The largest position error, mm; no result if all points are reached, as the tolerance then bounds it."""
    quantity = Text(en="{of}: largest position error", pt_BR="{of}: maior erro de posição").format(of=of)
    given = BY_CONSTRUCTION if largest <= options.tolerance else None
    return Row(quantity, largest, "mm", printed_statement("< 10", SAID), why=BEYOND_REACH, given=given)


def _deviation(of: Text, course: ConfinedRun) -> Row:
    quantity = Text(en="{of}: mean deviation from the path", pt_BR="{of}: desvio médio do caminho")
    return Row(quantity.format(of=of), course.deviation, "mm")
