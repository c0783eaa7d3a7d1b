"""The libraries that the program came with, each with its licence and that licence's text, read from what is installed."""

from __future__ import annotations

import re
import sys
import sysconfig
from dataclasses import dataclass
from importlib import resources
from importlib.metadata import Distribution, PackageNotFoundError, distribution
from pathlib import Path

_TEXTS = re.compile(r"(^|/)(LICEN[CS]E|COPYING|NOTICE|AUTHORS|.*[-_.]LICEN[CS]E)[^/]*$", re.IGNORECASE)
_MOST_CHARACTERS = 400_000
_OWN = "impronta"
_COMMON = {"LGPL-3.0": ("LGPL-3.0", "GPL-3.0")}  # the first adds to the second


@dataclass(frozen=True, slots=True)
class Library:
    """One library.

    Attributes
    ----------
    licence : in a word, as its makers say it; empty when they say nothing
    text : the texts of its licence, each under the name of its file; empty when it ships none
    """

    name: str
    version: str
    licence: str
    text: str


def shipped_libraries() -> tuple[Library, ...]:
    """Python and everything that the program needs, by name; what is not installed is left out.  Takes a moment: it reads files."""
    found: dict[str, Library] = {}
    waiting = [_OWN]
    seen: set[str] = set()
    while waiting:
        name = waiting.pop()
        key = re.sub(r"[-_.]+", "-", name).casefold()
        if key in seen:
            continue
        seen.add(key)
        try:
            there = distribution(name)
        except PackageNotFoundError:
            continue
        waiting += [_name(line) for line in there.requires or () if "extra ==" not in line]
        if key != _OWN:
            found[key] = _library(there)
    return (_python(), *(found[key] for key in sorted(found)))


def _name(requirement: str) -> str:
    """The name that a requirement begins with; PEP 508."""
    matched = re.match(r"[A-Za-z0-9][A-Za-z0-9._-]*", requirement)
    return matched[0] if matched else ""


def _library(there: Distribution) -> Library:
    tags = there.metadata
    classified = [line.split(" :: ")[-1] for line in tags.get_all("Classifier") or () if line.startswith("License ::")]
    expression, free = (tags[key].strip() if key in tags else "" for key in ("License-Expression", "License"))
    said = expression or ("" if "\n" in free else free) or ", ".join(classified)
    files = [file for file in there.files or () if _TEXTS.search(str(file)) and not str(file).endswith((".py", ".pyc"))]
    texts = []
    for file in sorted(files, key=str):
        try:
            texts.append(f"{file.name}\n\n{Path(str(file.locate())).read_text(encoding='utf-8', errors='replace').strip()}")
        except OSError:
            continue
    texts += [f"{name}\n\n{_common(name)}" for name in _COMMON if not texts and any(part.startswith(name) for part in said.split(" OR "))]
    return Library(tags["Name"], there.version, said, "\n\n\n".join(texts)[:_MOST_CHARACTERS])


def _common(name: str) -> str:
    """The text of a licence that its library does not bring along."""
    return "\n\n\n".join((resources.files("resources") / "licences" / f"{part}.txt").read_text(encoding="utf-8").strip() for part in _COMMON[name])


def _python() -> Library:
    version = ".".join(str(part) for part in sys.version_info[:3])
    for folder in (sysconfig.get_path("stdlib"), sys.base_prefix):
        file = Path(folder) / "LICENSE.txt"
        if file.is_file():
            return Library("Python", version, "PSF-2.0", file.read_text(encoding="utf-8", errors="replace"))
    return Library("Python", version, "PSF-2.0", sys.copyright)
