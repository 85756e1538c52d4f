"""Closed forms, a file for each family of arms; `postures.branch.Form` says what such a file holds."""

from __future__ import annotations

import importlib
import pkgutil
from functools import cache
from typing import cast

from helicoide.ik.postures.branch import Form
from helicoide.kinematics.robot import Robot

# What is chosen last where several forms apply: first that for every arm with a spherical wrist, then the families of
# methods, which solve again what the form of one arm solves. And the forms whose goals are points.
LAST = ("pieper", "geometry", "inverse_transform", "screws", "dual_quaternions")
OF_POINTS = ("planar2r", "polar")


@cache
def found() -> dict[str, Form]:
    """Every closed form by the name of its file."""
    names = sorted(module.name for module in pkgutil.iter_modules(__path__))
    return {name: cast(Form, importlib.import_module(f"{__name__}.{name}")) for name in names}


def of(robot: Robot) -> dict[str, Form]:
    """The closed forms that apply to a robot, the most particular one first."""
    known = {name: form for name, form in found().items() if form.applies(robot) is None}
    return {name: known[name] for name in sorted(known, key=lambda name: (name in LAST and 1 + LAST.index(name), name))}
