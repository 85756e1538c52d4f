"""How far the values of Sims. 4 to 7 of Vargas 2013 may change while what he prints holds.

`python -m tests.studies.fits.vargas_planar` changes one value at a time, by 5, 10 and 20 %, until some statement fails,
and prints the ends for `planar.FITTED`; `… grid` prints of a grid of g, c and α which statement fails first. Minutes.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping
from dataclasses import fields, replace
from itertools import product

from helicoide.studies import vargas_04, vargas_05, vargas_06, vargas_07
from helicoide.studies.study import Row
from helicoide.studies.vargas.planar import VALUES, OpenValues, run_on_planar
from helicoide.studies.vargas.runs import MethodRun, MethodSettings
from helicoide.studies.vargas.secondary import no_progress

DT, FACTORS = 1e-2, (1.05, 1.1, 1.2)
GRID = ((30.0, 60.0, 120.0, 240.0), (0.25, 0.4, 0.6, 0.8), (5.0, 10.0, 20.0))
SIMULATIONS = (vargas_04, vargas_05, vargas_07, vargas_06)


def failing(values: OpenValues) -> list[str]:
    """The statements that do not hold with these values."""
    failed = []
    for study in SIMULATIONS:
        ways: Mapping[str, MethodSettings] = values.methods
        if study is vargas_06:
            ways = vargas_06.compared_methods(ways)
        runs = run_on_planar(study.PATH, study.START, ways, DT, no_progress, values.rate)
        statements: Callable[[Mapping[str, MethodRun]], list[Row]] = study.statements
        failed += [row.quantity.en for row in statements(runs) if not row.source.holds(row.computed)]  # type: ignore[union-attr]
        if failed:
            break
    return failed


def end(name: str, way: int) -> float:
    """The last value up (way 1) or down (−1) at which all statements hold."""
    usual = last = getattr(VALUES, name)
    for factor in FACTORS:
        value = usual * factor**way
        if failed := failing(replace(VALUES, **{name: value})):
            print(f"  {name} = {value:.4g}: {failed[0]}", flush=True)
            break
        last = value
    return float(last)


def ends() -> None:
    """Print the ends of each value."""
    print("with the values as they are:", failing(VALUES) or "everything holds", flush=True)
    for field in fields(VALUES):
        print(f"{field.name}: {end(field.name, -1):.4g} … {end(field.name, 1):.4g}", flush=True)


def grid() -> None:
    """Print a line for each set of g, c and α."""
    for gain, coupling, leak in product(*GRID):
        failed = failing(replace(VALUES, gain=gain, coupling=coupling, leak=leak))
        print(f"g = {gain:g}, c = {coupling:g}, α = {leak:g}: {failed or 'everything holds'}", flush=True)


if __name__ == "__main__":
    grid() if sys.argv[1:] == ["grid"] else ends()
