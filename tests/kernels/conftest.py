"""Kernels of these tests lie in a folder of their own, and are no kernels of the lab."""

from __future__ import annotations

from pathlib import Path

import pytest

from helicoide import kernels


@pytest.fixture(autouse=True)
def own_folder(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(kernels, "KERNELS", {})
    monkeypatch.setattr(kernels, "CACHE_FOLDER", tmp_path / "kernels")
