"""kingdon: its multivectors, each with the coefficients it needs, and the functions that it generates under them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from answer import Blades, Rows, Task, answer
from kingdon import Algebra, MultiVector

EVERY, EVEN, THREE = range(5), (0, 2, 4), (3,)


def tasks_of(squares: list[int], blades: Blades, a: Rows, b: Rows, motors: Rows, points: Rows) -> list[Task]:
    algebra = Algebra(signature=squares)
    keys = [sum(1 << generator for generator in blade) for blade in blades]

    def of(coefficients: Sequence[Any], grades: Sequence[int]) -> MultiVector:
        """A multivector of these grades; of each blade `coefficients` holds a number, or an array of them."""
        kept = {key: value for key, value in zip(keys, coefficients, strict=True) if key.bit_count() in grades}
        return algebra.multivector(keys=tuple(sorted(kept)), values=[kept[key] for key in sorted(kept)])

    def full(mv: MultiVector) -> np.ndarray:
        kept = dict(zip(mv.keys(), mv.values(), strict=True))
        return np.array([kept.get(key, 0.0 * mv.values()[0]) for key in keys]).T

    views = np.array(motors).T, np.array(points).T
    rows = [np.ascontiguousarray(view) for view in views]
    A, B, M, X = of(a[0], EVERY), of(b[0], EVERY), of(motors[0], EVEN), of(points[0], THREE)
    names = {"A": A, "B": B, "M": M, "X": X, "a": A.values(), "b": B.values(), "m": M.values(), "x": X.values()}
    names |= {"Ms": of(rows[0], EVEN), "Xs": of(rows[1], THREE), "Mv": of(views[0], EVEN), "Xv": of(views[1], THREE)}
    names |= {"ms": names["Ms"].values(), "xs": names["Xs"].values()}
    names |= {"gp": algebra.gp[A, B].func, "sw": algebra.sw[M, X].func, "full": full}
    return [
        Task("product, operators", "A * B", "full(A * B)", names),
        Task("product, bare functions", "gp(a, b)", "full(A * B)", names),
        Task("sandwich, operators", "M >> X", "full(M >> X)", names),
        Task("sandwich, bare functions", "sw(m, x)", "full(M >> X)", names),
        Task("10,000 sandwiches, rows", "Ms >> Xs", "full(Ms >> Xs)", names),
        Task("10,000 sandwiches, rows", "sw(ms, xs)", "full(Ms >> Xs)", names),
        Task("10,000 sandwiches, (N, 16)", "Mv >> Xv", "full(Mv >> Xv)", names),
    ]


answer(tasks_of)
