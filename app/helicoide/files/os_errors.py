"""Errors of the operating system for files and ports, in both languages; its own messages are for programmers."""

from __future__ import annotations

import errno
import socket

from helicoide.text import Text

_NO_PERMISSION = Text(en="its permissions do not allow it", pt_BR="as permissões não deixam")
_FULL = Text(en="the disk is full", pt_BR="o disco está cheio")
_MISSING = Text(en="there is no such file or folder", pt_BR="esse arquivo ou pasta não existe")
_WHY = {
    errno.ENOENT: _MISSING,
    errno.ENOTDIR: _MISSING,
    errno.EISDIR: Text(en="it is a folder", pt_BR="é uma pasta"),
    errno.EACCES: _NO_PERMISSION,
    errno.EPERM: _NO_PERMISSION,
    errno.EROFS: Text(en="the disk is read-only", pt_BR="o disco é só de leitura"),
    errno.ENOSPC: _FULL,
    errno.EDQUOT: _FULL,
    errno.ENAMETOOLONG: Text(en="the name is too long", pt_BR="o nome é longo demais"),
    errno.EADDRINUSE: Text(en="another program has it", pt_BR="outro programa a ocupa"),
    errno.EADDRNOTAVAIL: Text(en="this machine has no such address", pt_BR="esta máquina não tem esse endereço"),
}
NO_HOST = Text(en="there is no host of that name", pt_BR="não existe máquina com esse nome")
_REFUSED = Text(en="the system refuses it ({code})", pt_BR="o sistema não deixa ({code})")


def os_error_reason(error: OSError) -> Text:
    """The reason of an OSError as part of a sentence; rare errors by their code alone, such as EIO."""
    if isinstance(error, socket.gaierror):  # its error numbers are not those of errno
        return NO_HOST
    code = errno.errorcode.get(error.errno or 0, type(error).__name__)
    return _WHY.get(error.errno or 0, _REFUSED.format(code=code))
