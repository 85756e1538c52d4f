"""Write the straight-line products of each algebra in use: `python -m tests.geometry.write_products`."""

from __future__ import annotations

from pathlib import Path
from textwrap import wrap

import numpy as np

from helicoide.geometry import products
from helicoide.geometry.clifford import CL031, PGA, Algebra

IN_USE = CL031, PGA  # of four blades, as quaternions, the table is almost as quick
FOLDER = Path(products.__file__).parent
WIDTH = 120
TIMES = "\N{NO-BREAK SPACE}*\N{NO-BREAK SPACE}"  # a line is not broken within a product
SOURCE = '''"""The products of {algebra}, written out by `python -m tests.geometry.write_products`."""

from __future__ import annotations

import numpy as np

from helicoide.geometry.signature import Array
from helicoide.kernels import kernel, kernel_into

CONJUGATE = {signs}


# fmt: off
@kernel_into
def product(a: Array, b: Array, out: Array) -> None:
    """Write a b into out, each ({count},), the blades in the order of `{algebra}`: (a b)ₖ = Σ ± aᵢ bⱼ."""
    if a.size != {count} or b.size != {count} or out.size != {count}:
        raise ValueError("each multivector needs as many coefficients as the algebra has blades")
{lines}


@kernel
def sandwich(a: Array, b: Array, out: Array) -> None:
    """Write a b a* into out, each ({count},), with the Clifford conjugate a*."""
    half, turned = np.empty({count}), np.empty({count})
    product(a, b, half)
    for k in range({count}):
        turned[k] = CONJUGATE[k] * a[k]
    product(half, turned, out)
'''


def file_of(algebra: Algebra) -> Path:
    return FOLDER / f"{products.generated_module_name(algebra)}.py"


def source_of(algebra: Algebra) -> str:
    """The file of an algebra: coefficients are read once, then each of the product is one sum."""
    lines = [assigned(f"{x}{{0}}", f"{x}[{{0}}]", algebra.count) for x in "ab"]
    places, factors = algebra.terms
    for k in range(algebra.count):
        of_k = places[:, 0] == k
        lines.append(f"out[{k}] = {total(places[of_k, 1:], factors[of_k])}")
    sums = "\n".join(map(broken, lines)).replace(TIMES, " * ")
    signs = tuple(algebra.conjugate(np.ones(algebra.count)).tolist())
    return SOURCE.format(algebra=algebra, count=algebra.count, signs=signs, lines=sums)


def assigned(left: str, right: str, count: int) -> str:
    """Many names and what they stand for."""
    return " = ".join(", ".join(map(form.format, range(count))) for form in (left, right))


def total(places: np.ndarray, factors: np.ndarray) -> str:
    """The sum of products of two coefficients, with their signs."""
    terms = [f"{'-' if f < 0 else '+'} a{i}{TIMES}b{j}" for (i, j), f in zip(places, factors, strict=True)]
    return " ".join(terms).removeprefix("+ ")


def broken(statement: str) -> str:
    """A statement over as many lines as it takes."""
    if len(statement) + 4 <= WIDTH:
        return f"    {statement}"
    left, right = statement.split(" = ")
    inner = "\n".join(f"        {line}" for line in wrap(right, WIDTH - 8))
    return f"    {left} = (\n{inner}\n    )"


if __name__ == "__main__":
    for algebra in IN_USE:
        file_of(algebra).write_text(source_of(algebra), "utf-8")
