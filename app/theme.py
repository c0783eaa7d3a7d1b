"""How the window looks now: Fusion in one of two palettes, which may change while the program runs.

Read `look` while painting, or when a widget is told that its palette changed (``QEvent.Type.PaletteChange``); a colour that is
kept would be yesterday's.  Icons and :class:`Sign` name their colours and are drawn anew by themselves.
"""

from __future__ import annotations

from functools import lru_cache
from importlib import resources
from typing import Final, cast

from PySide6.QtCore import QByteArray, QEvent, QRect, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFont, QFontDatabase, QGuiApplication, QIcon, QIconEngine, QPainter, QPalette, QPixmap
from PySide6.QtSvg import QSvgRenderer
from PySide6.QtWidgets import QApplication, QLabel

from app.palettes import DARK, LIGHT, Palette
from app.style_sheet import style_sheet

THEMES: Final = ("system", "dark", "light")


class _Present:
    """Answers with the colours of the palette in use."""

    def __init__(self) -> None:
        self.palette = DARK

    def __getattr__(self, name: str) -> object:
        return getattr(self.palette, name)


_present = _Present()
look: Final = cast(Palette, _present)
"""The palette in use: ``look.text`` is its text colour as "#rrggbb"."""


def look_of(colour: str) -> str:
    """The colour of that name, a field of :class:`Palette`."""
    return str(getattr(_present.palette, colour))


def is_dark() -> bool:
    return _present.palette is DARK


def set_theme(application: QApplication, theme: str) -> None:
    """One of ``THEMES``, for everything that is shown and will be; "system" asks the desktop, and is dark where that says nothing."""
    hints = application.styleHints()
    if theme == "system":
        hints.unsetColorScheme()
        palette = LIGHT if hints.colorScheme() is Qt.ColorScheme.Light else DARK
    else:
        palette = LIGHT if theme == "light" else DARK
        hints.setColorScheme(Qt.ColorScheme.Light if palette is LIGHT else Qt.ColorScheme.Dark)  # of the window's frame too
    if palette is _present.palette and application.styleSheet():
        return  # a style sheet costs every widget a polish: a second for the whole window
    _present.palette = palette
    if not application.styleSheet() and application.style().name() != "fusion":  # a style sheet's style has no name
        application.setStyle("Fusion")
    application.setPalette(_qt_palette(palette))
    font = _font(application)
    if font != application.font():
        application.setFont(font)
    icons = str(resources.files("resources") / "icons").replace("\\", "/")
    kind = "" if palette is DARK else "-light"
    application.setStyleSheet(style_sheet(palette, chevron=f"{icons}/chevron{kind}.svg", ticked=f"{icons}/ticked{kind}.svg"))


def _qt_palette(colours: Palette) -> QPalette:
    palette = QPalette()
    for role, colour in (
        (QPalette.ColorRole.Window, colours.panel),
        (QPalette.ColorRole.WindowText, colours.text),
        (QPalette.ColorRole.Base, colours.field),
        (QPalette.ColorRole.AlternateBase, colours.panel),
        (QPalette.ColorRole.Text, colours.text),
        (QPalette.ColorRole.Button, colours.raised),
        (QPalette.ColorRole.ButtonText, colours.text),
        (QPalette.ColorRole.Highlight, colours.accent_dim),
        (QPalette.ColorRole.HighlightedText, colours.text),
        (QPalette.ColorRole.PlaceholderText, colours.faint),
        (QPalette.ColorRole.ToolTipBase, colours.raised),
        (QPalette.ColorRole.ToolTipText, colours.text),
        (QPalette.ColorRole.Link, colours.accent),
        (QPalette.ColorRole.Light, colours.hovered),
        (QPalette.ColorRole.Midlight, colours.raised),
        (QPalette.ColorRole.Mid, colours.seam),
        (QPalette.ColorRole.Dark, colours.ground),
        (QPalette.ColorRole.Shadow, "#000000"),
        (QPalette.ColorRole.Accent, colours.accent),
    ):
        palette.setColor(role, QColor(colour))
    for role in (QPalette.ColorRole.Text, QPalette.ColorRole.ButtonText, QPalette.ColorRole.WindowText):
        palette.setColor(QPalette.ColorGroup.Disabled, role, QColor(colours.faint))
    return palette


