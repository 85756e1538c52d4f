"""What the charts of live signals show."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class ChartChoice:
    """What the charts of live signals show.

    shown: the names of their signals or phase planes, "" for no chart; span: the time that they show, s; log: whether
    the axis is logarithmic where the signal is positive; paused: whether no samples are taken; loop: whether the
    control loop is drawn; matrix: the name of the matrix that is shown, "" for none.
    """

    shown: tuple[str, ...] = ()
    span: float = 20.0
    log: bool = False
    paused: bool = False
    loop: bool = False
    matrix: str = ""
