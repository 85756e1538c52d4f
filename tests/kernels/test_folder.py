"""Where kernels are kept when the usual folder cannot be written, or the disk is full."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from helicoide.kernels import cache_folder
from helicoide.text import LANGUAGES, Text


@pytest.fixture
def full() -> Iterator[None]:
    """A disk on which files can be made, and nothing written into them."""
    resource = pytest.importorskip("resource")
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (0, before[1]))
    yield
    resource.setrlimit(resource.RLIMIT_FSIZE, before)


@pytest.fixture
def usual(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path / "usual"))
    monkeypatch.setenv("TMPDIR", str(tmp_path))
    monkeypatch.setattr("tempfile.tempdir", None)
    return tmp_path / "usual" / cache_folder._digest()


def test_a_folder_that_can_be_written_is_taken_without_a_word(usual: Path) -> None:
    assert cache_folder.choose_cache_folder() == (usual, None)
    assert list(usual.iterdir()) == []


def test_an_empty_file_is_no_proof_of_room(usual: Path, full: None) -> None:
    chosen, note = cache_folder.choose_cache_folder()
    assert chosen == usual
    assert note is not None
    for language in LANGUAGES:
        assert str(usual) in note[language]
    assert note["en"] != note["pt_BR"]


def test_what_was_kept_is_used_though_the_disk_is_full_now(usual: Path, request: pytest.FixtureRequest) -> None:
    usual.mkdir(parents=True)
    (usual / f"one{cache_folder.KERNEL_SUFFIX}").touch()
    request.getfixturevalue("full")
    assert cache_folder.choose_cache_folder() == (usual, None)


def test_a_folder_that_cannot_be_written_is_replaced(usual: Path, tmp_path: Path) -> None:
    usual.parent.write_text("a file in its place, which stops root, too")
    chosen, note = cache_folder.choose_cache_folder()
    assert chosen.parent.parent == tmp_path
    assert isinstance(note, Text)
    assert str(usual) in note.en
