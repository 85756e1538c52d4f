"""The messages of a rosbag: version 1 (.bag), version 2 (.db3), or a folder of version 2 in a .zip file."""

from __future__ import annotations

import zipfile
from collections.abc import Callable, Mapping
from pathlib import Path
from tempfile import TemporaryDirectory

from rosbags.highlevel import AnyReader

from helicoide.recorder.gathering import Gathering
from helicoide.recorder.ros import typestore
from helicoide.recorder.streams import read_mcap
from helicoide.text import HelicoideError, Text

MOST_UNPACKED, MOST_FILES = 500_000_000, 64
TOO_LARGE = Text(
    en="its files are larger than {mb:.0f} MB in all, or more than {n}",
    pt_BR="seus arquivos passam de {mb:.0f} MB no total, ou são mais de {n}",
).format(mb=MOST_UNPACKED / 1e6, n=MOST_FILES)
NO_BAG = Text(
    en="there is no rosbag in it: a folder with metadata.yaml, or a .bag, .db3 or .mcap file",
    pt_BR="não há rosbag nele: uma pasta com metadata.yaml, ou um arquivo .bag, .db3 ou .mcap",
)


def read_bag(path: Path, content: Gathering) -> bool:
    """Gather the messages of a rosbag, a file or a folder. Raises what its parsers raise."""
    with AnyReader([path], default_typestore=typestore()) as bag:
        known = [one for one in bag.connections if content.wants(one.topic, one.msgtype)]
        for connection, ns, data in bag.messages(known) if known else ():
            content.add(connection.topic, connection.msgtype, ns, bag.deserialize(data, connection.msgtype))
    return True


def read_zip(path: Path, content: Gathering) -> bool:
    """Gather the messages of the rosbag in a zip file; returns whether it is read to its end."""
    with zipfile.ZipFile(path) as packed, TemporaryDirectory(prefix="helicoide") as folder:
        entries = [entry for entry in packed.infolist() if not entry.is_dir()]
        if len(entries) > MOST_FILES or sum(entry.file_size for entry in entries) > MOST_UNPACKED:
            raise HelicoideError(TOO_LARGE)
        packed.extractall(folder)  # which removes ".." and drives from the names
        return _read_unpacked(Path(folder), content)


def _read_unpacked(folder: Path, content: Gathering) -> bool:
    described = sorted(folder.rglob("metadata.yaml"))
    if described:
        return read_bag(described[0].parent, content)
    files = [file for file in sorted(folder.rglob("*")) if file.suffix.lower() in READERS]
    if not files:
        raise HelicoideError(NO_BAG)
    return READERS[files[0].suffix.lower()](files[0], content)


READERS: Mapping[str, Callable[[Path, Gathering], bool]] = {".mcap": read_mcap, ".bag": read_bag, ".db3": read_bag}
