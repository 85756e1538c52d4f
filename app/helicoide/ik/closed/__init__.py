"""Closed forms, a file for each family of arms; `postures.branch.Form` says what such a file holds."""

from __future__ import annotations

import importlib
import pkgutil
from collections.abc import Mapping
from functools import cache, lru_cache
from types import MappingProxyType
from typing import cast

from helicoide.ik.postures.answer import Form
from helicoide.kinematics.robot import Robot


@cache
def found() -> dict[str, Form]:
    """Every closed form by the name of its file."""
    names = sorted(module.name for module in pkgutil.iter_modules(__path__))
    return {name: cast(Form, importlib.import_module(f"{__name__}.{name}")) for name in names}


@lru_cache(maxsize=64)
def of(robot: Robot) -> Mapping[str, Form]:
    """The closed forms that apply to a robot, the one that is chosen first."""
    known = {name: form for name, form in found().items() if form.applies(robot) is None}
    return MappingProxyType(dict(sorted(known.items(), key=lambda one: (one[1].RANK, one[0]))))