def _font(application: QApplication) -> QFont:
    font = QFont("Inter") if "Inter" in QFontDatabase.families() else QFont(application.font())
    font.setPixelSize(13)
    font.setHintingPreference(QFont.HintingPreference.PreferNoHinting)
    font.setFeature(QFont.Tag("tnum"), 1)
    return font


# ------------------------------------------------------------------------------------ drawings
def icon(name: str, colour: str = "text", checked: str | None = None) -> QIcon:
    """A drawing of ``resources/icons`` in the palette's `colour` (and in `checked` where a button is switched on), whichever is in use."""
    return QIcon(_Drawn(name, colour, checked or colour))


class _Drawn(QIconEngine):
    def __init__(self, name: str, colour: str, checked: str) -> None:
        super().__init__()
        self._name, self._colour, self._checked = name, colour, checked

    def pixmap(self, size: QSize, mode: QIcon.Mode, state: QIcon.State) -> QPixmap:
        colour = "faint" if mode == QIcon.Mode.Disabled else self._checked if state == QIcon.State.On else self._colour
        return _picture(self._name, look_of(colour), size.width(), size.height())

    def paint(self, painter: QPainter, rect: QRect, mode: QIcon.Mode, state: QIcon.State) -> None:
        ratio = painter.device().devicePixelRatioF()
        painter.drawPixmap(rect, self.pixmap(rect.size() * ratio, mode, state))

    def clone(self) -> QIconEngine:
        return _Drawn(self._name, self._colour, self._checked)

    def isNull(self) -> bool:  # noqa: N802 - Qt's name
        return False


def forget_drawings(application: QApplication) -> None:
    """Before the interpreter ends: what draws itself in Python, and pictures, must not outlive it and the application."""
    application.setWindowIcon(QIcon())
    _picture.cache_clear()


class Sign(QLabel):
    """A drawing in one of the palette's colours, square, `side` high."""

    def __init__(self, side: int, name: str = "", colour: str = "text") -> None:
        super().__init__()
        self._side, self._name, self._colour = side, name, colour
        self.setFixedSize(side, side)
        self._draw()

    def show_sign(self, name: str, colour: str) -> None:
        self._name, self._colour = name, colour
        self._draw()

    def changeEvent(self, event: QEvent) -> None:  # noqa: N802 - Qt's name
        if event.type() == QEvent.Type.PaletteChange:
            self._draw()
        super().changeEvent(event)

    def _draw(self) -> None:
        if self._name:
            self.setPixmap(drawing(self._name, self._colour, QSize(self._side, self._side)))


def drawing(name: str, colour: str, size: QSize, ratio: float | None = None) -> QPixmap:
    """A drawing in the palette's `colour` as it is now, for the screen's own pixel ratio when none is given."""
    if ratio is None:
        screen = QGuiApplication.primaryScreen()
        ratio = screen.devicePixelRatio() if screen is not None else 1.0
    picture = QPixmap(_picture(name, look_of(colour), round(size.width() * ratio), round(size.height() * ratio)))
    picture.setDevicePixelRatio(ratio)
    return picture


@lru_cache(maxsize=512)
def _picture(name: str, colour: str, width: int, height: int) -> QPixmap:
    svg = (resources.files("resources") / "icons" / f"{name}.svg").read_text(encoding="utf-8").replace("currentColor", colour)
    picture = QPixmap(width, height)
    picture.fill(Qt.GlobalColor.transparent)
    painter = QPainter(picture)
    QSvgRenderer(QByteArray(svg.encode())).render(painter, QRectF(0, 0, width, height))
    painter.end()
    return picture
