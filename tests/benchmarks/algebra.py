"""Products and sandwiches of multivectors, one at a time and many, beside the libraries that compute them."""

from __future__ import annotations

import numpy as np
from tests.benchmarks.children.answer import Task
from tests.benchmarks.peers import Child, Peer, compare, started, ways_of
from tests.benchmarks.report import judge

from helicoide.geometry.batch import (
    MOTOR_ROWS,
    POINT_ROWS,
    batch_products,
    batch_sandwiches,
    move_full_points,
    move_points,
)
from helicoide.geometry.clifford import CL031, PGA, Algebra, Array
from helicoide.geometry.multivector import Multivector

TITLE = "Products and sandwiches beside clifford and kingdon; ratios are ours/peer"
PEERS = Peer("clifford", "with_clifford.py"), Peer("kingdon", "with_kingdon.py")
MANY = 10_000
GOALS = {
    "product, operators": 0.2,
    "product, bare functions": 0.333,
    "sandwich, operators": 0.333,
    "sandwich, bare functions": 0.333,
    "10,000 sandwiches, rows": 0.2,
}


def _full(rows: Array) -> Array:
    """Points by rows as whole multivectors (N, 16)."""
    every = np.zeros((rows.shape[1], 16))
    every[:, POINT_ROWS] = rows.T
    return every


def _ours(algebra: Algebra, given: dict[str, Array]) -> list[Task]:
    a, b, Ms, Xs = given["a"][0], given["b"][0], given["motors"], given["points"]
    objects = {name: Multivector(values, algebra) for name, values in zip("ABMX", (a, b, Ms[0], Xs[0]), strict=True)}
    functions = {"product": algebra.product, "sandwich": algebra.sandwich, "a": a, "b": b, "m": Ms[0], "x": Xs[0]}
    known = {"algebra": algebra, "move_points": move_points, "move_whole_points": move_full_points, "full": _full}
    known |= {"sandwiches": batch_sandwiches, "Ms": Ms, "Xs": Xs}
    known |= {"ms": np.ascontiguousarray(Ms.T[MOTOR_ROWS]), "xs": np.ascontiguousarray(Xs.T[POINT_ROWS])}
    rows, whole, general = (
        "move_points(algebra, ms, xs)",
        "move_whole_points(algebra, Ms, Xs)",
        "sandwiches(algebra, Ms, Xs)",
    )
    return [
        Task("product, operators", "A * B", "(A * B).values", objects),
        Task("product, bare functions", "product(a, b)", "product(a, b)", functions),
        Task("sandwich, operators", "M >> X", "(M >> X).values", objects),
        Task("sandwich, bare functions", "sandwich(m, x)", "sandwich(m, x)", functions),
        Task("10,000 sandwiches, rows", rows, f"full({rows})", known),
        Task("10,000 sandwiches, (N, 16)", whole, whole, known),
        Task("10,000 sandwiches, (N, 16)", general, general, known),
    ]


def _given(algebra: Algebra) -> dict[str, Array]:
    """Two multivectors of every blade, unit motors (1 + t e) g, and points of any weight; one a row."""
    rng = np.random.default_rng(0)
    a, b = rng.normal(size=(2, 1, 16))
    turns, shifts, points = rng.normal(size=(3, MANY, 16))
    g = turns * _blades(algebra, "1", "e1e2", "e1e3", "e2e3")
    g /= np.linalg.norm(g, axis=-1, keepdims=True)
    motors = g + batch_products(algebra, shifts * _blades(algebra, "e1e", "e2e", "e3e"), g)
    return {"a": a, "b": b, "motors": motors, "points": points * (algebra.grades == 3)}


def _blades(algebra: Algebra, *names: str) -> Array:
    """One for these blades, zero for the others."""
    return np.isin(algebra.names, names).astype(float)


def _measure(algebra: Algebra, children: list[Child]) -> None:
    given = _given(algebra)
    numbers = {name: rows.tolist() for name, rows in given.items()}
    ways = ways_of(children, squares=algebra.squares, blades=algebra.blades, **numbers)
    for ours in _ours(algebra, given):
        print(f"  {algebra}, {ours.figure}")
        ratios = compare(ours, ways)
        if ours.figure in GOALS:
            judge(f"{algebra}, {ours.figure}, beside the fastest", list(ratios.values()), GOALS[ours.figure])


def run() -> None:
    with started(PEERS) as children:
        for algebra in (PGA, CL031):
            _measure(algebra, children)
