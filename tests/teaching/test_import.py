"""`import helicoide` loads nothing until a name is used, so that the command line stays fast."""

from __future__ import annotations

import subprocess
import sys

import pytest

import helicoide

LOADED = "import sys; before = set(sys.modules); {work}; print(*sorted(set(sys.modules) - before))"


def loaded_by(work: str) -> set[str]:
    """The modules that a statement loads in a new process."""
    script = LOADED.format(work=work)
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    return set(done.stdout.split())


def test_the_package_alone_imports_nothing_of_its_own() -> None:
    modules = loaded_by("import importlib, typing; before = set(sys.modules); import helicoide")
    assert modules == {"helicoide"}


def test_multivectors_need_neither_the_server_nor_the_readers_of_meshes() -> None:
    modules = loaded_by("import helicoide; helicoide.point(1, 2, 3)")
    assert not {"viser", "trimesh", "yourdfpy"} & modules


@pytest.mark.parametrize("name", helicoide.__all__)
def test_every_public_name_is_described(name: str) -> None:
    assert getattr(helicoide, name).__doc__
    assert name in dir(helicoide)


def test_an_unknown_name_is_refused_as_by_any_module() -> None:
    with pytest.raises(AttributeError, match="'nope'"):
        _ = helicoide.nope
