"""Faults of a study: its description, and the results of its short run."""

from __future__ import annotations

import re
from collections.abc import Iterator

import numpy as np

from helicoide import content, studies
from helicoide.contributions.loading import collected_faults, unusable
from helicoide.contributions.options import option_faults
from helicoide.contributions.words import missing_words
from helicoide.export import errata
from helicoide.kinematics.library import load_robot
from helicoide.studies.study import Fitted, Motion, Result, Row, Statement, Study, Verdict
from helicoide.text import LANGUAGES, Text, untranslated

BOUND = re.compile(r"(?P<sign>[<≤>≥])\s*(?P<number>[-−]?\d+(?:\.\d+)?)(?:\s.*)?")
ABOUT = Text(
    en="ABOUT has fewer than two sentences in {language}", pt_BR="ABOUT tem menos de duas frases em {language}"
)
SOURCE = Text(
    en="SOURCE is empty: author, year and place, or that it is your own",
    pt_BR="SOURCE está vazio: autor, ano e lugar, ou que é seu",
)
NO_ROWS = Text(en="it has no rows", pt_BR="não há linhas")
NO_CHARTS = Text(en="it has no charts", pt_BR="não há gráficos")
ROW = Text(en="row “{name}”: {what}", pt_BR="linha “{name}”: {what}")
NAN = Text(en="its number is no number", pt_BR="o número dela não é um número")
TWICE = Text(en="another row has the same name and unit", pt_BR="outra linha tem o mesmo nome e a mesma unidade")
NO_REASON = Text(
    en="it differs from its source, and why is not said", pt_BR="ela difere da fonte, e não se diz por quê"
)
AGAINST = Text(
    en="it counts as printed, and breaks the bound that is printed",
    pt_BR="ela conta como impressa e fere o limite impresso",
)
NO_ERRATUM = Text(
    en="the page of the sources has no entry {erratum} in {language}",
    pt_BR="a página das fontes não tem o item {erratum} em {language}",
)
FITTED = Text(
    en="fitted value “{name}”: the range must reach 5 % beyond it on both sides",
    pt_BR="valor ajustado “{name}”: a faixa deve ir 5 % além dele dos dois lados",
)
CURVE = Text(
    en="curve “{name}” needs two finite points or more, as many x as y",
    pt_BR="a curva “{name}” precisa de dois ou mais pontos finitos, tantos x quanto y",
)
MOTION = Text(
    en="motion “{name}” needs rising times and finite joint values of {robot} for each",
    pt_BR="o movimento “{name}” precisa de instantes crescentes e de valores de junta finitos de {robot} em cada um",
)
MOTIONS = Text(en="two motions have the same title", pt_BR="dois movimentos têm o mesmo título")
PROGRESS = Text(
    en="progress takes shares from 0 to 1 that never go back", pt_BR="progress recebe partes de 0 a 1, sem recuar"
)


def faults(name: str) -> tuple[Text, ...]:
    """The faults of a study, by its name. Its quick run is done."""
    if (why := unusable(studies, name)) is not None:
        return (why,)
    return collected_faults(content.module_file(studies.__path__, name), _all(studies.study_named(name)))


def _all(study: Study) -> Iterator[Text]:
    yield from study_description_faults(study)
    shares = list[float]()
    result = study.run(study.Options(), True, shares.append)
    if (np.diff([0.0, *shares, 1.0]) < 0).any():
        yield PROGRESS
    yield from result_faults(result)


def study_description_faults(study: Study) -> Iterator[Text]:
    """The faults of the description of a study. Raises HelicoideError for a robot that does not exist."""
    yield from missing_words(untranslated("TITLE"), study.TITLE)
    yield from missing_words(untranslated("ABOUT"), study.ABOUT, differ=True)
    for language in LANGUAGES:
        if study.ABOUT[language].count(".") < 2:
            yield ABOUT.format(language=language)
    if not study.SOURCE.strip():
        yield SOURCE
    load_robot(study.ROBOT)
    yield from option_faults(study.Options)


def result_faults(result: Result) -> Iterator[Text]:
    """The faults of a result."""
    if not result.rows:
        yield NO_ROWS
    for row in result.rows:
        yield from (ROW.format(name=row.quantity, what=what) for what in _of_row(row, result.rows))
    for chosen in result.fitted:
        reach = 0.05 * abs(chosen.value) if isinstance(chosen, Fitted) else 0.0
        if (
            isinstance(chosen, Fitted)
            and not chosen.least <= chosen.value - reach <= chosen.value + reach <= chosen.most
        ):
            yield FITTED.format(name=chosen.name)
    yield from _charts(result)
    if len({motion.title for motion in result.motions}) < len(result.motions):
        yield MOTIONS
    for motion in result.motions:
        yield from _motion(motion)


def _of_row(row: Row, rows: tuple[Row, ...]) -> Iterator[Text]:
    yield from missing_words(untranslated("quantity"), row.quantity)
    if np.isnan(row.computed):
        yield NAN
    if [(other.quantity, other.unit) for other in rows].count((row.quantity, row.unit)) > 1:
        yield TWICE
    if row.verdict is Verdict.DIFFERS and row.why is None:
        yield NO_REASON
    if isinstance(row.source, Statement) and (read := BOUND.fullmatch(row.source.words.en)):
        bound = float(read["number"].replace("−", "-"))
        breaks = {
            "<": row.computed >= bound,
            "≤": row.computed > bound,
            ">": row.computed <= bound,
            "≥": row.computed < bound,
        }
        if row.verdict in (Verdict.PRINTED, Verdict.FITTED) and breaks[read["sign"]]:
            yield AGAINST
    for language in LANGUAGES:
        if row.erratum and f'id="{row.erratum}"' not in errata.sources_page(language):
            yield NO_ERRATUM.format(erratum=row.erratum, language=language)


def _charts(result: Result) -> Iterator[Text]:
    if not result.charts:
        yield NO_CHARTS
    for chart in result.charts:
        for name in ("title", "x_label", "y_label"):
            yield from missing_words(untranslated(name), getattr(chart, name))
        for line in chart.lines:
            yield from missing_words(untranslated("line.title"), line.title)
            shaped = line.x.shape == line.y.shape and line.x.ndim == 1 and len(line.x) >= 2
            if not (shaped and np.isfinite([line.x, line.y]).all()):
                yield CURVE.format(name=line.title)


def _motion(motion: Motion) -> Iterator[Text]:
    robot = load_robot(motion.robot, None, motion.parameters)
    shaped = motion.q.shape == (len(motion.times), len(robot.variables))
    if not (shaped and np.isfinite(motion.q).all() and (np.diff(motion.times) > 0).all()):
        yield MOTION.format(name=motion.title, robot=robot.name)
