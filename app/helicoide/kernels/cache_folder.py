"""The cache folder of compiled kernels.

numba does not notice a change in another file that a kernel calls. The name of the folder is therefore a digest of all
files with kernels.
"""

from __future__ import annotations

import atexit
import hashlib
import os
import shutil
import tempfile
from contextlib import suppress
from pathlib import Path

from platformdirs import user_cache_path

from helicoide.text import Text

# Bytes written as a test, as an empty file can be made on a full disk. All kernels together take about 10 MB.
PROBE = bytes(1 << 16)
KERNEL_SUFFIX = ".kernel"


def _digest() -> str:
    """Digest of the sources of all kernels of the package and of this package, which compiles and saves them."""
    digest, here = hashlib.sha256(), Path(__file__).parent
    for file in sorted(here.parent.rglob("*.py")):
        source = file.read_bytes()
        if file.parent == here or b"@kernel" in source:
            digest.update(source)
    return digest.hexdigest()[:12]


def _is_usable(folder: Path) -> bool:
    """Whether kernels can be saved there, or are there already."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder) as file:
            file.write(PROBE)
        return True
    except OSError:
        return any(folder.glob(f"*{KERNEL_SUFFIX}"))


def choose_cache_folder() -> tuple[Path, Text | None]:
    """The folder, and an explanation if it is not the usual one."""
    name = _digest()
    given = Path(os.environ.get("NUMBA_CACHE_DIR") or user_cache_path("helicoide") / "kernels")
    usual = given if given.name == name else given / name  # a child process inherits the chosen folder
    if _is_usable(usual):
        return usual, None
    with suppress(OSError):
        temporary = Path(tempfile.mkdtemp(prefix="helicoide-"))
        atexit.register(shutil.rmtree, temporary, ignore_errors=True)
        if _is_usable(temporary / name):
            return temporary / name, _TEMPORARY.format(usual=usual, temporary=temporary)
    return usual, _NOWHERE.format(usual=usual)


_TEMPORARY = Text(
    en="The cache folder {usual} cannot be written; kernels are compiled into {temporary} for this run only.",
    pt_BR="Não dá para escrever na pasta de cache {usual}; os kernels são compilados em {temporary} só nesta vez.",
)
_NOWHERE = Text(
    en="The cache folder {usual} cannot be written, nor can a temporary one; kernels are not kept.",
    pt_BR="Não dá para escrever na pasta de cache {usual} nem numa temporária; os kernels não são guardados.",
)
