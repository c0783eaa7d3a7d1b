"""The names that leave this machine in no log and in no support bundle: orders, patients, files, the user, the machine."""

from __future__ import annotations

import getpass
import re
import socket
from collections.abc import Iterable
from contextlib import suppress
from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path, PurePath, PurePosixPath, PureWindowsPath

from scanner_core.toml_text import parse_toml

_LEAST = 3
"""Shorter names are as good as any letter of the text, and identify nobody."""
_LEAST_PART = 4
_EVERYBODY = {
    *("admin", "administrator", "computer", "debian", "desktop", "docker", "fedora", "guest", "home", "host", "impronta", "localhost", "python"),
    *("rig", "root", "runner", "scan", "scanner", "test", "ubuntu", "user", "windows"),
}
"""Names of users and machines that are words of the program, or everybody's."""
_OURS = {
    "bench",
    "workshop",
    "paper-2003",
    "ear",
    "ear-pair",
    "arch",
    "heart",
    "sphere",
    "settings",
    "case",
    "mesh",
    "rig",
    "report",
    "certificate",
    "result",
}
"""Stems of files that say nothing of whose they are."""


class Mark(StrEnum):
    """What stands in the place of a name."""

    RIG = "[rig]"
    ORDER = "[order]"
    PATIENT = "[patient]"
    NOTES = "[notes]"
    FILE = "[file]"
    FOLDER = "[folder]"
    USER = "[user]"
    HOST = "[host]"


@dataclass(frozen=True, slots=True)
class PrivateName:
    """A text and what stands in its place."""

    text: str
    mark: Mark


def order_names(number: str = "", patient: str = "", remarks: str = "") -> list[PrivateName]:
    """Of an order's fields: each whole, the patient's and the order's also word by word, remarks by line."""
    names = [PrivateName(line.strip(), Mark.NOTES) for line in remarks.splitlines()]
    for text, mark in ((number, Mark.ORDER), (patient, Mark.PATIENT)):
        parts = [part for part in re.split(r"[\s,;/]+", text) if len(part) >= _LEAST_PART]
        names += [PrivateName(part, mark) for part in (text.strip(), *parts)]
    return _worth(names)


def file_names(paths: Iterable[str | PurePath]) -> list[PrivateName]:
    """Of files whose names a person chose: the whole path as it was given, and its name without the suffix."""
    names = []
    for path in map(str, paths):
        if path.startswith("/dev/"):
            continue
        pure: PurePath = PureWindowsPath(path) if "\\" in path else PurePosixPath(path)
        stem = pure.name
        while PurePath(stem).suffix and len(PurePath(stem).suffix) <= 10:
            stem = PurePath(stem).stem
        if stem.lower() not in _OURS:
            names.append(PrivateName(stem, Mark.FILE))
            names.append(PrivateName(pure.name, Mark.FILE))
        if len(pure.parts) > 1:
            names.append(PrivateName(path, Mark.FILE))
    return _worth(names)


def rig_names(rig_text: str) -> list[PrivateName]:
    """Of a rig file's text: what a laboratory calls its rig may be its own name."""
    with suppress(ValueError):
        name = parse_toml(rig_text).get("name")
        return _worth([PrivateName(name, Mark.RIG)] if isinstance(name, str) and name not in _OURS else [])
    return []


def folder_names(paths: Iterable[str | PurePath]) -> list[PrivateName]:
    """Of folders that a person chose: the whole path."""
    return _worth(PrivateName(str(path), Mark.FOLDER) for path in paths if len(PurePath(path).parts) > 1)


def machine_names() -> list[PrivateName]:
    """The user's and the machine's."""
    found: list[tuple[str, Mark]] = []
    with suppress(OSError, ImportError, KeyError):  # a user without a name
        found.append((getpass.getuser(), Mark.USER))
    with suppress(RuntimeError):
        found.append((Path.home().name, Mark.USER))
    host = socket.gethostname()
    found += [(host, Mark.HOST), (host.split(".")[0], Mark.HOST)]
    return [name for name in _worth(PrivateName(text, mark) for text, mark in found) if name.text.lower() not in _EVERYBODY]


def _worth(names: Iterable[PrivateName]) -> list[PrivateName]:
    return [name for name in dict.fromkeys(names) if len(name.text) >= _LEAST and not name.text.isspace()]
