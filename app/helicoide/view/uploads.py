"""Uploads of files, one at a time, with limits on size, number of parts and waiting time.

viser alone would collect any number of files of any size, and keep the last file of each button.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import Any

import viser
from viser import GuiUploadButtonHandle, UploadedFile
from viser._messages import (
    FileTransferPart,
    FileTransferPartAck,
    FileTransferStartUpload,
    RemoveNotificationMessage,
)
from viser.infra import ClientId

from helicoide.text import Text

MOST_BYTES = 64_000_000
MOST_PARTS = 1024  # the page sends parts of 512 KiB
PATIENCE = 60.0

TOO_BIG = Text(
    en="This file has {mb:.0f} MB: a file may have up to {most:.0f} MB.",
    pt_BR="Este arquivo tem {mb:.0f} MB: um arquivo pode ter até {most:.0f} MB.",
)
BUSY = Text(
    en="Another file is still being uploaded: wait until it is done.",
    pt_BR="Outro arquivo ainda está sendo enviado: espere ele chegar.",
)
BROKEN = Text(
    en="The upload did not match its announced size and was discarded: send the file again.",
    pt_BR="O envio não correspondeu ao tamanho anunciado e foi descartado: envie o arquivo de novo.",
)
STALLED = Text(
    en="The upload was interrupted and discarded: send the file again.",
    pt_BR="O envio foi interrompido e descartado: envie o arquivo de novo.",
)


class Uploads:
    """The uploads of one window, one file at a time. `refuse` takes the reason why a file is not accepted.

    Use it only on the event loop of the server. The callback of a button has to read the file before its first await:
    afterwards the file is removed.
    """

    def __init__(self, client: viser.ClientHandle, refuse: Callable[[Text], None]) -> None:
        self._gui, self._connection, self._refuse = client.gui, client._websock_connection, refuse
        self._begun: FileTransferStartUpload | None = None
        self._deadline: asyncio.TimerHandle | None = None
        self._connection.unregister_handler(FileTransferStartUpload, self._gui._handle_file_transfer_start)
        self._connection.unregister_handler(FileTransferPart, self._gui._handle_file_transfer_part)
        self._connection.register_handler(FileTransferStartUpload, self._start)
        self._connection.register_handler(FileTransferPart, self._part)

    def close(self) -> None:
        """Drop an unfinished upload, and accept no more."""
        self._connection.unregister_handler(FileTransferStartUpload, self._start)
        self._connection.unregister_handler(FileTransferPart, self._part)
        self._end()

    def _start(self, client_id: ClientId, message: FileTransferStartUpload) -> None:
        """A file is announced."""
        button = self._button(message.source_component_uuid)
        if button is None or button.disabled or not isinstance(message.transfer_uuid, str):
            return
        why = BUSY if self._begun is not None else _why_not(message)
        if why is not None:
            self._decline(message, why)
            return
        self._begun = message
        self._wait()
        self._gui._handle_file_transfer_start(client_id, message)
        self._look_whether_done(message)

    def _part(self, client_id: ClientId, message: FileTransferPart) -> None:
        """A part of a file arrives; parts of a file that was not accepted are ignored."""
        begun = self._begun
        if begun is None or message.transfer_uuid != begun.transfer_uuid:
            return
        if not _fits(message, self._gui._current_file_upload_states[begun.transfer_uuid]):
            self._drop(BROKEN)
            return
        message.source_component_uuid = begun.source_component_uuid
        self._wait()
        self._gui._handle_file_transfer_part(client_id, message)
        self._look_whether_done(begun)

    def _look_whether_done(self, begun: FileTransferStartUpload) -> None:
        """When a file is complete, remove it from its button after the callbacks have run."""
        if begun.transfer_uuid not in self._gui._current_file_upload_states:
            self._end()
            self._hide(begun)
            self._gui._event_loop.call_soon(self._empty, begun.source_component_uuid)

    def _empty(self, uuid: str) -> None:
        button = self._button(uuid)
        if button is not None:
            button._impl.value = UploadedFile("", b"")

    def _button(self, uuid: object) -> GuiUploadButtonHandle | None:
        """The upload button with that uuid; None for other controls, and if `uuid` is not a string."""
        button = self._gui._gui_input_handle_from_uuid.get(uuid) if isinstance(uuid, str) else None
        return button if isinstance(button, GuiUploadButtonHandle) else None

    def _wait(self) -> None:
        """Start the time limit of the next part."""
        if self._deadline is not None:
            self._deadline.cancel()
        self._deadline = self._gui._event_loop.call_later(PATIENCE, self._drop, STALLED)

    def _drop(self, why: Text) -> None:
        """Drop an unfinished file, and say why."""
        begun = self._begun
        self._end()
        if begun is not None:
            self._decline(begun, why)

    def _end(self) -> None:
        """End the current upload and forget its parts."""
        if self._deadline is not None:
            self._deadline.cancel()
        if self._begun is not None:
            self._gui._current_file_upload_states.pop(self._begun.transfer_uuid, None)
        self._begun = self._deadline = None

    def _decline(self, message: FileTransferStartUpload, why: Text) -> None:
        """Say why a file is not accepted. The page is told that it is complete, or its button would stay locked."""
        of = {"source_component_uuid": message.source_component_uuid, "transfer_uuid": message.transfer_uuid}
        self._connection.queue_message(FileTransferPartAck(**of, transferred_bytes=1, total_bytes=1))
        self._hide(message)
        self._refuse(why)

    def _hide(self, message: FileTransferStartUpload) -> None:
        """Remove viser's own notification about a file, which is in English only."""
        self._connection.queue_message(RemoveNotificationMessage(f"upload-{message.transfer_uuid}"))


def _why_not(message: FileTransferStartUpload) -> Text | None:
    """Why a file is refused when it is announced; None if it is accepted."""
    size, parts = message.size_bytes, message.part_count
    if min(size, parts) < 0 or (size == 0) != (parts == 0):
        return BROKEN
    if size > MOST_BYTES:
        return TOO_BIG.format(mb=size / 1e6, most=MOST_BYTES / 1e6)
    return BROKEN if parts > MOST_PARTS else None


def _fits(message: FileTransferPart, state: Any) -> bool:
    """Whether a part was announced, has not come yet, and agrees with the announced size of the file."""
    index, content, parts = message.part_index, message.content, state["parts"]
    if not isinstance(content, bytes) or index in parts or not 0 <= index < state["part_count"]:
        return False
    bytes_left: int = state["total_bytes"] - state["transferred_bytes"] - len(content)
    return bytes_left == 0 if len(parts) + 1 == state["part_count"] else bytes_left >= 0
