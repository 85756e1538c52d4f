"""Sim. 6 of Vargas 2013: the stretched planar arm is asked to draw in along itself, which no joint can begin."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import pi

from helicoide.studies.study import Interpretation, Progress, Result, Row
from helicoide.studies.vargas.paths import path_4
from helicoide.studies.vargas.planar import FITTED, LENGTH, VALUES, planar_result, run_on_planar
from helicoide.studies.vargas.readings import links
from helicoide.studies.vargas.runs import (
    MethodRun,
    MethodSettings,
    TimeMask,
    first_motion_time,
    largest_absolute,
    method_settings,
)
from helicoide.studies.vargas.table import MOTION_THRESHOLD, SMALL, Gain, Step, run_row, sentence_statement
from helicoide.text import Text, untranslated

TITLE = Text(en="Simulation 6: a singular start", pt_BR="Simulação 6: partida singular")
SOURCE = "Vargas 2013, §3.5, sim. 6, figs. 3.12–3.13"
ABOUT = Text(
    en="""The arm is stretched, and the path leads straight inwards: at first no joint moves the end effector that \
way. Look at who leaves: damped least squares and the modified filtered inverse never do, since their answer has no \
part along the lost direction. The feedback leaves, because its G is not diagonal and lets one coordinate push the \
other, and so does the filtered inverse whose Θ is not zero at the start.""",
    pt_BR="""O braço está esticado e o caminho aponta direto para dentro: no início nenhuma junta move o efetuador \
nessa direção. Veja quem sai: a inversa amortecida e a filtrada modificada nunca saem, pois sua resposta não tem \
componente na direção perdida. A realimentada sai, porque seu G não é diagonal e faz uma coordenada empurrar a outra; \
sai também a inversa filtrada cujo Θ inicial não é zero.""",
)
ROBOT = "planar3r"
PATH, START, PLACE = path_4, (pi / 2, 0, 0), "sim. 6, figs. 3.12–3.13"
ORIGIN = 30.0
BEFORE_IT = Interpretation(
    Text(
        en="read until 30 s, before the origin, where both methods deviate",
        pt_BR="lido até 30 s, antes da origem, onde ambos os métodos se desviam",
    ),
    Text(en="in the whole run 0.26 ℓ", pt_BR="na execução inteira, 0,26 ℓ"),
)
ON_LINKS = links(
    Text(
        en="with 1, 2, 1 and the same values it leaves too, but the error until 30 s is 0.22 ℓ",
        pt_BR="com 1; 2; 1 e os mesmos valores também sai, mas o erro até 30 s é 0,22 ℓ",
    )
)
LEAVES = Text(en="time until some joint has moved by 0.01 rad", pt_BR="tempo até alguma junta mover-se 0,01 rad")
STAYS = Text(en="largest motion of a joint", pt_BR="maior movimento de uma junta")
FIRST = 2.0
EARLY = Interpretation(
    Text(en="read in the first 2 s", pt_BR="lido nos 2 s iniciais"),
    Text(
        en="in a longer time rounding alone moves the arm with c = 0 too",
        pt_BR="em mais tempo, só o arredondamento já move também o braço com c = 0",
    ),
)


@dataclass(frozen=True)
class Options:
    """gain: γ of the filtered inverses; dt, s."""

    gain: Gain = 5.0
    dt: Step = 1e-3

    @property
    def ways(self) -> dict[str, MethodSettings]:
        """The compared methods."""
        ones, zero = f"γ = {self.gain:g}, Θ(0) = 0.1", f"γ = {self.gain:g}, Θ(0) = 0"
        return {
            **compared_methods(VALUES.methods),
            "ones": method_settings("filtered", ones, gain=self.gain, start="ones"),
            "modified": method_settings("filtered_modified", zero, gain=self.gain),
            "modified_ones": method_settings("filtered_modified", ones, gain=self.gain, start="ones"),
        }


def compared_methods(ways: Mapping[str, MethodSettings]) -> dict[str, MethodSettings]:
    """Both methods, and the feedback with a diagonal G."""
    alone = method_settings("feedback", "c = 0", **{**ways["feedback"].options, "coupling": 0.0})
    return {**ways, "uncoupled": alone}


def departure_rows(runs: Mapping[str, MethodRun]) -> list[Row]:
    """Who leaves the start, and how far off the path it is."""
    fed_back, damped, uncoupled = (runs[key] for key in ("feedback", "damping", "uncoupled"))
    cannot = sentence_statement("cannot move", "não consegue se mover", PLACE, MOTION_THRESHOLD, "<")
    leaves = sentence_statement("leaves the start", "deixa a partida", PLACE, MOTION_THRESHOLD, "≥")
    small = sentence_statement("small error", "erro pequeno", PLACE, SMALL * LENGTH, "≤")
    needs = sentence_statement(
        "the start is left because G is not diagonal",
        "a partida é deixada porque G não é diagonal",
        "§3.4",
        MOTION_THRESHOLD,
        "<",
    )
    worst = Text(en="largest error until 30 s", pt_BR="maior erro até 30 s")
    early = Text(en="largest motion of a joint in the first 2 s", pt_BR="maior movimento de uma junta nos 2 s iniciais")
    begun = fed_back.t <= FIRST
    names, chosen = compared_methods(VALUES.methods), (*FITTED["feedback"], ON_LINKS)
    without_c = tuple(one for one in chosen if one.name != untranslated("c"))
    coupled = names["feedback"].title
    return [
        run_row(STAYS, names["damping"].title, _moved(damped), "rad", cannot),
        run_row(early, coupled, _moved(fed_back, begun), "rad", leaves, fitted=(*chosen, EARLY)),
        run_row(early, names["uncoupled"].title, _moved(uncoupled, begun), "rad", needs, fitted=(*without_c, EARLY)),
        run_row(
            worst,
            coupled,
            largest_absolute(fed_back.error_norm, fed_back.t <= ORIGIN),
            "ℓ",
            small,
            fitted=(*chosen, BEFORE_IT),
        ),
    ]


def _moved(run: MethodRun, when: slice | TimeMask = slice(None)) -> float:
    return largest_absolute((run.q - run.q[0])[when])


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Six methods on trajectory 4."""
    dt, ways = max(options.dt, 1e-2) if short else options.dt, options.ways
    runs = run_on_planar(PATH, START, ways, dt, progress)
    rows = departure_rows(runs)
    rows += [run_row(LEAVES, ways[key].title, first_motion_time(runs[key]), "s") for key in ("feedback", "ones")]
    rows += [run_row(STAYS, ways[key].title, _moved(runs[key]), "rad") for key in ("modified", "modified_ones")]
    return planar_result(rows, PATH, ways, runs, PLACE.partition(", ")[2])
