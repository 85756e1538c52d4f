"""The experiments of the sources: choose one, set it, run it, compare it with the source, replay it on the arm."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import lru_cache

import numpy as np
from markupsafe import Markup
from viser import Icon

from helicoide import studies
from helicoide.command import Replay
from helicoide.export import errata
from helicoide.export.chart_scale import scaled_chart
from helicoide.export.study_table import (
    HEADINGS,
    NOTHING,
    computed_cell,
    fitted_line,
    sorted_by_verdict,
    source_cell,
    verdict_cell,
)
from helicoide.ik.method import settings
from helicoide.kinematics.robot import Robot
from helicoide.markup import typeset
from helicoide.studies import panel_state
from helicoide.studies.panel_state import CompletedRun, StudyPanelState
from helicoide.studies.study import Chart, ChartLine, Verdict
from helicoide.studies.study import Row as Quantity
from helicoide.text import Language, Text, untranslated
from helicoide.view import html
from helicoide.view.export_rows import export_rows
from helicoide.view.requests import ForStudyPanel, Play
from helicoide.view.rows import Bar, Button, Checkbox, DependentRows, Dropdown, Folder, HtmlRow, Plot, Row
from helicoide.view.settings import NONE, NOTHING_TO_SET, setting_rows
from helicoide.view.window_view import View

TITLE = Text(en="Study", pt_BR="Estudo")
ORDER = 4
ICON = Icon.FLASK
MOST_CHARTS, DIGITS = 14, 5

RUN, STOP = Text(en="Run", pt_BR="Executar"), Text(en="End run", pt_BR="Encerrar a execução")
BEFORE = Text(en="previous", pt_BR="anterior")
SIGNS = {
    Verdict.PRINTED: "✓",
    Verdict.FITTED: "≈",
    Verdict.DIFFERS: "✗",
    Verdict.ERRATUM: "!",
    Verdict.FIGURE: "",
    Verdict.OURS: "",
}
PAGE = Markup("<a href='pages/{}/sources#{}' target='_blank'>{}</a>")
TONES = {found: f"helicoide-{found.name.lower()}" for found in Verdict}


def rows(robot: Robot) -> list[Row]:
    """The panel for one robot; the studies are the same for all."""
    return [
        Dropdown(
            Text(en="Study", pt_BR="Estudo"),
            [("", NONE), *studies_by_source()],
            lambda view: view.study_panel.study,
            lambda name: ForStudyPanel(panel_state.with_study(name)),
        ),
        HtmlRow(_about),
        Folder(
            Text(en="Settings", pt_BR="Ajustes"),
            DependentRows(lambda view: view.study_panel.study, _settings),
            open=False,
        ),
        Checkbox(
            Text(en="Quick run", pt_BR="Execução rápida"),
            lambda view: view.study_panel.short,
            lambda on: ForStudyPanel(lambda panel: replace(panel, short=bool(on))),
        ),
        Button(
            lambda view: RUN if view.study_panel.progress is None else STOP,
            lambda view: ForStudyPanel(
                panel_state.with_run_started if view.study_panel.progress is None else panel_state.with_run_ended
            ),
            Icon.FLASK,
            lambda view: bool(view.study_panel.study),
            weight="primary",
        ),
        Bar(lambda view: view.study_panel.progress),
        *(Plot(shown_charts, index) for index in range(MOST_CHARTS)),
        Folder(
            Text(en="Play on the arm", pt_BR="Reproduzir no braço"),
            DependentRows(_playable, _players),
        ),
        Checkbox(
            Text(en="Compare with previous run", pt_BR="Comparar com a execução anterior"),
            lambda view: view.study_panel.compares_previous,
            lambda on: ForStudyPanel(lambda panel: replace(panel, compares_previous=bool(on))),
        ),
        HtmlRow(_table),
        export_rows(),
    ]


def studies_by_source() -> list[tuple[str, Text]]:
    """Name and title of every study, sorted by source; the title begins with the source."""
    sources = {name: studies.study_named(name).SOURCE.partition(",")[0] for name in studies.study_names()}
    title = untranslated("{source}: {title}")
    return [
        (name, title.format(source=sources[name], title=studies.study_named(name).TITLE))
        for name in sorted(sources, key=lambda name: (sources[name], name))
    ]


def _about(view: View) -> Markup:
    """What the study is about, and why it failed, if it did."""
    panel, language = view.study_panel, view.seat.language
    if not panel.study:
        return html.note(CHOOSE[language])
    study = studies.study_named(panel.study)
    anchor = study.SOURCE.partition(",")[0].lower().replace(" ", "-")
    has_page = f'id="{anchor}"' in errata.sources_page(language)
    of_source = PAGE.format(language, anchor, OPEN[language]) if has_page else Markup("")
    about = Markup("<div class='helicoide-note'><p><b>{}</b></p><p>{}</p><p>{}. {}</p></div>").format(
        study.TITLE[language], typeset(study.ABOUT[language]), study.SOURCE, of_source
    )
    return about if panel.failure is None else about + html.note(panel.failure[language])


OPEN = Text(en="Errors and open points of the source", pt_BR="Erros e pontos em aberto da fonte")
CHOOSE = Text(
    en="Each study repeats an experiment of a source and compares the printed values with the computed ones.",
    pt_BR="Cada estudo repete um experimento de uma fonte e compara os valores impressos com os calculados.",
)


def _settings(name: str) -> Sequence[Row]:
    if not name or not settings(studies.study_named(name).Options):
        return [HtmlRow(lambda view: html.note(NOTHING_TO_SET[view.seat.language]))]
    options = studies.study_named(name).Options

    def chosen(view: View) -> object:
        return view.study_panel.options.get(name) or options()

    return setting_rows(
        options, 1.0, chosen, lambda setting, value: ForStudyPanel(panel_state.with_study_option(setting, value))
    )


def _playable(view: View) -> tuple[Text, ...] | None:
    """The titles of the motions of the last run; None before there is one."""
    panel = view.study_panel
    return tuple(motion.title for motion in panel.motions) if panel.shown_runs else None


def _players(titles: tuple[Text, ...] | None) -> Sequence[Row]:
    """A button for each motion of the run."""
    if not titles:
        said = NOT_RUN if titles is None else NO_MOTION
        return [HtmlRow(lambda view: html.note(said[view.seat.language]))]
    return [_player(index, title) for index, title in enumerate(titles)]


def _player(index: int, title: Text) -> Button:
    return Button(lambda _: title, lambda view: Play(view.study_panel.motions[index]), Icon.PLAYER_PLAY)


NOT_RUN = Text(en="Run the study first.", pt_BR="Execute o estudo primeiro.")
NO_MOTION = Text(en="This study has no motion to play.", pt_BR="Este estudo não tem movimento para reproduzir.")


def _table(view: View) -> Markup:
    """The table of the runs shown: printed and computed numbers."""
    runs, language = view.study_panel.shown_runs, view.seat.language
    if not runs:
        return Markup("")
    return _written(runs, language)


@lru_cache(maxsize=8)
def _written(runs: tuple[CompletedRun, ...], language: Language) -> Markup:
    heads = [head[language] for head in (HEADINGS[1:3] if len(runs) == 1 else (HEADINGS[2], BEFORE))]
    others = [{row.quantity: row for row in run.result.rows} for run in runs[1:]]
    rows = sorted_by_verdict(runs[0].result.rows)
    body = Markup("").join(_lines(row, [other.get(row.quantity) for other in others], language) for row in rows)
    named = Markup("").join(Markup("<th>{}</th>").format(head) for head in heads)
    table = Markup("<table class='helicoide-study'><tr>{}</tr>{}</table>").format(named, body)
    chosen = fitted_line(runs[0].result)
    return _counted(rows, language) + table + (html.note(typeset(chosen[language])) if chosen else Markup(""))


def _counted(rows: Sequence[Quantity], language: Language) -> Markup:
    """The number of rows with each verdict."""
    verdicts = [row.verdict for row in rows]
    said = Markup("").join(
        Markup("<span class='{}'>{} {}: {}</span>").format(TONES[verdict], SIGNS[verdict], verdict.value[language], n)
        for verdict in Verdict
        if (n := verdicts.count(verdict))
    )
    return Markup("<p class='helicoide-counted'>{}</p>").format(said)


def _lines(row: Quantity, others: list[Quantity | None], language: Language) -> Markup:
    """A quantity, its numbers, and its verdict. The number of a previous run replaces that of the source."""
    tone, head = TONES[row.verdict], Markup("<tr class='quantity {}'><td colspan='2'>{} {}</td></tr>")
    here = computed_cell(row, DIGITS)[language]
    before = [NOTHING if other is None else computed_cell(other, DIGITS)[language] for other in others]
    numbers = [here, *before] if others else [typeset(source_cell(row)[language]), here]
    said = typeset(verdict_cell(row)[language])
    if row.verdict is Verdict.ERRATUM:
        said = PAGE.format(language, row.erratum, said)
    shown = row.verdict in (Verdict.FIGURE, Verdict.OURS)
    why = Markup("") if shown else Markup("<tr class='{}'><td colspan='2'>{}</td></tr>").format(tone, said)
    cells = Markup("").join(Markup("<td>{}</td>").format(cell) for cell in numbers)
    return head.format(tone, SIGNS[row.verdict], typeset(row.quantity[language])) + Markup("<tr>{}</tr>{}").format(
        cells, why
    )


def shown_charts(view: View) -> Sequence[Chart]:
    """The charts of the runs shown; those over time end at the current time of the motion that is played."""
    panel, command = view.study_panel, view.state.request.command
    merged = _merged(panel.shown_runs)[:MOST_CHARTS]
    if not (isinstance(command, Replay) and command.arrived and _is_played(panel, command)):
        return merged
    return tuple(_until(chart, round(command.s, 1)) if _is_timed(chart) else chart for chart in merged)


def _is_played(panel: StudyPanelState, command: Replay) -> bool:
    motions = panel.shown_runs[0].result.motions if panel.shown_runs else ()
    return any(abs(motion.times[-1] - motion.times[0] - command.path.duration) < 1e-9 for motion in motions)


def _is_timed(chart: Chart) -> bool:
    return chart.x_label.en.startswith(("time", "t [", "t (", "t,"))


@lru_cache(maxsize=8)
def _merged(runs: tuple[CompletedRun, ...]) -> tuple[Chart, ...]:
    """Each chart of the last run, with the curves of the previous run if it has the same chart."""
    if not runs:
        return ()
    first, *rest = (run.result.charts for run in runs)
    return tuple(
        scaled_chart(replace(chart, lines=(*chart.lines, *(line for other in rest for line in _before(chart, other)))))
        for chart in first
    )


def _before(chart: Chart, others: tuple[Chart, ...]) -> list[ChartLine]:
    return [
        replace(line, title=Text(en="{title}, previous", pt_BR="{title}, anterior").format(title=line.title))
        for other in others
        if other.title == chart.title
        for line in other.lines
    ]


@lru_cache(maxsize=16)
def _until(chart: Chart, s: float) -> Chart:
    """The chart with NaN after the time s."""
    return replace(chart, lines=tuple(replace(line, y=np.where(line.x <= s, line.y, np.nan)) for line in chart.lines))
