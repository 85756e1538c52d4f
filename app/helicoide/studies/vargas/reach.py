"""The rows that Sims. 12 and 13 of Vargas 2013 share: a path that leaves the workspace and comes back."""

from __future__ import annotations

from dataclasses import dataclass

from helicoide.studies.study import Row
from helicoide.studies.vargas.arm import re_entry, unreachable
from helicoide.studies.vargas.runs import Run, Way, largest, rms
from helicoide.studies.vargas.table import FASTEST_LATER, Sheet
from helicoide.text import Text

REACHABLE = Text(en="largest error where the path is within reach", pt_BR="maior erro onde o caminho está ao alcance")
REACHABLE_RMS = Text(en="rms error where the path is within reach", pt_BR="erro rms onde o caminho está ao alcance")
BACK = Text(en="error {after} s after coming back", pt_BR="erro {after} s após a volta")
LEAST_W = Text(en="least w from 5 s on", pt_BR="menor w a partir de 5 s")
PUSH = Text(en="largest acceleration from 5 s on", pt_BR="maior aceleração a partir de 5 s")


@dataclass(frozen=True)
class Found:
    """What the digest has, from 5 s on; None where it has nothing, or what hangs on the step.

    fastest: joint, rad/s; error, mean: largest and rms where the path is within reach, cm; back: ‖e‖ a quarter, half
    and a whole second after it has come back, cm; w: the least, cm³; push: the largest acceleration, rad/s². coarse:
    the share that the short form may miss of the first three and of the errors after the path has come back.
    """

    fastest: str | None
    error: str
    mean: str
    back: tuple[str, str, str]
    w: str | None
    push: str | None
    coarse: tuple[float | None, float | None, float | None, float | None]


def reach_rows(sheet: Sheet, one: Way, run: Run, found: Found, error_within: float | None = None) -> list[Row]:
    """The numbers of a method; error_within: how far the largest error may be off, cm, where it hangs on rounding."""
    of, later = one.title, run.t >= 5
    inside = later & ~unreachable(run.t)
    a, b, c, d = found.coarse
    return [
        sheet.row(FASTEST_LATER, of, largest(run.rates, later), found.fastest, "rad/s", coarse=a),
        sheet.row(REACHABLE, of, largest(run.size, inside), found.error, "cm", coarse=b, within=error_within),
        sheet.row(REACHABLE_RMS, of, rms(run.size[inside]), found.mean, "cm", coarse=c),
        *(
            sheet.row(BACK.format(after=after), of, size, digest, "cm", coarse=d)
            for after, size, digest in zip((0.25, 0.5, 1.0), re_entry(run), found.back, strict=True)
        ),
        sheet.row(LEAST_W, of, float(run.w[later].min()), found.w, "cm³"),
        sheet.row(PUSH, of, largest(run.push, later[1:]), found.push, "rad/s²"),
    ]
