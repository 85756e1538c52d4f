"""A browser lab for learning and driving robot arms through screws, quaternions and Clifford algebra.

The names in `__all__` are the public interface for notebooks and scripts. Each is imported when it is first used, so
that `import helicoide` alone imports nothing else.
"""

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from helicoide.teaching.arm import robot as robot
    from helicoide.teaching.cell import lab as lab
    from helicoide.teaching.elements import distance as distance
    from helicoide.teaching.elements import exp as exp
    from helicoide.teaching.elements import join as join
    from helicoide.teaching.elements import line as line
    from helicoide.teaching.elements import log as log
    from helicoide.teaching.elements import meet as meet
    from helicoide.teaching.elements import motor as motor
    from helicoide.teaching.elements import plane as plane
    from helicoide.teaching.elements import point as point
    from helicoide.teaching.elements import pose as pose
    from helicoide.teaching.elements import quaternion as quaternion
    from helicoide.teaching.elements import rotor as rotor
    from helicoide.teaching.elements import screw as screw
    from helicoide.teaching.elements import translator as translator

__version__ = "0.1.0"

_ELEMENTS = ("point", "line", "plane", "quaternion", "rotor", "translator", "screw", "motor", "pose")
_OPERATIONS = ("join", "meet", "distance", "exp", "log")
_MODULES = {"robot": "arm", "lab": "cell", **dict.fromkeys((*_ELEMENTS, *_OPERATIONS), "elements")}

__all__ = list(_MODULES)


def __getattr__(name: str) -> object:
    """A public name, imported now; the names of modules are left to Python's import."""
    if name not in _MODULES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.teaching.{_MODULES[name]}"), name)


def __dir__() -> list[str]:
    """The public names, for completion."""
    return [*__all__, "__version__"]
