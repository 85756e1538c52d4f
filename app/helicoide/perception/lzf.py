"""LZF, the compression of PCD files: literal runs, and repeats of bytes that were unpacked before.

A control byte c below 32 begins a run of c + 1 literal bytes. Otherwise its three upper bits hold the length of a
repeat minus 2; if they are 7, the next byte is added. The five lower bits and one more byte hold the distance back to
its start, minus 1.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from helicoide.kernels import kernel
from helicoide.perception.broken import BrokenFile
from helicoide.text import Text

Bytes = NDArray[np.uint8]


def unpack_lzf(packed: bytes, size: int) -> bytes:
    """The unpacked bytes; raises BrokenFile unless there are exactly `size`."""
    out = np.empty(size, dtype=np.uint8)
    if unpack_kernel(np.frombuffer(packed, dtype=np.uint8), out) != size:
        raise BrokenFile(Text(en="its compressed points are damaged", pt_BR="os pontos comprimidos estão danificados"))
    return out.tobytes()


@kernel
def unpack_kernel(packed: Bytes, out: Bytes) -> int:
    """Unpack into out; returns the number of bytes written, or −1 for damaged data."""
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
            for k in range(length):  # byte by byte: a repeat may overlap itself
                out[o + k] = out[back + k]
        o += length
    return o
