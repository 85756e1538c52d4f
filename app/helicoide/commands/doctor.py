"""Report installed packages, compiled kernels, and the robots and lessons found."""

from __future__ import annotations

import platform
import shutil
from importlib import import_module
from importlib.metadata import PackageNotFoundError, version

from helicoide import __version__, content, kernels
from helicoide.commands import language
from helicoide.text import Text, untranslated

PACKAGES = ("viser", "numpy", "numba", "trimesh", "yourdfpy", "tyro", "latex2mathml")
BROWSERS = ("chromium", "chromium-browser", "google-chrome")
INSTALLED = Text(en="packages: {names}", pt_BR="pacotes: {names}")
MISSING = Text(en="missing", pt_BR="faltando")
KERNELS = Text(
    en="kernels: {n} of {count} compiled in {folder}", pt_BR="kernels: {n} de {count} compilados em {folder}"
)
BROWSER = Text(en="browser for the tests: {found}", pt_BR="navegador para os testes: {found}")
NO_BROWSER = Text(en="not found (install chromium)", pt_BR="não encontrado (instale o chromium)")
FOUND: dict[content.ContentKind, Text] = {
    "robots": Text(en="robots: {names}  ({folder})", pt_BR="robôs: {names}  ({folder})"),
    "lessons": Text(en="lessons: {names}  ({folder})", pt_BR="lições: {names}  ({folder})"),
}
USER_FOLDER = Text(
    en="your own robots, lessons, methods and studies, and progress in lessons: {folder}",
    pt_BR="seus robôs, lições, métodos e estudos, e o progresso nas lições: {folder}",
)


def run() -> None:
    """Print versions, kernels compiled or not, the browser for the tests, robots and lessons."""
    spoken = language()
    print(f"helicoide {__version__} · Python {platform.python_version()} · {platform.system()}")
    print(INSTALLED.format(names=", ".join(f"{name} {_version(name)[spoken]}" for name in PACKAGES))[spoken])
    import_module("helicoide.session.lab")  # makes the kernels known
    compiled = sum(map(kernels.is_cached, kernels.KERNELS))
    print(KERNELS.format(n=compiled, count=len(kernels.KERNELS), folder=kernels.CACHE_FOLDER)[spoken])
    if kernels.CACHE_NOTE is not None:
        print(f"         {kernels.CACHE_NOTE[spoken]}")
    found = next(filter(None, map(shutil.which, BROWSERS)), None)
    print(BROWSER.format(found=found or NO_BROWSER)[spoken])
    for kind, words in FOUND.items():
        print(
            words.format(names=", ".join(content.content_folders(kind)) or "-", folder=content.SHIPPED / kind)[spoken]
        )
    print(USER_FOLDER.format(folder=content.user_folder())[spoken])


def _version(name: str) -> Text:
    try:
        return untranslated(version(name))
    except PackageNotFoundError:
        return MISSING
