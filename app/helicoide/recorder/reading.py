"""Recordings from files: the format by the ending of the name, limits, and what is wrong with a file in words."""

from __future__ import annotations

import logging
from pathlib import Path

from helicoide.files.os_errors import os_error_reason
from helicoide.recorder.bags import READERS, read_zip
from helicoide.recorder.gathering import Gathering
from helicoide.recorder.recorder import LARGEST
from helicoide.recorder.recording import Recording
from helicoide.text import HelicoideError, Text

ALL_READERS = {**READERS, ".zip": read_zip}
MOST_BYTES = 2 * LARGEST
UNREAD = Text(
    en="{name} cannot be read: {reason}. Valid are MCAP (.mcap), rosbag 1 (.bag) and rosbag 2 (.db3, or its folder as "
    ".zip), with at most {mb:.0f} MB.",
    pt_BR="Não dá para ler {name}: {reason}. Valem MCAP (.mcap), rosbag 1 (.bag) e rosbag 2 (.db3, ou a pasta em "
    ".zip), com no máximo {mb:.0f} MB.",
)
ENDING = Text(en="no format has names that end in {ending}", pt_BR="nenhum formato tem nomes que terminam em {ending}")
TOO_LONG = Text(en="it is too long", pt_BR="é longo demais")
DAMAGED = Text(en="it is damaged, or no {ending}", pt_BR="está danificado ou não é {ending}")
CUT = Text(
    en="The file has no regular end; all before it was read.",
    pt_BR="O arquivo não tem um fim regular; tudo antes dele foi lido.",
)
log = logging.getLogger("helicoide")


def read_recording(path: Path, title: str) -> Recording:
    """The recording in a file. title: the name that the user knows it by; its ending determines the format.

    Raises HelicoideError with what is wrong and what is valid.
    """
    ending = Path(title).suffix.lower()
    if ending not in ALL_READERS:
        raise _refusal(title, ENDING.format(ending=ending or "–"))
    content = Gathering(title)
    try:
        if path.stat().st_size > MOST_BYTES:
            raise HelicoideError(TOO_LONG)
        whole = ALL_READERS[ending](path, content)
        return content.recording(*(() if whole else (CUT,)))
    except HelicoideError as refusal:
        raise _refusal(title, refusal.text) from refusal
    except OSError as error:
        raise _refusal(title, os_error_reason(error)) from error
    except Exception as error:  # a damaged file makes the parsers raise errors of any kind
        log.info("%s could not be read", title, exc_info=True)
        raise _refusal(title, DAMAGED.format(ending=ending)) from error


def _refusal(title: str, reason: Text) -> HelicoideError:
    return HelicoideError(UNREAD.format(name=title, reason=reason, mb=MOST_BYTES / 1e6))
