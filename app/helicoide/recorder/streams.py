"""The messages of an MCAP file, read from its beginning: it needs no index, and may have lost its end."""

from __future__ import annotations

import logging
from collections.abc import Callable
from pathlib import Path
from typing import Any

from mcap.records import Channel, Message, Metadata, Schema
from mcap.stream_reader import StreamReader
from rosbags.typesys import Stores, get_types_from_msg, get_typestore
from rosbags.typesys.store import Typestore

from helicoide.recorder.gathering import Gathering
from helicoide.recorder.mcap_file import METADATA
from helicoide.recorder.ros import definition_text, typestore
from helicoide.text import HelicoideError

LARGEST_RECORD = 100_000_000
log = logging.getLogger("helicoide")
Decode = Callable[[bytes], Any]


def read_mcap(path: Path, content: Gathering) -> bool:
    """Gather the messages of an MCAP file; returns whether it is read to its end.

    What comes before a damaged place counts. Raises what the parsers raise if no message comes before it.
    """
    messages = _Messages(content)
    with path.open("rb") as file:
        try:
            for record in StreamReader(file, record_size_limit=LARGEST_RECORD).records:
                messages.take(record)
        except HelicoideError:
            raise
        except Exception:  # a damaged file makes the parsers raise errors of any kind
            log.info("%s ends at message %d", path.name, messages.count, exc_info=True)
            if not messages.count:
                raise
            return False
    return True


class _Messages:
    """Passes the messages of an MCAP file on, decoded by the definitions that the file carries."""

    def __init__(self, content: Gathering) -> None:
        self.content, self.count = content, 0
        self._schemas: dict[int, Schema] = {}
        self._channels: dict[int, tuple[str, str, Decode]] = {}

    def take(self, record: object) -> None:
        """Take a record of the file."""
        match record:
            case Schema():
                self._schemas[record.id] = record
            case Channel() if record.id not in self._channels and record.schema_id in self._schemas:
                self._open(record, self._schemas[record.schema_id])
            case Metadata() if record.name == METADATA:
                self.content.describe(record.metadata)
            case Message() if record.channel_id in self._channels:
                topic, kind, decode = self._channels[record.channel_id]
                self.content.add(topic, kind, record.log_time, decode(record.data))
                self.count += 1

    def _open(self, channel: Channel, schema: Schema) -> None:
        kind = schema.name if "/msg/" in schema.name else schema.name.replace("/", "/msg/")
        decoders = {"cdr": Typestore.deserialize_cdr, "ros1": Typestore.deserialize_ros1}
        if channel.message_encoding in decoders and self.content.wants(channel.topic, kind):
            decode, store = decoders[channel.message_encoding], _definitions(schema, kind)
            self._channels[channel.id] = channel.topic, kind, lambda data: decode(store, data, kind)


def _definitions(schema: Schema, kind: str) -> Typestore:
    """The definitions that the file carries; ours, which take no time to read, if they are the same."""
    ours = typestore()
    same = kind in ours.types and schema.data == definition_text(kind)
    if same or schema.encoding not in ("ros2msg", "ros1msg"):
        return ours
    store = get_typestore(Stores.EMPTY)
    store.register(get_types_from_msg(schema.data.decode(), kind))
    return store
