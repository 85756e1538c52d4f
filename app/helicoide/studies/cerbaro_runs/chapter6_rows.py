"""What §6.2 and §6.3 say of the paths in an enclosure, and numbers of ours that tell the rules apart."""

from __future__ import annotations

import numpy as np

from helicoide.ik.adaptation import CAP, MARGIN
from helicoide.ik.limit_gains import GROWTH
from helicoide.studies.cerbaro_runs.chapter6_runs import CRITICAL, GUARDED, PLANES, Kind, Options, Runs, title
from helicoide.studies.cerbaro_runs.confined import CEILING, Course, confined, margins
from helicoide.studies.study import Fitted, Row, Statement, printed
from helicoide.text import Text, same

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
    SAID,
    0.0,
    ">",
)
# A figure would show a degree; the two runs need not lead the tool through the very same points.
NOT_J1 = Statement(Text(en="J1 never changes", pt_BR="J1 nunca muda"), SAID, 1.0, "<")
# A tenth of the turn at least, that what is said of it can be seen.
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
BEYOND_REACH = Text(
    en="with the orientation held, part of the path is beyond reach, whatever the gains",
    pt_BR="com a orientação mantida, parte do caminho está fora do alcance, sejam quais forem os ganhos",
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


def sentences(runs: Runs, options: Options) -> tuple[Row, ...]:
    """What the source says in words, by the rule for all planes; with other rules where they were run."""
    cases, ratchets = runs.cases, options.former == "adapted"
    reading = _ADAPTED if ratchets else _WANTED
    rows = [_least(title(Kind.PLANES, case), course) for case, course in cases.items()]
    rows += [_error(case, course) for case, course in cases.items()]
    least = {case: margins(confined(), course.q) for case, course in cases.items()}
    worst = int(least[1].argmin())
    rows += [
        Row(_margin(1, f"J{worst + 1}"), float(least[1].min()), "°", OUTSIDE),
        Row(_margin(2, _A_JOINT), float(least[2].min()), "°", INSIDE, (GAIN,)),
        Row(_FARTHER_BY, float(least[3].min() - least[2].min()), "°", FARTHER, (GAIN,)),
        Row(_J1, float(np.degrees(np.abs(cases[3].q - cases[2].q)[:, 0].max())), "°", NOT_J1),
        Row(_SHARE.format(of=reading), border(cases[3]), "%", ON_BORDER, why=RATCHET if ratchets else None),
    ]
    more = cases[1].deviation - max(cases[2].deviation, cases[3].deviation)
    rows.append(Row(_MORE.format(of=reading), more, "mm", CASE_1_MORE, why=RATCHET if ratchets else FOLLOWED))
    return tuple(rows)


def numbers(runs: Runs) -> tuple[Row, ...]:
    """The source's rule as it stands, and numbers of ours that tell the rules apart."""
    rows: list[Row] = []
    for (kind, case), course in runs.courses.items():
        if kind is Kind.PRINTED:
            rows.append(_to_ceiling(title(kind, case), course, "cerbaro-23"))
            rows.append(Row(_GIVEN_UP, int((course.moved >= CAP).sum())))
        elif kind is Kind.CEILING:
            rows.append(_to_ceiling(title(kind, case), course))
            rows.append(_to_walls(title(kind, case), course))
        elif kind in (Kind.TRIMMED, Kind.UNDAMPED):
            rows.append(Row(_NEAREST.format(of=title(kind, case)), float(course.least.min()), "mm"))
        if kind in (Kind.PLANES, Kind.OTHER, Kind.UNDAMPED):
            rows.append(_deviation(title(kind, case), course))
    other = title(Kind.OTHER, 3)
    rows.append(Row(_CLIPS, float(np.log(runs.cases[3].gains / runs.cases[2].gains).sum() / np.log(GROWTH))))
    rows.append(Row(_SHARE.format(of=same("{of}: ").format(of=other)), border(runs.courses[Kind.OTHER, 3]), "%"))
    guard = runs.guard
    rows.append(Row(_NEAREST.format(of=GUARDED), float(guard.least.min()), "mm"))
    rows.append(Row(_INSIDE.format(of=GUARDED), float(margins(confined(), guard.q).min()), "°"))
    return (*rows, _deviation(GUARDED, guard))


def border(course: Course) -> float:
    """Share of the samples in which the nearest point is between δ_c and 1.1 δ_c, to which eq. 36 sends it, %."""
    near = 1000 * course.near.min(axis=1)
    return float(100 * ((near >= CRITICAL - 1e-6) & (near <= MARGIN * CRITICAL)).mean())


_A_JOINT = Text(en="any joint", pt_BR="qualquer junta")
_FARTHER_BY = Text(en="least margin of case 3 less that of case 2", pt_BR="menor folga do caso 3 menos a do caso 2")
_J1 = Text(
    en="largest difference of J1 between cases 2 and 3, where a figure shows 1°",
    pt_BR="maior diferença de J1 entre os casos 2 e 3, onde uma figura mostra 1°",
)
# The reading of eq. 37 was chosen: with the other one the sentences do not all hold.
_WANTED = Text(en="eq. 37 with the former point of the path: ", pt_BR="eq. 37 com o ponto anterior do caminho: ")
_ADAPTED = Text(en="eq. 37 with the former target: ", pt_BR="eq. 37 com o alvo anterior: ")
_SHARE = Text(
    en="{of}share of the turn with a point at 80 to 88 mm", pt_BR="{of}fração da volta com um ponto entre 80 e 88 mm"
)
_MORE = Text(
    en="{of}mean deviation of case 1 less the larger of cases 2 and 3",
    pt_BR="{of}desvio médio do caso 1 menos o maior dos casos 2 e 3",
)
_CLIPS = Text(
    en="how often Algorithm 1 stops a joint, from home on",
    pt_BR="quantas vezes o Algoritmo 1 detém uma junta, desde a origem",
)
_GIVEN_UP = Text(en="samples at which eq. 36 as printed is given up", pt_BR="amostras em que a eq. 36 impressa desiste")
_NEAREST = Text(en="{of}: least distance", pt_BR="{of}: menor distância")
_INSIDE = Text(en="{of}: least joint margin", pt_BR="{of}: menor folga de junta")


def _least(of: Text, course: Course) -> Row:
    return Row(_NEAREST.format(of=of), float(course.least.min()), "mm", NEVER_BELOW)


def _to_ceiling(of: Text, course: Course, erratum: str = "") -> Row:
    quantity = Text(en="{of}: least distance to the ceiling", pt_BR="{of}: menor distância ao teto").format(of=of)
    return Row(quantity, float(course.least[CEILING]), "mm", NEVER_BELOW, erratum=erratum)


def _to_walls(of: Text, course: Course) -> Row:
    """The least distance to a wall or the bench; where the tool keeps away from it, it is what the source overlooks."""
    worst, planes = int(course.least[1:].argmin()) + 1, confined().planes
    of_tool = 1000 * float((course.tool @ planes.normals[worst]).min() - planes.offsets[worst])
    erratum = "cerbaro-24" if of_tool >= CRITICAL else ""
    quantity = Text(en="{of}: least distance to {plane}", pt_BR="{of}: menor distância a {plane}")
    named = quantity.format(of=of, plane=PLANES[worst])
    return Row(named, float(course.least[worst]), "mm", NEVER_BELOW, erratum=erratum)


def _error(case: int, course: Course) -> Row:
    quantity = Text(en="case {case}: largest position error", pt_BR="caso {case}: maior erro de posição")
    largest = float(1000 * course.errors.max())
    return Row(quantity.format(case=case), largest, "mm", printed("< 10", SAID), why=BEYOND_REACH)


def _margin(case: int, joint: str | Text) -> Text:
    return Text(
        en="case {case}: least margin of {joint} to its limits", pt_BR="caso {case}: menor folga de {joint} aos limites"
    ).format(case=case, joint=joint)


def _deviation(of: Text, course: Course) -> Row:
    quantity = Text(en="{of}: mean deviation from the path", pt_BR="{of}: desvio médio do caminho")
    return Row(quantity.format(of=of), course.deviation, "mm")
