"""LZF, with which PCD files are packed: literal runs, and repeats of what was unpacked before.

A control byte below 32 begins a run of so many bytes and one. In another its three upper bits hold the length of a
repeat less two, 7 for one that is told by the next byte; the five lower bits and one more byte hold how far back it
begins, less one.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from helicoide.kernels import kernel
from helicoide.perception.broken import BrokenFile
from helicoide.text import Text

Bytes = NDArray[np.uint8]


def unpack_lzf(packed: bytes, size: int) -> bytes:
    """The bytes that were packed; raises Broken unless they are so many."""
    out = np.empty(size, dtype=np.uint8)
    if unpack_kernel(np.frombuffer(packed, dtype=np.uint8), out) != size:
        raise BrokenFile(Text(en="its compressed points are damaged", pt_BR="os pontos comprimidos estão danificados"))
    return out.tobytes()


@kernel
def unpack_kernel(packed: Bytes, out: Bytes) -> int:
    """Unpack into out; returns how many bytes were written, or −1 where that is impossible."""
    i, o = 0, 0
    while i < packed.shape[0]:
        control = int(packed[i])
        i += 1
        if control < 32:
            length = control + 1
            if i + length > packed.shape[0] or o + length > out.shape[0]:
                return -1
            out[o : o + length] = packed[i : i + length]
            i += length
        else:
            length = (control >> 5) + 2
            if i + (2 if length == 9 else 1) > packed.shape[0]:
                return -1
            if length == 9:
                length += int(packed[i])
                i += 1
            back = o - ((control & 31) << 8) - int(packed[i]) - 1
            i += 1
            if back < 0 or o + length > out.shape[0]:
                return -1
            for k in range(length):  # one by one: a repeat may run into itself
                out[o + k] = out[back + k]
        o += length
    return o
