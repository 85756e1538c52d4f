"""The motion of a line: the pose at which a lesson shows a wrong motor or quaternion beside the right one."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from helicoide.arrays import Array
from helicoide.console import ExpressionError, Value
from helicoide.console.evaluate import Budget, Scope, evaluate
from helicoide.console.syntax import Expression
from helicoide.geometry import rigid, rotation
from helicoide.geometry.clifford import CL031, QUATERNIONS
from helicoide.geometry.motor import is_motor
from helicoide.geometry.multivector import Multivector
from helicoide.lines.exercise import LineKind
from helicoide.lines.typed_line import TypedLine

MOTIONS: frozenset[LineKind] = frozenset({"quaternion product", "motor", "chain", "error"})  # a line is a motor, too
SMALLEST = 1e-9  # size of a rotation part that still has a direction


def motion_shown(line: TypedLine, root: Expression, at: Mapping[str, Value] | None) -> Array | None:
    """The motion (4, 4), m, of the typed or the expected line; None if no motion is expected, or it is none.

    at: the values of the names; without them, those of the first sample.
    """
    if line.kind not in MOTIONS or not all(_is_unit(sample.values[id(line.expected)]) for sample in line.samples):
        return None
    try:
        if at is None:
            return _pose(line.samples[0].value_of(root, Budget()))
        return _pose(evaluate(root, Scope(at, {}, Budget())))
    except ExpressionError:
        return None


def _is_unit(value: Value) -> bool:
    """Whether a value is a motor or a quaternion of size 1."""
    if not isinstance(value, Multivector):
        return False
    if value.algebra is QUATERNIONS:
        return abs(float(np.linalg.norm(value.values)) - 1) < SMALLEST
    return value.algebra is CL031 and bool(is_motor(value.values))


def _pose(value: Value) -> Array | None:
    """The pose of an even multivector or a quaternion of any size but zero."""
    if not isinstance(value, Multivector):
        return None
    if value.algebra is QUATERNIONS and np.linalg.norm(value.values) > SMALLEST:
        T = np.eye(4)
        T[:3, :3] = rotation.to_matrix(value.values)
    elif value.algebra is CL031 and not value.values[CL031.grades % 2 == 1].any() and _has_rotation(value.values):
        T = rigid.pose_from_motor(value.values)
    else:
        return None
    return T if np.isfinite(T).all() else None


def _has_rotation(M: Array) -> bool:
    return float(np.linalg.norm(rigid.dual_quaternion(M)[:4])) > SMALLEST
