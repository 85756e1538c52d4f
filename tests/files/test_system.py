"""What the system refuses, in our words."""

from __future__ import annotations

import errno
import os
import socket
from pathlib import Path

import pytest

from helicoide.files.os_errors import NO_HOST, os_error_reason
from helicoide.files.text_file import read_text
from helicoide.text import HelicoideError


@pytest.mark.parametrize("number", sorted(errno.errorcode))
def test_no_word_of_the_system_is_passed_on(number: int) -> None:
    said = os_error_reason(OSError(number, os.strerror(number)))
    assert said.en != said.pt_BR
    for words in (said.en, said.pt_BR):
        assert os.strerror(number).lower() not in words.lower()
        assert "Errno" not in words


def test_what_is_rare_is_told_by_its_code() -> None:
    assert os_error_reason(OSError(errno.EIO, "Input/output error")).en == "the system refuses it (EIO)"
    assert os_error_reason(OSError()).pt_BR == "o sistema não deixa (OSError)"


def test_a_host_that_is_none_has_numbers_of_its_own() -> None:
    assert os_error_reason(socket.gaierror(socket.EAI_NONAME, "Name or service not known")) is NO_HOST


@pytest.mark.parametrize(
    ("name", "said"), [("a" * 300, "name is too long|no such file"), ("a\0b", "no such file"), ("none", "no such file")]
)
def test_a_file_that_cannot_be_had_is_refused_with_the_reason(tmp_path: Path, name: str, said: str) -> None:
    with pytest.raises(HelicoideError, match=said):
        read_text(tmp_path / name, 100)
