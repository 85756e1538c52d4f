"""The experiments of the sources: choose one, set it, run it, read it beside the source, play it on the arm."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import lru_cache

import numpy as np
from markupsafe import Markup
from viser import Icon

from helicoide import studies
from helicoide.command import Replay
from helicoide.export.readable import readable
from helicoide.export.study_table import HEADINGS, NOTHING, alone, number, source, verdict
from helicoide.ik.method import settings
from helicoide.kinematics.robot import Robot
from helicoide.studies import desk as desks
from helicoide.studies.desk import Desk, Run
from helicoide.studies.study import Chart, Line, Verdict
from helicoide.studies.study import Row as Quantity
from helicoide.text import Language, Text
from helicoide.view import html
from helicoide.view.rows import Bar, Button, Changing, Choice, Folder, ForDesk, Play, Plot, Row, Tick, View, Words
from helicoide.view.settings import NONE, NOTHING_TO_SET, rows_of

TITLE = Text(en="Study", pt_BR="Estudo")
ORDER = 4
ICON = Icon.FLASK
MOST_CHARTS, DIGITS = 8, 5

RUN, STOP = Text(en="Run", pt_BR="Executar"), Text(en="End the run", pt_BR="Encerrar a execução")
PLAY = Text(en="Play it on the arm", pt_BR="Reproduzir no braço")
BEFORE = Text(en="before", pt_BR="antes")
SIGNS = {Verdict.AGREES: "✓", Verdict.DOUBT: "?", Verdict.ASSUMED: "≈", Verdict.DIFFERS: "✗"}
TONES = {found: f"helicoide-{found.name.lower()}" for found in Verdict}


def rows(robot: Robot) -> list[Row]:
    """The panel for one robot; the studies are the same for all."""
    return [
        Choice(
            Text(en="Study", pt_BR="Estudo"),
            [("", NONE), *((name, studies.named(name).TITLE) for name in studies.names())],
            lambda view: view.desk.study,
            lambda name: ForDesk(desks.choose(name)),
        ),
        Words(_about),
        Folder(Text(en="Settings", pt_BR="Ajustes"), Changing(lambda view: view.desk.study, _settings), open=False),
        Tick(
            Text(en="short form", pt_BR="forma curta"),
            lambda view: view.desk.short,
            lambda on: ForDesk(lambda desk: replace(desk, short=bool(on))),
        ),
        Button(
            lambda view: RUN if view.desk.progress is None else STOP,
            lambda view: ForDesk(desks.start if view.desk.progress is None else desks.end),
            Icon.FLASK,
            lambda view: bool(view.desk.study),
        ),
        Bar(lambda view: view.desk.progress),
        Button(lambda _: PLAY, _play, Icon.PLAYER_PLAY, shown=_has_motion),
        Tick(
            Text(en="beside the run before", pt_BR="ao lado da execução anterior"),
            lambda view: view.desk.compared,
            lambda on: ForDesk(lambda desk: replace(desk, compared=bool(on))),
        ),
        Words(_table),
        *(Plot(charts, index) for index in range(MOST_CHARTS)),
    ]


def _about(view: View) -> Markup:
    """What the study is about, and why it has no result."""
    desk, language = view.desk, view.seat.language
    if not desk.study:
        return html.note(CHOOSE[language])
    study = studies.named(desk.study)
    about = Markup("<div class='helicoide-note'><p>{}</p><p>{}</p></div>").format(study.ABOUT[language], study.SOURCE)
    return about if desk.failure is None else about + html.note(desk.failure[language])


CHOOSE = Text(
    en="Each study is an experiment of one of the sources, run again here: its numbers stand beside the printed ones.",
    pt_BR="Cada estudo é um experimento de uma das fontes, refeito aqui: seus números ficam ao lado dos impressos.",
)


def _settings(name: str) -> Sequence[Row]:
    if not name or not settings(studies.named(name).Options):
        return [Words(lambda view: html.note(NOTHING_TO_SET[view.seat.language]))]
    options = studies.named(name).Options

    def chosen(view: View) -> object:
        return view.desk.options.get(name) or options()

    return rows_of(options, 1.0, chosen, lambda setting, value: ForDesk(desks.set_option(setting, value)))


def _has_motion(view: View) -> bool:
    return bool(view.desk.shown) and view.desk.shown[0].result.motion is not None


def _play(view: View) -> Play:
    motion = view.desk.shown[0].result.motion
    assert motion is not None
    return Play(motion)


def _table(view: View) -> Markup:
    """The quantities of the runs shown, beside the source's and the digest's."""
    runs, language = view.desk.shown, view.seat.language
    if not runs:
        return Markup("")
    return _written(runs, language)


@lru_cache(maxsize=8)
def _written(runs: tuple[Run, ...], language: Language) -> Markup:
    heads = [head[language] for head in (HEADINGS[1:4] if len(runs) == 1 else (*HEADINGS[2:4], BEFORE))]
    others = [{row.quantity: row for row in run.result.rows} for run in runs[1:]]
    rows = runs[0].result.rows
    body = Markup("").join(_lines(row, [other.get(row.quantity) for other in others], language) for row in rows)
    named = Markup("").join(Markup("<th>{}</th>").format(head) for head in heads)
    table = Markup("<table class='helicoide-study'><tr>{}</tr>{}</table>").format(named, body)
    return _counted(rows, language) + table


def _counted(rows: Sequence[Quantity], language: Language) -> Markup:
    """How many numbers there are of each verdict."""
    compared = [row.verdict for row in rows if not alone(row)]
    said = Markup("").join(
        Markup("<span class='{}'>{} {}: {}</span>").format(TONES[verdict], SIGNS[verdict], verdict.value[language], n)
        for verdict in Verdict
        if (n := compared.count(verdict))
    )
    return Markup("<p class='helicoide-counted'>{}</p>").format(said)


def _lines(row: Quantity, others: list[Quantity | None], language: Language) -> Markup:
    """A quantity over its numbers, and under them why one differs. A run before takes the place of the source."""
    compared, found = not alone(row), row.verdict
    tone, sign = (TONES[found], f"{SIGNS[found]} ") if compared else ("", "")
    unit = Markup(" <i>{}</i>").format(row.unit) if row.unit else ""
    head = Markup("<tr class='quantity {}'><td colspan='3'>{}{}{}</td></tr>")
    said = verdict(row, language) if compared and found is not Verdict.AGREES else ""
    why = said and Markup("<tr class='{}'><td colspan='3'>{}</td></tr>").format(tone, said)
    tolerance = row.tolerance if row.relation == "=" else 0.0
    bound = f"{row.relation} " if row.digest is not None and row.relation != "=" else ""
    values = (row.digest, row.ours, *(None if other is None else other.ours for other in others))
    asked, *ours = (NOTHING if v is None else number(v, "", tolerance, DIGITS).replace("-", "−") for v in values)
    printed = [] if others else [source(row, language)]
    numbers = Markup("").join(Markup("<td>{}</td>").format(cell) for cell in (*printed, bound + asked, *ours))
    return head.format(tone, sign, row.quantity[language], unit) + Markup("<tr>{}</tr>{}").format(numbers, why)


def charts(view: View) -> Sequence[Chart]:
    """The charts of the runs shown; those over time end where the motion that is played is."""
    desk, command = view.desk, view.state.request.command
    merged = _merged(desk.shown)[:MOST_CHARTS]
    if not (isinstance(command, Replay) and command.arrived and _is_played(desk, command)):
        return merged
    return tuple(_until(chart, round(command.s, 1)) if _is_timed(chart) else chart for chart in merged)


def _is_played(desk: Desk, command: Replay) -> bool:
    motion = desk.shown[0].result.motion if desk.shown else None
    ends = None if motion is None else float(motion.times[-1] - motion.times[0])
    return ends is not None and abs(ends - command.path.duration) < 1e-9


def _is_timed(chart: Chart) -> bool:
    return chart.across.en.startswith(("time", "t [", "t (", "t,"))


@lru_cache(maxsize=8)
def _merged(runs: tuple[Run, ...]) -> tuple[Chart, ...]:
    """Each chart of the last run, with the curves of the one before where both have it."""
    if not runs:
        return ()
    first, *rest = (run.result.charts for run in runs)
    return tuple(
        readable(replace(chart, lines=(*chart.lines, *(line for other in rest for line in _before(chart, other)))))
        for chart in first
    )


def _before(chart: Chart, others: tuple[Chart, ...]) -> list[Line]:
    return [
        replace(line, title=Text(en="{title}, before", pt_BR="{title}, antes").format(title=line.title))
        for other in others
        if other.title == chart.title
        for line in other.lines
    ]


@lru_cache(maxsize=16)
def _until(chart: Chart, s: float) -> Chart:
    """The chart with what comes after a time left blank."""
    return replace(chart, lines=tuple(replace(line, y=np.where(line.x <= s, line.y, np.nan)) for line in chart.lines))
