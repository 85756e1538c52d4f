"""A kernel has one machine code whether or not its arrays may be written, and leaves alone those that may not."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from itertools import product
from pathlib import Path
from typing import Any, cast

import numpy as np
import pytest
from numba.core.errors import NumbaError
from numpy.typing import NDArray

from helicoide.kernels import Kernel, count_compiled, kernel, kernel_into, python_function, typed_entry

Array = NDArray[np.float64]
ROOT = Path(__file__).parents[2]


def blend(a: Array, pair: tuple[Array, tuple[Array, float]]) -> float:
    b, (c, share) = pair
    return float(a[0] + b[0] + share * c[0])


def array(value: float, writable: bool) -> Array:
    made = np.full(3, value)
    made.flags.writeable = writable
    return made


def test_arrays_that_may_be_written_and_those_that_may_not_share_it() -> None:
    blending, compiled = Kernel(blend), list[int]()
    with count_compiled(compiled.append):
        for x, y, z in product((True, False), repeat=3):
            assert blending(array(1.0, x), (array(2.0, y), (array(3.0, z), 0.5))) == 4.5
    assert compiled == [1]
    assert len(blending.signatures) == 1


CONSTANT = np.arange(3.0)
blended = kernel(blend)


def with_a_constant(a: Array) -> float:
    return blended(a, (CONSTANT, (a, 1.0))) + blended(a, (a, (CONSTANT, 1.0)))


def test_a_kernel_hands_on_an_array_of_its_module_without_another_version() -> None:
    blended(np.ones(3), (np.ones(3), (np.ones(3), 1.0)))
    both: Any = Kernel(with_a_constant)
    assert both(np.ones(3)) == 4.0
    assert len(cast(Any, blended).signatures) == 1


def test_another_order_of_the_numbers_is_another_machine_code() -> None:
    """Elements that do not lie side by side are read right, at the price of one more compilation."""
    blending = Kernel(blend)
    for step in (1, 2):
        a = np.arange(1.0, 7.0)[::step]
        assert blending(a[1:], (a, (a, 1.0))) == 2 + a[1]
    assert len(blending.signatures) == 2


def test_what_a_kernel_returns_of_what_it_was_given_stays_as_it_was() -> None:
    same: Any = Kernel(itself)
    given = array(1.0, writable=False)
    assert same(given) is given
    assert not given.flags.writeable


def itself(a: Array) -> Array:
    return a


def into(a: Array, out: Array) -> None:
    for i in range(a.size):
        out[i] = 2 * a[i]


def makes(a: Array, out: Array) -> None:
    half = np.empty(a.size)
    half[:] = a
    out[:] = 2 * half


@kernel
def doubled(a: Array) -> Array:
    out = np.empty_like(a)
    writing(a, out)
    return out


writing = kernel_into(into)


def test_a_kernel_that_only_writes_does_so_alone_and_within_another() -> None:
    a, out = array(1.5, writable=False), np.empty(3)
    writing(a, out)
    np.testing.assert_array_equal(out, 3.0)
    np.testing.assert_array_equal(doubled(a), 3.0)
    before = sys.getrefcount(a)
    for _ in range(100):
        writing(a, out)
    assert sys.getrefcount(a) == before


def test_a_kernel_that_is_to_write_only_may_make_no_array() -> None:
    with pytest.raises(NumbaError):
        kernel_into(makes)(np.ones(3), np.empty(3))


@pytest.mark.parametrize("made", [kernel, kernel_into, lambda function: function], ids=["kernel", "into", "plain"])
def test_an_entry_is_what_the_kernel_does(made: Callable[[Any], Any]) -> None:
    out = np.empty(3)
    typed_entry(made(into), np.ones(3), out)(array(1.5, writable=False), out)
    np.testing.assert_array_equal(out, 3.0)


def test_the_python_function_is_there() -> None:
    assert python_function(kernel(blend)) is blend
    assert python_function(blend) is blend


DRIVE = """
import numpy as np
from helicoide import gate
from helicoide.advance import advance
from helicoide.ik import methods
from helicoide.kinematics.library import load_robot
from helicoide.session.preparing import exercise
from helicoide.session.workcell import TICK
from helicoide.state import initial_state

exercise()
for name in ("movemaster", "dia10_rod", "polar_rp"):
    start = initial_state(load_robot(name))
    begun = [gate.add_obstacle(), gate.get_ready(), gate.set_joint(0, start.arm.q[0] + 0.1)]
    begun += [gate.choose_path(path) for path in gate.presets(start.robot)]
    if "rcm" in start.robot.frames:
        begun.append(gate.enforce_entry(True))
    for method in methods.names():
        for update in begun:
            state = gate.play()(update(gate.choose_method(method)(start)))
            for _ in range(2):
                state = advance(state, TICK)
print("done")
"""


def test_no_kernel_writes_into_what_may_not_be_written() -> None:
    """As plain Python they are held to it by numpy; machine code is not."""
    environment = {**os.environ, "NUMBA_DISABLE_JIT": "1", "PYTHONPATH": str(ROOT / "app")}
    done = subprocess.run(
        [sys.executable, "-c", DRIVE], env=environment, capture_output=True, text=True, timeout=600, check=False
    )
    assert (done.returncode, done.stdout) == (0, "done\n"), done.stderr
