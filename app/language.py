"""The language of the window: its own translations and Qt's, dates and decimal marks."""

from __future__ import annotations

from importlib import resources
from typing import Final

from PySide6.QtCore import QLibraryInfo, QLocale, QTranslator
from PySide6.QtWidgets import QApplication

LANGUAGES: Final = {"en": "English", "it": "Italiano", "de": "Deutsch"}
"""By code, each in its own words."""


class Translation:
    """What was installed into the application; :meth:`remove` it before another is.

    Parameters
    ----------
    language : a key of ``LANGUAGES``, or empty for the first of the system's languages that is one of them, else English
    """

    def __init__(self, application: QApplication, language: str) -> None:
        self._application = application
        locale = QLocale.system() if not language else QLocale(language)
        QLocale.setDefault(locale)
        self.language = spoken(language)
        self._translators: list[QTranslator] = []
        own = str(resources.files("resources") / "translations")
        qt = QLibraryInfo.path(QLibraryInfo.LibraryPath.TranslationsPath)
        for file, folder in ((f"qtbase_{self.language}", qt), (f"impronta_{self.language}", own)):
            translator = QTranslator(application)
            if self.language != "en" and translator.load(file, folder):
                application.installTranslator(translator)
                self._translators.append(translator)

    def remove(self) -> None:
        for translator in self._translators:
            self._application.removeTranslator(translator)
        self._translators = []
        QLocale.setDefault(QLocale.system())


def spoken(language: str) -> str:
    """The key of ``LANGUAGES`` that a setting stands for."""
    return language or system_language()


def system_language() -> str:
    """The first of the person's languages that the window speaks; English when there is none."""
    wanted = (name.replace("_", "-").split("-")[0].lower() for name in QLocale.system().uiLanguages())
    return next((name for name in wanted if name in LANGUAGES), "en")
