"""The translations fit the program: released as they stand, with every field, and without two equal mnemonics in a menu."""

from __future__ import annotations

import re
import shutil
import sys
import xml.etree.ElementTree as ET
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType

import pytest
from PySide6.QtCore import QCoreApplication, QLocale
from PySide6.QtWidgets import QApplication

from app.actions import ACTIONS
from app.language import LANGUAGES, Translation, system_language
from app.views.format import own_mark

ROOT = Path(__file__).parents[2]
OTHERS = [name for name in LANGUAGES if name != "en"]
FIELD = re.compile(r"\{[^{}]*\}")


@pytest.fixture
def tool(monkeypatch: pytest.MonkeyPatch) -> Iterator[ModuleType]:
    monkeypatch.syspath_prepend(str(ROOT / "packaging"))
    yield __import__("translations")
    sys.modules.pop("translations", None)


def _translated(language: str) -> Iterator[tuple[str, str, str]]:
    """(context, English, translation) of what is finished."""
    for context in ET.parse(ROOT / "resources" / "translations" / f"impronta_{language}.ts").getroot().iter("context"):
        for message in context.iter("message"):
            translation = message.find("translation")
            if translation is not None and translation.get("type") is None and translation.text:
                yield context.findtext("name", ""), message.findtext("source", ""), translation.text


@pytest.mark.parametrize("language", OTHERS)
def test_what_the_program_reads_is_made_from_what_the_translators_wrote(language: str, tool: ModuleType, tmp_path: Path) -> None:
    tool.release(language, tmp_path / "now.qm")
    assert (tmp_path / "now.qm").read_bytes() == (ROOT / "resources" / "translations" / f"impronta_{language}.qm").read_bytes()


def test_every_text_of_the_program_is_translated(tool: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """As the program is now: also a text that came in since the .ts files were last brought up to date."""
    for language in OTHERS:
        shutil.copy(ROOT / "resources" / "translations" / f"impronta_{language}.ts", tmp_path)
    monkeypatch.setattr(tool, "FOLDER", tmp_path)
    tool.update(OTHERS)
    assert {language: tool.unfinished(tool.ts_file(language)) for language in OTHERS} == {language: {} for language in OTHERS}


@pytest.mark.parametrize("language", OTHERS)
def test_a_translation_has_the_fields_of_its_source(language: str) -> None:
    wrong = [
        (context, source, words)
        for context, source, words in _translated(language)
        if Counter(FIELD.findall(source)) != Counter(FIELD.findall(words))
    ]
    assert not wrong


@pytest.mark.parametrize("language", OTHERS)
def test_a_translation_begins_and_ends_like_its_source(language: str) -> None:
    """Blanks at its ends, lines, the ellipsis of what opens a dialogue, and the mark of a mnemonic."""
    wrong = []
    for context, source, words in _translated(language):
        lines = source.count("\n") == words.count("\n")
        blanks = (source[:1] == " ", source[-1:] == " ") == (words[:1] == " ", words[-1:] == " ")
        if not (lines and blanks and source.endswith("…") == words.endswith("…") and ("&" in source) == ("&" in words)):
            wrong.append((context, source, words))
    assert not wrong


@pytest.mark.parametrize("language", LANGUAGES)
def test_no_two_entries_of_a_menu_have_the_same_mnemonic(language: str, application: QApplication) -> None:
    translation = Translation(application, language)
    try:
        menus = {info.menu for info in ACTIONS if info.menu}
        bars = {"the menu bar": list(menus), **{menu: [info.text for info in ACTIONS if info.menu == menu] for menu in menus}}
        for name, texts in bars.items():
            shown = [QCoreApplication.translate("actions", text) for text in texts]
            letters = [found[1].casefold() for text in shown if (found := re.search(r"&([^&])", text))]
            assert not [letter for letter, times in Counter(letters).items() if times > 1], (name, shown)
    finally:
        translation.remove()


def test_a_language_brings_its_decimal_mark_and_goes_again(application: QApplication) -> None:
    before = QLocale().name()
    translation = Translation(application, "de")
    assert QLocale().decimalPoint() == ","
    assert QCoreApplication.translate("QPlatformTheme", "Cancel") == "Abbrechen"
    translation.remove()
    assert QLocale().name() == before
    assert QCoreApplication.translate("QPlatformTheme", "Cancel") == "Cancel"


def test_every_number_with_decimals_has_the_persons_mark() -> None:
    """``fmt.decimal`` writes them; Python's own format knows only the point."""
    format_of_python = re.compile(r"\{[^{}]*:[+]?\.[1-9]f\}")
    files = [path for path in sorted((ROOT / "app").rglob("*.py")) if path.name != "format.py"]
    assert not [f"{path.name}: {found[0]}" for path in files for found in format_of_python.finditer(path.read_text(encoding="utf-8"))]


def test_figures_of_the_cores_sentences_have_the_persons_mark(application: QApplication) -> None:
    translation = Translation(application, "de")
    try:
        fields = {"percent": "0.20", "shift": -1.5, "count": 12, "firmware": "Grbl 1.1", "path": "a.stl"}
        assert own_mark(fields) == {**fields, "percent": "0,20", "shift": "-1,5"}
    finally:
        translation.remove()


def test_the_systems_first_language_that_the_window_speaks_is_taken(monkeypatch: pytest.MonkeyPatch) -> None:
    class System:
        languages: tuple[str, ...] = ()

        def uiLanguages(self) -> list[str]:  # noqa: N802 - Qt's name
            return list(self.languages)

    system = System()
    monkeypatch.setattr(QLocale, "system", lambda: system)
    for languages, wanted in ((("fr-FR", "it-CH", "de"), "it"), (("en-GB", "de"), "en"), (("de_AT", "en"), "de"), (("fr",), "en"), ((), "en")):
        system.languages = languages
        assert system_language() == wanted


def test_an_open_text_is_taken_in_and_a_vanished_one_is_told(tool: ModuleType, tmp_path: Path) -> None:
    file = tmp_path / "a.ts"
    file.write_text(
        '<?xml version="1.0" encoding="utf-8"?>\n<!DOCTYPE TS>\n<TS version="2.1" language="it"><context><name>pages</name><message>'
        '<source>Home</source><translation type="unfinished"></translation></message></context></TS>\n'
    )
    assert tool.unfinished(file) == {"pages": {"Home": ""}}
    assert tool.take(file, {"pages": {"Home": "Inizio", "Gone": "Via"}}) == [("pages", "Gone")]
    assert tool.unfinished(file) == {}
    assert "<translation>Inizio</translation>" in file.read_text()
