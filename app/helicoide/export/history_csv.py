"""The history of charted signals as CSV: a line for each sample, a column for each curve and arm."""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence

import numpy as np

from helicoide.readout.signal import Signal
from helicoide.readout.signal_history import SignalHistory
from helicoide.text import Language, Text


def history_csv(
    history: SignalHistory, signals: Sequence[Signal], span: float, language: Language, arms: Sequence[Text]
) -> str:
    """The samples of the last `span` seconds; numbers with a decimal point, and nothing where undefined.

    Each column is named by the title of its signal, the curve, the unit and, with two arms, the arm's name.
    """
    part = history.since(span)
    columns = [history.times[part]]
    heads = ["t [s]"]
    for signal in signals:
        values = history.of(signal)
        if values is None:
            continue
        for c, curve in enumerate(signal.curves):
            for arm, named in enumerate(arms or (None,)):
                columns.append(values[part, arm, c])
                heads.append(_head(signal, curve, named, language))
    file = io.StringIO()
    writer = csv.writer(file)
    writer.writerow(heads)
    writer.writerows([_cell(value) for value in row] for row in zip(*columns, strict=True))
    return file.getvalue()


def _head(signal: Signal, curve: Text, arm: Text | None, language: Language) -> str:
    name = signal.title[language] if len(signal.curves) == 1 else f"{signal.title[language]}: {curve[language]}"
    unit = f" [{signal.unit}]" if signal.unit else ""
    return f"{name}{unit}" if arm is None else f"{name}{unit} ({arm[language]})"


def _cell(value: float) -> str:
    return "" if np.isnan(value) else repr(float(value))
