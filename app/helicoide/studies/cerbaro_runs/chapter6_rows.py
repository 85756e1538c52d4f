"""What §6.2 and §6.3 say of the paths in an enclosure, and numbers of ours that tell the rules apart."""

from __future__ import annotations

import numpy as np

from helicoide.ik.adaptation import CAP, MARGIN
from helicoide.ik.limit_gains import GROWTH
from helicoide.studies.cerbaro_runs.chapter6_runs import CRITICAL, GUARDED, Kind, Options, Runs, title
from helicoide.studies.cerbaro_runs.confined import CEILING, ELLIPSE, Course, confined, margins
from helicoide.studies.study import CONSTRUCTED, Fitted, Reading, Row, Statement, printed
from helicoide.text import Text, same
from helicoide.trajectory import Ellipse

SAID = "§6.2–6.3"
NEVER_BELOW = Statement(
    Text(en="never below the critical 80 mm", pt_BR="nunca abaixo da crítica, de 80 mm"), SAID, CRITICAL, "≥", 1e-3
)
INSIDE = Statement(
    Text(en="without crossing the physical limits", pt_BR="sem cruzar os limites físicos"), "§6.3", 0.0, "≥", 1e-3
)
OUTSIDE = Statement(Text(en="case 1 leaves the joint limits", pt_BR="o caso 1 sai dos limites"), SAID, 0.0, "<")
FARTHER = Statement(
    Text(en="Algorithm 1 keeps joints farther from limits", pt_BR="o Algoritmo 1 mantém as juntas mais longe"),
    "§6.3",
    0.0,
    ">",
)
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
GAIN = Fitted(same("k₀"), Options().gain, 1300.0, 3000.0, "1/s")
EQ_36 = Reading(
    Text(en="eq. 36 with the tenth on the critical distance", pt_BR="a eq. 36 com o décimo na distância crítica"),
    Text(
        en="as printed the arm comes to rest 72.7 mm from the ceiling",
        pt_BR="como impressa, o braço para a 72,7 mm do teto",
    ),
)
EQ_37 = Reading(
    Text(
        en="eq. 37 with the former point of the wanted path", pt_BR="a eq. 37 com o ponto anterior do caminho desejado"
    ),
    Text(
        en="with the former target as it ended 0.3 % of the path",
        pt_BR="com o alvo anterior já adaptado, 0,3 % do caminho",
    ),
)
BEYOND_REACH = Text(
    en="with the orientation held, part of the path is beyond reach, whatever the gains; what is done there is not "
    "told",
    pt_BR="com a orientação mantida, parte do caminho está fora do alcance, sejam quais forem os ganhos; o que se faz "
    "ali não é informado",
)
FOLDED = Text(
    en="the tool folds back and the wrist comes before it, which is watched against the ceiling only; how far the arm "
    "folds is a matter of k₀, which is not given",
    pt_BR="o efetuador se dobra para trás e o punho, que só é vigiado contra o teto, fica à frente dele; quanto o "
    "braço se dobra depende de k₀, que não é informado",
)
FOLLOWED = Text(
    en="held, the arm stays below the ceiling and is trimmed at the walls alone; free, its elbow rises to the ceiling",
    pt_BR="com a orientação mantida, o braço fica abaixo do teto e só é recortado nas paredes; livre, o cotovelo sobe "
    "até o teto",
)
RATCHET = Text(
    en="in this reading one target holds back all that follow, and the arm stays away from the border",
    pt_BR="nesta leitura um alvo retém todos os seguintes, e o braço fica longe da borda",
)


def sentences(runs: Runs, path: Ellipse, options: Options) -> tuple[Row, ...]:
    """What the source says in words, by its own rule with eq. 36 put right."""
    cases, ratchets = runs.cases, options.former == "adapted"
    least = {case: margins(confined(), course.q) for case, course in cases.items()}
    worst = int(least[1].argmin())
    more = cases[1].deviation - max(cases[2].deviation, cases[3].deviation)
    staying = ON_BORDER if path is ELLIPSE else None
    reading = () if ratchets or staying is None else (EQ_37,)
    return (
        *(
            Row(
                _TO_WALLS.format(case=case), float(cases[case].least[1:].min()), "mm", NEVER_BELOW, (EQ_36,), why=FOLDED
            )
            for case in (2, 3)
        ),
        Row(
            _TO_CEILING.format(of=_FREE),
            float(min(cases[case].least[CEILING] for case in (2, 3))),
            "mm",
            NEVER_BELOW,
            given=CONSTRUCTED,
        ),
        _error(Text(en="case 1", pt_BR="caso 1"), float(1000 * cases[1].errors.max()), options),
        _error(_FREE, float(1000 * max(cases[case].errors.max() for case in (2, 3))), options),
        Row(_MARGIN.format(case=1, joint=f"J{worst + 1}"), float(least[1].min()), "°", OUTSIDE),
        Row(_MARGIN.format(case=2, joint=_A_JOINT), float(least[2].min()), "°", INSIDE, (GAIN,)),
        Row(_FARTHER_BY, float(least[3].min() - least[2].min()), "°", FARTHER, (GAIN,)),
        Row(_J1, float(np.degrees(np.abs(cases[3].q - cases[2].q)[:, 0].max())), "°", NOT_J1),
        Row(_SHARE.format(of=_CASE_3), border(cases[3]), "%", staying, reading, why=RATCHET if ratchets else None),
        Row(_MORE, more, "mm", CASE_1_MORE, why=RATCHET if ratchets else FOLLOWED),
    )


