"""A completed study as JSON: rows, charts and motions."""

from __future__ import annotations

from dataclasses import fields
from math import isfinite
from typing import Any

from helicoide.export.study_report import Record
from helicoide.studies.study import Chart, Figure, Fitted, Interpretation, Motion, Row, Statement
from helicoide.text import Text


def study_json(record: Record) -> dict[str, Any]:
    """A record as JSON: texts in both languages; NaN and infinities become null."""
    result = record.result
    return {
        "name": record.name,
        "title": _words(record.study.TITLE),
        "source": record.study.SOURCE,
        "robot": record.study.ROBOT,
        "short": record.short,
        "seconds": record.seconds,
        "options": {field.name: getattr(record.options, field.name) for field in fields(record.options)},
        "failure": None if record.failure is None else _words(record.failure),
        "rows": [] if result is None else [_row(row) for row in result.rows],
        "charts": [] if result is None else [_chart(chart) for chart in result.charts],
        "motions": [] if result is None else [_motion(motion) for motion in result.motions],
    }


def _row(row: Row) -> dict[str, Any]:
    return {
        "quantity": _words(row.quantity),
        "unit": row.unit,
        "source": _source(row.source),
        "ours": row.computed if isfinite(row.computed) else None,
        "verdict": row.verdict.name.lower(),
        "fitted": [_chosen(choice) for choice in row.fitted],
        "erratum": row.erratum or None,
        "why": None if row.why is None else _words(row.why),
        "given": None if row.given is None else _words(row.given),
    }


def _chosen(choice: Fitted | Interpretation) -> dict[str, Any]:
    return {key: _words(value) if isinstance(value, Text) else value for key, value in vars(choice).items()}


def _source(source: Statement | Figure | None) -> dict[str, Any] | None:
    match source:
        case Statement():
            return {**vars(source), "words": _words(source.words)}
        case Figure(place):
            return {"figure": place}
    return None


def _chart(chart: Chart) -> dict[str, Any]:
    return {
        "title": _words(chart.title),
        "figure": chart.figure,
        "across": _words(chart.x_label),
        "up": _words(chart.y_label),
        "lines": [{"title": _words(e.title), "x": e.x.tolist(), "y": e.y.tolist()} for e in chart.lines],
    }


def _motion(motion: Motion) -> dict[str, Any]:
    return {
        "title": _words(motion.title),
        "robot": motion.robot,
        "parameters": [*motion.parameters],
        "times": motion.times.tolist(),
        "q": motion.q.tolist(),
    }


def _words(text: Text) -> dict[str, str]:
    return {"en": text.en, "pt_BR": text.pt_BR}
