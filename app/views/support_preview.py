"""An entry of the support bundle as a person reads it, with what was taken out marked."""

from __future__ import annotations

import re

from PySide6.QtCore import QEvent
from PySide6.QtGui import QColor, QFontDatabase, QSyntaxHighlighter, QTextCharFormat
from PySide6.QtWidgets import QPlainTextEdit, QWidget

from app.theme import look

MOST_CHARACTERS = 200_000
"""More than that nobody reads in a window; the archive holds all of it."""
_MARKS = re.compile(r"\[(?:order|patient|notes|file|folder|user|host|login|mail)\]|(?<![\w~])~(?=[/\\])")


class SupportPreview(QPlainTextEdit):
    """Read only; a long log is shown from its end, anything else from its beginning."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setReadOnly(True)
        self.setAccessibleName(self.tr("Content of the entry"))
        self.setLineWrapMode(QPlainTextEdit.LineWrapMode.NoWrap)
        self.setFont(QFontDatabase.systemFont(QFontDatabase.SystemFont.FixedFont))
        self._marks = _MarkHighlighter(self.document())

    def changeEvent(self, event: QEvent) -> None:  # noqa: N802 - Qt's name
        if event.type() == QEvent.Type.PaletteChange:
            self._marks.rehighlight()
        super().changeEvent(event)

    def show_text(self, text: str, *, from_end: bool) -> None:
        cut = len(text) > MOST_CHARACTERS
        part = text if not cut else text[-MOST_CHARACTERS:] if from_end else text[:MOST_CHARACTERS]
        first, last = self.tr("(Only the first part is shown; the file holds all.)"), self.tr("(Only the last part is shown; the file holds all.)")
        note = last if from_end else first
        self.setPlainText(part if not cut else f"{note}\n{part}" if from_end else f"{part}\n{note}")
        bar = self.verticalScrollBar()
        bar.setValue(bar.maximum() if from_end else 0)


class _MarkHighlighter(QSyntaxHighlighter):
    def highlightBlock(self, text: str) -> None:  # noqa: N802 - Qt's name
        mark, home = QTextCharFormat(), QTextCharFormat()
        mark.setForeground(QColor(look.text))
        mark.setBackground(QColor(look.accent_dim))
        home.setForeground(QColor(look.accent))
        for found in _MARKS.finditer(text):
            self.setFormat(found.start(), len(found[0]), home if found[0] == "~" else mark)
