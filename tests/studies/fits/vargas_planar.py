"""How far the values of Sims. 4 to 7 of Vargas 2013 may change while what he prints holds.

`python -m tests.studies.fits.vargas_planar [step in ms]` changes one value at a time, by 5, 10 and 20 %,
until some statement fails, and prints the ends for `planar.FITTED`. Some minutes.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping
from dataclasses import fields, replace

from helicoide.studies import vargas_04, vargas_05, vargas_06, vargas_07
from helicoide.studies.study import Row
from helicoide.studies.vargas.planar import VALUES, Values, followers
from helicoide.studies.vargas.runs import Run, Way
from helicoide.studies.vargas.secondary import silent

FACTORS = (1.05, 1.1, 1.2)
SIMULATIONS = (vargas_04, vargas_05, vargas_07, vargas_06)


def failing(values: Values, dt: float) -> list[str]:
    """The statements that do not hold with these values."""
    failed = []
    for study in SIMULATIONS:
        ways: Mapping[str, Way] = values.ways
        if study is vargas_06:
            ways = vargas_06.compared_ways(ways)
        runs = followers(study.PATH, study.START, ways, dt, silent, values.rate)
        statements: Callable[[Mapping[str, Run]], list[Row]] = study.statements
        failed += [row.quantity.en for row in statements(runs) if not row.source.holds(row.ours)]  # type: ignore[union-attr]
        if failed:
            break
    return failed


def end(name: str, way: int, dt: float) -> float:
    """The last value up (way 1) or down (−1) at which all statements hold."""
    usual = last = getattr(VALUES, name)
    for factor in FACTORS:
        value = usual * factor**way
        if failed := failing(replace(VALUES, **{name: value}), dt):
            print(f"  {name} = {value:.4g}: {failed[0]}", flush=True)
            break
        last = value
    return float(last)


def main(dt: float) -> None:
    """Print the ends of each value."""
    print("with the values as they are:", failing(VALUES, dt) or "everything holds", flush=True)
    for field in fields(VALUES):
        print(f"{field.name}: {end(field.name, -1, dt):.4g} … {end(field.name, 1, dt):.4g}", flush=True)


if __name__ == "__main__":
    main(1e-3 * float(sys.argv[1] if len(sys.argv) > 1 else 5))
