"""Takes names and the user's own paths out of a text; what stands there instead says of which kind it was.

A name is found in any case, in both of Unicode's normal forms (macOS decomposes file names), as a file's name is made of it,
and as JSON, a URL or ``repr`` write it.  Names of fewer than five characters are found as whole words only: an order
called "12" must not take the digits out of every figure.
"""

from __future__ import annotations

import json
import re
import sys
import unicodedata
from collections.abc import Iterable
from pathlib import Path
from urllib.parse import quote

from scanner_core.support.private_names import Mark, PrivateName

_WHOLE_WORD_BELOW = 5
_SUFFIXES = "impronta|stl|ply|obj|vtp|3mf|xyz|txt|csv|asc|npy|dcm|pdf|html|toml|json|jsonl|zip|avi|mp4|mkv|mov|png|jpe?g|tiff?|bmp|part|log"
_KEPT = r"(?:dev|proc|sys|usr|lib|etc|run|bin|sbin)(?=[\\/])"
"""Folders of the system: what lies there is nobody's, and says much."""
_QUOTED = re.compile(rf"""(["'])(?:(?!\1)[^\n]){{0,400}}?(\.(?:{_SUFFIXES})(?:-wal|-shm)?)\1""", re.IGNORECASE)
_ABSOLUTE = re.compile(rf"""(?<![\w\]\\/:.])(?:~|[A-Za-z]:)?[\\/](?!{_KEPT})[^"'\n<>|*?]{{0,400}}?(\.(?:{_SUFFIXES}))\b""", re.IGNORECASE)
_NAME = r"""[^\s"'\\/:=({,]{1,255}"""
_BARE = re.compile(rf"""(?<![^\s"'\\/:=({{,])(?:{_NAME}[\\/])*{_NAME}(\.(?:{_SUFFIXES})(?:-wal|-shm)?)(?![\w.])""", re.IGNORECASE)
_BENEATH_HOME = re.compile(r"""(?P<quote>["'])?~[\\/](?(quote)(?:(?!(?P=quote))[^\n])*|[^\s"'<>|,;)]*)""")
_HOMES = re.compile(r"((?:/home/|/Users/|[A-Za-z]:\\{1,2}(?:Users|Documents and Settings)\\{1,2}))([^\\/\s\"'<>:|]+)", re.IGNORECASE)
_LOGIN = re.compile(r"(?<=://)[^\s/@\"']+@")
_OURS = ("[program]", "[python]", Mark.FILE, "bench.toml", "workshop.toml", "paper-2003.toml", "settings.json", "impronta.log")
"""How files begin that are the program's, or were taken out before."""
_LETTERS = str.maketrans({"ä": "ae", "ö": "oe", "ü": "ue", "ß": "ss", "Ä": "Ae", "Ö": "Oe", "Ü": "Ue", "ø": "oe", "å": "aa", "æ": "ae", "ł": "l"})
"""As people write them in the names of files."""
_WORD = re.compile(r"\w+")
_MAIL = re.compile(r"(?<![\w.+-])[\w.+-]{1,64}@[\w-]+(?:\.[\w-]+)+")


class Redactor:
    """Call it with a text."""

    def __init__(self, names: Iterable[PrivateName] = ()) -> None:
        self._marks: dict[str, Mark] = {}
        for name in names:
            for variant in _variants(name.text):
                self._marks.setdefault(variant.lower(), name.mark)
        longest_first = sorted(self._marks, key=len, reverse=True)
        self._longest_first = [(name, max(_WORD.findall(name), key=len, default="")) for name in longest_first]
        self._places = _places()

    def __call__(self, text: str) -> str:
        for pattern, place in self._places:
            text = pattern.sub(place, text)
        text = _HOMES.sub(lambda found: found[1] + Mark.USER, text)
        text = _LOGIN.sub("[login]@", text)
        text = self._without_names(text)
        text = _MAIL.sub(lambda found: found[0] if "[login]" in found[0] else "[mail]", text)
        return self._without_paths(text)

    def _without_names(self, text: str) -> str:
        lower = text.lower()
        words = " ".join(set(_WORD.findall(lower)))  # hundreds of names are looked for in the words of a long log, not in all of it
        there = [_pattern(name) for name, key in self._longest_first if key in words and name in lower]
        return re.sub("|".join(there), self._mark, text, flags=re.IGNORECASE) if there else text

    def _without_paths(self, text: str) -> str:
        text = _QUOTED.sub(lambda found: found[0] if _is_ours(found[0][1:]) else f"{found[1]}{Mark.FILE}{found[2]}{found[1]}", text)
        text = _ABSOLUTE.sub(lambda found: f"{Mark.FILE}{found[1]}", text)
        text = _BARE.sub(lambda found: found[0] if _is_ours(found[0]) else f"{Mark.FILE}{found[1]}", text)
        return _BENEATH_HOME.sub(lambda found: f"{found['quote'] or ''}~/{Mark.FOLDER}", text)

    def _mark(self, found: re.Match[str]) -> str:
        return self._marks.get(found[0].lower(), Mark.FILE).value  # letters that only Unicode's case folding makes equal


def _is_ours(text: str) -> bool:
    return text.startswith(_OURS)


def _variants(name: str) -> set[str]:
    """How a name may be written: as entered, in capitals, without accents, as the name of a file, escaped."""
    bare = "".join(letter for letter in unicodedata.normalize("NFKD", name) if not unicodedata.combining(letter))
    found: set[str] = set()
    shapes = (name, name.upper(), name.translate(_LETTERS), bare)
    for text in (unicodedata.normalize(form, shape) for form in ("NFC", "NFD") for shape in shapes):
        stem = re.sub(r"[^\w.+-]+", "-", text).strip("-. ")
        for shape in (text, stem, text.replace("/", "\\"), text.replace("\\", "/"), re.sub(r"\s+", "_", text)):
            found |= {shape, json.dumps(shape)[1:-1], json.dumps(shape, ensure_ascii=False)[1:-1], quote(shape), quote(shape, safe="")}
            found |= {ascii(shape)[1:-1], repr(shape)[1:-1]}
    return {variant for variant in found if len(variant) >= min(3, len(name))}


def _pattern(variant: str) -> str:
    escaped = re.escape(variant)
    return rf"(?<![^\W_]){escaped}(?![^\W_])" if len(variant) < _WHOLE_WORD_BELOW else escaped


def _places() -> list[tuple[re.Pattern[str], str]]:
    """Long folders that everybody knows by a short name; the deepest first."""
    folders = {str(Path(__file__).resolve().parents[2]): "[program]", sys.prefix: "[python]", sys.base_prefix: "[python]"}
    try:
        folders[str(Path.home())] = "~"
        folders[str(Path.home().resolve())] = "~"
    except RuntimeError:  # nobody's home
        pass
    known = [(folder, short) for folder, short in folders.items() if len(Path(folder).parts) > 1 and folder not in ("/usr", "/usr/local")]
    made = []
    for folder, short in sorted(known, key=lambda entry: -len(entry[0])):
        shapes = dict.fromkeys((folder, folder.replace("\\", "\\\\"), quote(folder)))
        made.append((re.compile("(?:" + "|".join(map(re.escape, shapes)) + r")(?![^\\/\s\"':;,)\]])"), short))
    return made
