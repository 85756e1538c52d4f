"""Say what is installed, compiled and found."""

from __future__ import annotations

import platform
import shutil
from importlib import import_module
from importlib.metadata import PackageNotFoundError, version

from helicoide import __version__, content, kernels

PACKAGES = ("viser", "numpy", "numba", "trimesh", "yourdfpy", "tyro", "latex2mathml")
BROWSERS = ("chromium", "chromium-browser", "google-chrome")


def run() -> None:
    """Print versions, kernels compiled or not, the browser for the tests, robots and lessons."""
    print(f"helicoide {__version__} · Python {platform.python_version()} · {platform.system()}")
    print("packages: " + ", ".join(f"{name} {_version(name)}" for name in PACKAGES))
    import_module("helicoide.session")  # makes the kernels known
    compiled = sum(map(kernels.is_cached, kernels.KERNELS))
    print(f"kernels: {compiled} of {len(kernels.KERNELS)} compiled in {kernels.CACHE_FOLDER}")
    if kernels.CACHE_NOTE is not None:
        print(f"         {kernels.CACHE_NOTE.en}")
    found = next(filter(None, map(shutil.which, BROWSERS)), None)
    print(f"browser for the tests: {found or 'not found (install chromium)'}")
    for kind in ("robots", "lessons"):
        names = content.found(kind)
        print(f"{kind}: {', '.join(names) or 'none'}  ({content.SHIPPED / kind})")
    print(f"your own robots and lessons: {content.user_folder()}")


def _version(name: str) -> str:
    try:
        return version(name)
    except PackageNotFoundError:
        return "missing"
