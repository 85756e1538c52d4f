"""clifford: its multivectors, and the compiled functions under them on bare arrays. It has no batch: it loops."""

from __future__ import annotations

import numpy as np
from answer import Blades, Rows, Task, answer
from clifford import Cl

OBJECTS = "M * X * ~M"
BARE = "gmt(gmt(m, x), adjoint(m))"
MANY = "10,000 sandwiches, (N, 16)"


def tasks_of(squares: list[int], blades: Blades, a: Rows, b: Rows, motors: Rows, points: Rows) -> list[Task]:
    layout, _ = Cl(sig=squares)
    places = [layout.bladeTupList.index(tuple(generator + 1 for generator in blade)) for blade in blades]
    av, bv, ms, xs = (np.array(rows)[:, np.argsort(places)] for rows in (a, b, motors, points))
    arrays = list(zip(ms, xs, strict=True))
    pairs = [(layout.MultiVector(m), layout.MultiVector(x)) for m, x in arrays]
    names = {"A": layout.MultiVector(av[0]), "B": layout.MultiVector(bv[0]), "M": pairs[0][0], "X": pairs[0][1]}
    names |= {"a": av[0], "b": bv[0], "m": ms[0], "x": xs[0], "arrays": arrays, "pairs": pairs, "places": places}
    names |= {"gmt": layout.gmt_func, "adjoint": layout.adjoint_func}
    return [
        Task("product, operators", "A * B", "(A * B).value[places]", names),
        Task("product, bare functions", "gmt(a, b)", "gmt(a, b)[places]", names),
        Task("sandwich, operators", OBJECTS, f"({OBJECTS}).value[places]", names),
        Task("sandwich, bare functions", BARE, f"{BARE}[places]", names),
        Task(MANY, f"for M, X in pairs: {OBJECTS}", f"[({OBJECTS}).value[places] for M, X in pairs]", names),
        Task(MANY, f"for m, x in arrays: {BARE}", f"[{BARE}[places] for m, x in arrays]", names),
    ]


answer(tasks_of)
