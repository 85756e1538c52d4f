"""How far the hands of E2 and E3 may move otherwise: `python -m tests.studies.fits.coutinho_hand`; some minutes.

The hand of E2 keeps away from the singularity that lies at a turn; that of E3 turns through it and back. Each value is
changed by ±5 % and ±10 %.
"""

from __future__ import annotations

from collections.abc import Callable

from helicoide.studies import coutinho_e2, coutinho_e3
from helicoide.studies._coutinho_hand import ENTRY_SPEED, Hand, run_led, steering_hand
from helicoide.studies._coutinho_runs import FILTERED, Run
from helicoide.studies.study import Fitted, Row, Statement


def run(hand: Hand, entry_speed: float, period: float) -> Run:
    """A whole period of a hand."""
    return run_led(hand, entry_speed, FILTERED, 0.0, period, lambda share: None)


def e2(size: float, aside: float, period: float) -> list[Row]:
    """E2 by mm, mm and s."""
    return coutinho_e2.e2_rows(run(steering_hand(1e-3 * size, 1e-3 * aside, 0.0, period), 0.0, period))


def e3(size: float, turn: float, period: float) -> list[Row]:
    """E3 by mm, rad and s."""
    got = run(steering_hand(1e-3 * size, 0.0, turn, period), ENTRY_SPEED, period)
    times = Row(coutinho_e3.TIMES, coutinho_e3.singular_approaches(got["w"]), "", Statement(coutinho_e3.TWO, "", 2.0))
    return [times, *coutinho_e3.e3_rows(got)]


def show(rows: Callable[[float, float, float], list[Row]], hand: tuple[Fitted, ...]) -> None:
    """What fails when one value after the other is changed."""
    values = [value.value for value in hand]
    for index, value in enumerate(hand):
        for factor in (0.9, 0.95, 1.0, 1.05, 1.1):
            changed = [*values[:index], factor * values[index], *values[index + 1 :]]
            failing = [
                f"{row.quantity.en} = {row.computed:.4g}"
                for row in rows(*changed)
                if isinstance(row.source, Statement) and not row.source.holds(row.computed)
            ]
            print(value.name.en, changed[index], failing or "all holds", flush=True)


if __name__ == "__main__":
    show(e2, (coutinho_e2.SIZE, coutinho_e2.ASIDE, coutinho_e2.LASTS))
    show(e3, coutinho_e3.HAND)
