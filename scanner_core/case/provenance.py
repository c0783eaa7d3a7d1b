"""Where a mesh comes from: what is always written beside it, whoever made it."""

from __future__ import annotations

from functools import cache
from importlib.metadata import PackageNotFoundError, version

from scanner_core import __version__
from scanner_core.case.schema import VERSION

_PACKAGES = {"numpy": "numpy", "scipy": "scipy", "opencv": "opencv-contrib-python-headless", "vtk": "vtk"}


@cache
def versions() -> dict[str, object]:
    """The program's own version, the schema's, and those of the libraries that compute; nothing is imported for it."""
    return {"impronta": __version__, "schema": VERSION} | {name: _installed(package) for name, package in _PACKAGES.items()}


def _installed(package: str) -> str | None:
    try:
        return version(package)
    except PackageNotFoundError:
        return None