def numbers(runs: Runs) -> tuple[Row, ...]:
    """Eq. 36 as it is printed, and numbers of ours that tell the rules apart."""
    rows: list[Row] = []
    for (kind, case), course in runs.courses.items():
        of = title(kind, case)
        if kind is Kind.PRINTED:
            least = float(course.least[CEILING])
            rows.append(Row(_TO_CEILING.format(of=of), least, "mm", NEVER_BELOW, erratum="cerbaro-23"))
            rows.append(Row(_GIVEN_UP, int((course.moved >= CAP).sum())))
        elif kind is not Kind.TRIMMED:
            rows.append(_deviation(of, course))
        if kind in (Kind.TRIMMED, Kind.PLANES):
            rows.append(Row(_NEAREST.format(of=of), float(course.least.min()), "mm"))
    rows.append(Row(_CLIPS, float(np.log(runs.cases[3].gains / runs.cases[2].gains).sum() / np.log(GROWTH))))
    rows.append(Row(_SHARE.format(of=title(Kind.OTHER, 3)), border(runs.courses[Kind.OTHER, 3]), "%"))
    guard = runs.guard
    rows.append(Row(_NEAREST.format(of=GUARDED), float(guard.least.min()), "mm"))
    rows.append(Row(_INSIDE.format(of=GUARDED), float(margins(confined(), guard.q).min()), "°"))
    return (*rows, _deviation(GUARDED, guard))


def border(course: Course) -> float:
    """Share of the samples in which the nearest point is between δ_c and 1.1 δ_c, to which eq. 36 sends it, %."""
    near = 1000 * course.near.min(axis=1)
    return float(100 * ((near >= CRITICAL - 1e-6) & (near <= MARGIN * CRITICAL)).mean())


_FREE = Text(en="cases 2 and 3", pt_BR="casos 2 e 3")
_CASE_3 = Text(en="case 3", pt_BR="caso 3")
_A_JOINT = Text(en="any joint", pt_BR="qualquer junta")
_MARGIN = Text(
    en="case {case}: least margin of {joint} to its limits", pt_BR="caso {case}: menor folga de {joint} aos limites"
)
_FARTHER_BY = Text(en="least margin of case 3 less that of case 2", pt_BR="menor folga do caso 3 menos a do caso 2")
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
    pt_BR="quantas vezes o Algoritmo 1 corta uma junta, desde a posição de origem",
)
_GIVEN_UP = Text(en="samples at which eq. 36 as printed is given up", pt_BR="amostras em que a eq. 36 impressa desiste")
_NEAREST = Text(en="{of}: least distance", pt_BR="{of}: menor distância")
_TO_CEILING = Text(en="{of}: least distance to the ceiling", pt_BR="{of}: menor distância ao teto")
_TO_WALLS = Text(
    en="case {case}: least distance to walls and bench", pt_BR="caso {case}: menor distância a paredes e bancada"
)
_INSIDE = Text(en="{of}: least joint margin", pt_BR="{of}: menor folga de junta")


def _error(of: Text, largest: float, options: Options) -> Row:
    """The largest error of position, mm; where all points are reached it is what the inner loop was asked for."""
    quantity = Text(en="{of}: largest position error", pt_BR="{of}: maior erro de posição").format(of=of)
    given = CONSTRUCTED if largest <= options.tolerance else None
    return Row(quantity, largest, "mm", printed("< 10", SAID), why=BEYOND_REACH, given=given)


def _deviation(of: Text, course: Course) -> Row:
    quantity = Text(en="{of}: mean deviation from the path", pt_BR="{of}: desvio médio do caminho")
    return Row(quantity.format(of=of), course.deviation, "mm")
