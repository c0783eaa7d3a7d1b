"""Where the program keeps what is the user's and no case: the window's settings, the log, and what can be made again."""

from __future__ import annotations

import os
import sys
from pathlib import Path


def log_folder() -> Path:
    """Of the log; it need not exist yet."""
    if sys.platform == "win32":
        return _local() / "Impronta" / "log"
    if sys.platform == "darwin" and not os.environ.get("XDG_STATE_HOME"):
        return Path.home() / "Library" / "Logs" / "Impronta"
    return Path(os.environ.get("XDG_STATE_HOME") or Path.home() / ".local" / "state") / "impronta"


def cache_folder() -> Path:
    """Of what can be thrown away at any time; it need not exist yet."""
    if sys.platform == "win32":
        return _local() / "Impronta" / "cache"
    if sys.platform == "darwin" and not os.environ.get("XDG_CACHE_HOME"):
        return Path.home() / "Library" / "Caches" / "Impronta"
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "impronta"


def settings_file() -> Path:
    """Of the window's settings, the place that Qt calls GenericConfigLocation; a test holds it to that."""
    if sys.platform == "win32":
        base = _local()
    elif sys.platform == "darwin":
        base = Path.home() / "Library" / "Preferences"
    else:
        base = Path(os.environ.get("XDG_CONFIG_HOME") or Path.home() / ".config")
    return base / "impronta" / "settings.json"


def _local() -> Path:
    return Path(os.environ.get("LOCALAPPDATA") or Path.home() / "AppData" / "Local")
