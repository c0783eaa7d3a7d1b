"""Bring the translations up to date with the program, by Qt's own tools (they come with PySide6_Essentials).

    python packaging/translations.py                          both .ts files from all texts of the window and of the core, then the .qm files
    python packaging/translations.py --open it > open.json    what is not translated yet, {context: {English: ""}}
    python packaging/translations.py --take it done.json      put such a file's translations in, then the .qm files

The .ts files may be edited in Qt Linguist as well.  Texts that the core speaks in English and the window translates by code
(errors, remedies, checks before a delivery, remarks, faults of the virtual rig) are handed to lupdate as a source file of their own.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FOLDER = ROOT / "resources" / "translations"
LANGUAGES = ("it", "de")


def main(argv: Sequence[str]) -> int:
    parser = argparse.ArgumentParser(description="Bring the translations up to date.")
    parser.add_argument("--open", choices=LANGUAGES, metavar="LANGUAGE", help="print as JSON what is not translated yet")
    parser.add_argument("--take", nargs=2, metavar=("LANGUAGE", "FILE"), help="put the translations of a JSON file in")
    given = parser.parse_args(argv)
    if given.open:
        print(json.dumps(unfinished(ts_file(given.open)), ensure_ascii=False, indent=1))
        return 0
    languages: Sequence[str] = LANGUAGES
    if given.take:
        language, file = given.take
        languages = (language,)
        left = take(ts_file(language), json.loads(Path(file).read_text(encoding="utf-8")))
        for context, source in left:
            print(f"there is no such text (any more): {context}: {source}", file=sys.stderr)
    update(languages)
    for language in languages:
        release(language, FOLDER / f"impronta_{language}.qm")
        print(f"{language}: {sum(map(len, unfinished(ts_file(language)).values()))} texts without a translation")
    return 0


def ts_file(language: str) -> Path:
    return FOLDER / f"impronta_{language}.ts"


def update(wanted: Sequence[str]) -> None:
    """Every text of the program into the .ts files of these languages; a translation whose text is gone goes with it."""
    with tempfile.TemporaryDirectory() as folder:
        core = Path(folder) / "core_texts.py"
        core.write_text("".join(f"QT_TRANSLATE_NOOP({context!r}, {text!r})\n" for context, text in core_texts()), encoding="utf-8")
        sources = [str(path) for path in sorted((ROOT / "app").rglob("*.py"))]
        for language in wanted:
            options = ["-silent", "-no-obsolete", "-sort-messages", "-locations", "none", "-disable-heuristic", "similartext"]
            languages = ["-source-language", "en", "-target-language", language]
            _run("lupdate", *options, *languages, *sources, str(core), "-ts", str(ts_file(language)))


def release(language: str, into: Path) -> None:
    """The .qm file that the program reads; unfinished translations are left out of it."""
    _run("lrelease", "-silent", str(ts_file(language)), "-qm", str(into))


def core_texts() -> Iterator[tuple[str, str]]:
    """(context, English) of what the core says and the window translates."""
    sys.path.insert(0, str(ROOT))
    from scanner_core.comparison.doubt_sentences import DOUBTS
    from scanner_core.delivery.check_sentences import NAMES
    from scanner_core.delivery.check_sentences import SENTENCES as CHECKS
    from scanner_core.optics.calibration_result import FindingKind
    from scanner_core.reconstruction.remarks import RemarkKind
    from scanner_core.remedies import REMEDIES
    from scanner_core.sentences import SENTENCES
    from scanner_core.virtual.faults import FAULTS

    for sentence in SENTENCES.values():
        yield from (("sentences", text) for text in (sentence.what, sentence.do) if text)
    yield from (("remedies", text) for text in REMEDIES.values())
    yield from (("calibration", kind.value) for kind in FindingKind)
    yield from (("delivery", text) for text in (*NAMES.values(), *CHECKS.values()))
    yield from (("remarks", kind.value) for kind in RemarkKind)
    yield from (("doubts", text) for text in DOUBTS.values())
    for fault in FAULTS.values():
        yield from (("rig-faults", text) for text in (fault.title, fault.happens, fault.expected))


def unfinished(file: Path) -> dict[str, dict[str, str]]:
    """{context: {English: ""}} of what is not translated."""
    found: dict[str, dict[str, str]] = {}
    for context, message in _messages(ET.parse(file)):
        translation = message.find("translation")
        if translation is None or not translation.text or translation.get("type") == "unfinished":
            found.setdefault(context, {})[message.findtext("source", "")] = ""
    return found


def take(file: Path, done: Mapping[str, Mapping[str, str]]) -> list[tuple[str, str]]:
    """Put translations {context: {English: translation}} in; what no text of the file matches is returned."""
    tree = ET.parse(file)
    left = {(context, source): words for context, texts in done.items() for source, words in texts.items() if words}
    for context, message in _messages(tree):
        words = left.pop((context, message.findtext("source", "")), None)
        if words is not None:
            translation = message.find("translation")
            assert translation is not None
            translation.text = words
            translation.attrib.pop("type", None)
    text = ET.tostring(tree.getroot(), encoding="unicode", short_empty_elements=False)
    file.write_text(f'<?xml version="1.0" encoding="utf-8"?>\n<!DOCTYPE TS>\n{text}\n', encoding="utf-8")
    return list(left)


def _messages(tree: ET.ElementTree[ET.Element]) -> Iterator[tuple[str, ET.Element]]:
    for context in tree.getroot().iter("context"):
        for message in context.iter("message"):
            yield context.findtext("name", ""), message


def _run(tool: str, *arguments: str) -> None:
    import PySide6

    path = Path(next(iter(PySide6.__path__))) / (f"{tool}.exe" if sys.platform == "win32" else tool)
    subprocess.run([path, *arguments], check=True)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
