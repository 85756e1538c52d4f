"""Comparison of two methods: charts of the last seconds of motion, and the largest values of the whole motion."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

import numpy as np
from markupsafe import Markup

from helicoide.comparison import Trace
from helicoide.ik.methods import named
from helicoide.studies.study import Chart, ChartLine
from helicoide.text import Text
from helicoide.view import html
from helicoide.view.window_view import View

CHARTS = 2
TIME = Text(en="time in motion [s]", pt_BR="tempo em movimento [s]")
ASKED = Text(en="Joint velocity that the method asks for", pt_BR="Velocidade de junta que o método pede")
ERROR = Text(en="Position error", pt_BR="Erro de posição")
SPEED_AXIS, ERROR_AXIS = Text(en="‖q̇‖ [rad/s]", pt_BR="‖q̇‖ [rad/s]"), Text(en="e_p [mm]", pt_BR="e_p [mm]")
LEAST_SPEED = 1e-2  # rad/s, the lower end of the logarithmic axis
LARGEST = Text(
    en="Largest, {method}: asked {asked:.3g} rad/s, moved at {speed:.3g} rad/s, position error {error:.3g} mm.",
    pt_BR="Máximos, {method}: pediu {asked:.3g} rad/s, moveu-se a {speed:.3g} rad/s, erro de posição {error:.3g} mm.",
)


def comparison_charts(view: View) -> Sequence[Chart]:
    """The two charts; empty until the arms have moved to a target."""
    second = view.state.compared
    if second is None or len(second.trace.times) < 2:
        return ()
    return _charts(second.trace, *_titles(view))


def _titles(view: View) -> tuple[Text, ...]:
    assert view.state.compared is not None
    return tuple(
        named(controller.method).TITLE for controller in (view.state.request.controller, view.state.compared.controller)
    )


@lru_cache(maxsize=8)
def _charts(trace: Trace, *titles: Text) -> tuple[Chart, ...]:
    asked, error = np.maximum(trace.efforts[:, :, 0], LEAST_SPEED), 1000 * trace.efforts[:, :, 2]

    def lines(values: np.ndarray) -> tuple[ChartLine, ...]:
        return tuple(ChartLine(title, trace.times, values[:, arm]) for arm, title in enumerate(titles))

    return (
        Chart(ASKED, TIME, SPEED_AXIS, lines(asked), log=True),
        Chart(ERROR, TIME, ERROR_AXIS, lines(error)),
    )


def largest_values(view: View) -> Markup:
    """A note for each arm; empty until the arms have moved."""
    second = view.state.compared
    if second is None or len(second.trace.times) == 0:
        return Markup("")
    return Markup("").join(
        html.note(LARGEST.format(method=title, asked=asked, speed=speed, error=1000 * error)[view.seat.language])
        for title, (asked, speed, error) in zip(_titles(view), second.trace.largest.tolist(), strict=True)
    )
