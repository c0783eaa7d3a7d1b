"""How the window looks: Fusion, three close greys, one accent, and red filled for the laser only.

Input widgets are left to the palette: a border or padding in the style sheet clips the value out of a spin box.
"""

from __future__ import annotations

from functools import cache
from importlib import resources

from PySide6.QtCore import QByteArray, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFont, QFontDatabase, QGuiApplication, QIcon, QPainter, QPalette, QPixmap
from PySide6.QtSvg import QSvgRenderer
from PySide6.QtWidgets import QApplication

GROUND = "#1c1f23"
"""Behind everything; also the colour of the seams."""
PANEL = "#23272c"
RAISED = "#2d3238"
SEAM = "#363c43"
TEXT = "#e8eaed"
MUTED = "#a3abb5"
FAINT = "#79828d"
ACCENT = "#4cc2ab"
ON_ACCENT = "#0b1f1b"
ACCENT_DIM = "#2a5a52"
LASER = "#e5484d"
WARNING = "#e8b04a"
LEFT_EAR = "#7fb2ff"
RIGHT_EAR = "#ff8a8a"
GOOD = "#62c98a"

_SHEET = f"""
QMainWindow, QDialog {{ background: {GROUND}; }}
QToolTip {{ background: {RAISED}; color: {TEXT}; border: 1px solid {SEAM}; padding: 4px; }}
QMenuBar {{ background: {PANEL}; border-bottom: 1px solid {SEAM}; }}
QMenuBar::item {{ padding: 4px 10px; background: transparent; }}
QMenuBar::item:selected {{ background: {RAISED}; }}
QWidget[role="panel"], QFrame[role="panel"] {{ background: {PANEL}; }}
QWidget[role="ground"] {{ background: {GROUND}; }}
QFrame[role="seam"] {{ background: {SEAM}; border: none; }}
QLabel[role="title"] {{ font-size: 17px; font-weight: 600; }}
QLabel[role="headline"] {{ font-size: 24px; font-weight: 600; }}
QLabel[role="section"] {{ font-size: 12px; font-weight: 600; color: {MUTED}; }}
QLabel[role="large"] {{ font-size: 32px; font-weight: 600; }}
QLabel[role="large-good"] {{ font-size: 32px; font-weight: 600; color: {GOOD}; }}
QLabel[role="muted"] {{ color: {MUTED}; }}
QLabel[role="faint"] {{ color: {FAINT}; font-size: 12px; }}
QLabel[role="unit"] {{ color: {MUTED}; font-size: 12px; }}
QLabel[role="number"] {{ font-size: 23px; font-weight: 600; }}
QLabel[role="hero"] {{ font-size: 52px; font-weight: 600; }}
QLabel[role="good"] {{ color: {GOOD}; }}
QLabel[role="bad"] {{ color: {WARNING}; }}
QLabel[role="notice"] {{ background: #352f22; border-left: 3px solid {WARNING}; padding: 9px 12px; }}
QPushButton {{ background: {RAISED}; border: 1px solid {SEAM}; border-radius: 5px; padding: 7px 14px; }}
QPushButton:hover {{ background: #373d44; }}
QPushButton:pressed {{ background: #262b30; }}
QPushButton:focus {{ border-color: {ACCENT}; }}
QPushButton:disabled {{ color: {FAINT}; background: {PANEL}; border-color: {RAISED}; }}
QPushButton:checked {{ border-color: {ACCENT}; color: {ACCENT}; }}
QPushButton[role="primary"] {{ background: {ACCENT}; color: {ON_ACCENT}; border-color: {ACCENT}; font-weight: 600; padding: 9px 16px; }}
QPushButton[role="primary"]:hover {{ background: #62d3bd; }}
QPushButton[role="primary"]:pressed {{ background: #3fa995; }}
QPushButton[role="primary"]:focus {{ border-color: {TEXT}; }}
QPushButton[role="primary"]:disabled {{ background: {ACCENT_DIM}; color: #9cc4bb; border-color: {ACCENT_DIM}; }}
QPushButton[role="laser"] {{ background: transparent; color: #ff8589; border: 1px solid {LASER}; font-weight: 600; padding: 9px 12px; }}
QPushButton[role="laser"]:hover {{ background: #3a2529; }}
QPushButton[role="laser"][lit="true"] {{ background: {LASER}; color: white; }}
QPushButton[role="laser"]:focus {{ border-color: {TEXT}; }}
QPushButton[role="step"] {{ text-align: left; background: transparent; border: none; border-radius: 0; border-left: 3px solid transparent;
    padding: 9px 12px 9px 15px; color: {MUTED}; }}
QPushButton[role="step"]:hover {{ background: {RAISED}; color: {TEXT}; }}
QPushButton[role="step"]:checked {{ background: {RAISED}; color: {TEXT}; border-left: 3px solid {ACCENT}; font-weight: 600; }}
QPushButton[role="step"]:focus {{ color: {TEXT}; border-left: 3px solid {TEXT}; }}
QPushButton[role="step"]:checked:focus {{ border-left: 3px solid {ACCENT}; }}
QPushButton[role="link"] {{ background: transparent; border: none; color: {ACCENT}; padding: 2px 0; text-align: left; }}
QPushButton[role="link"]:hover, QPushButton[role="link"]:focus {{ text-decoration: underline; }}
QPushButton[role="choice"] {{ padding: 8px 10px; }}
QPushButton[role="choice"]:checked {{ background: #26403c; color: {TEXT}; border-color: {ACCENT}; }}
QPushButton[side="left"]:checked {{ background: #23303f; color: {LEFT_EAR}; border: 2px solid {LEFT_EAR}; font-weight: 600; }}
QPushButton[side="right"]:checked {{ background: #3a292c; color: {RIGHT_EAR}; border: 2px solid {RIGHT_EAR}; font-weight: 600; }}
QToolButton {{ background: transparent; border: 1px solid transparent; border-radius: 5px; padding: 5px 7px; }}
QToolButton:hover {{ background: {RAISED}; }}
QToolButton:checked {{ background: {RAISED}; border-color: {SEAM}; }}
QToolButton:focus {{ border-color: {ACCENT}; }}
QRadioButton, QCheckBox[role="deliberate"] {{ spacing: 9px; }}
QRadioButton::indicator, QCheckBox[role="deliberate"]::indicator {{ width: 14px; height: 14px; border: 1px solid {MUTED}; background: {GROUND}; }}
QRadioButton::indicator {{ border-radius: 8px; }}
QCheckBox[role="deliberate"]::indicator {{ border-radius: 3px; }}
QRadioButton::indicator:disabled, QCheckBox[role="deliberate"]::indicator:disabled {{ border-color: {SEAM}; background: {PANEL}; }}
QRadioButton::indicator:focus, QCheckBox[role="deliberate"]::indicator:focus {{ border-color: {TEXT}; }}
QRadioButton::indicator:checked {{ background: qradialgradient(cx: 0.5, cy: 0.5, radius: 0.5, fx: 0.5, fy: 0.5,
    stop: 0 {ACCENT}, stop: 0.55 {ACCENT}, stop: 0.65 {GROUND}, stop: 1 {GROUND}); border-color: {ACCENT}; }}
QCheckBox[role="deliberate"]::indicator:checked {{ border-color: {ACCENT}; image: url(CHECKMARK); }}
QProgressBar {{ background: {RAISED}; border: none; border-radius: 3px; max-height: 6px; min-height: 6px; }}
QProgressBar::chunk {{ background: {ACCENT}; border-radius: 3px; }}
QListWidget {{ background: transparent; border: none; outline: none; }}
QListWidget::item {{ border-bottom: 1px solid {SEAM}; padding: 0; }}
QListWidget::item:selected {{ background: {RAISED}; color: {TEXT}; }}
QListWidget::item:hover {{ background: {RAISED}; }}
QListWidget::item:focus {{ background: {RAISED}; }}
QComboBox {{ background: {RAISED}; border: 1px solid {SEAM}; border-radius: 5px; padding: 3px 10px; }}
QComboBox:hover {{ background: #373d44; }}
QComboBox:focus {{ border-color: {ACCENT}; }}
QComboBox:disabled {{ color: {FAINT}; background: {PANEL}; }}
QComboBox::drop-down {{ border: none; width: 26px; }}
QComboBox::down-arrow {{ image: url(CHEVRON); width: 12px; height: 12px; }}
QComboBox QAbstractItemView {{ background: {RAISED}; border: 1px solid {SEAM}; selection-background-color: {ACCENT_DIM}; outline: none; }}
QScrollBar:vertical {{ background: transparent; width: 10px; margin: 0; }}
QScrollBar::handle:vertical {{ background: {SEAM}; border-radius: 3px; min-height: 24px; margin: 0 2px; }}
QScrollBar::add-line, QScrollBar::sub-line {{ height: 0; width: 0; }}
QScrollBar:horizontal {{ background: transparent; height: 10px; margin: 0; }}
QScrollBar::handle:horizontal {{ background: {SEAM}; border-radius: 3px; min-width: 24px; margin: 2px 0; }}
QScrollArea {{ border: none; background: transparent; }}
QPlainTextEdit[role="details"] {{ background: {GROUND}; border: 1px solid {SEAM}; color: {MUTED}; }}
QFrame[role="banner"] {{ background: #352f22; border: none; border-bottom: 1px solid {WARNING}; }}
QFrame[role="banner"][mood="note"] {{ background: #20332f; border-bottom: 1px solid {ACCENT}; }}
QFrame[role="status"] {{ background: {PANEL}; border-top: 1px solid {SEAM}; }}
"""


def apply_theme(application: QApplication) -> None:
    """Style, palette, font and style sheet of the whole program."""
    application.setStyle("Fusion")
    palette = QPalette()
    for role, colour in (
        (QPalette.ColorRole.Window, PANEL),
        (QPalette.ColorRole.WindowText, TEXT),
        (QPalette.ColorRole.Base, GROUND),
        (QPalette.ColorRole.AlternateBase, PANEL),
        (QPalette.ColorRole.Text, TEXT),
        (QPalette.ColorRole.Button, RAISED),
        (QPalette.ColorRole.ButtonText, TEXT),
        (QPalette.ColorRole.Highlight, ACCENT_DIM),
        (QPalette.ColorRole.HighlightedText, TEXT),
        (QPalette.ColorRole.PlaceholderText, FAINT),
        (QPalette.ColorRole.ToolTipBase, RAISED),
        (QPalette.ColorRole.ToolTipText, TEXT),
        (QPalette.ColorRole.Link, ACCENT),
        (QPalette.ColorRole.Light, "#3a4047"),
        (QPalette.ColorRole.Midlight, RAISED),
        (QPalette.ColorRole.Mid, SEAM),
        (QPalette.ColorRole.Dark, GROUND),
        (QPalette.ColorRole.Shadow, "#000000"),
        (QPalette.ColorRole.Accent, ACCENT),
    ):
        palette.setColor(role, QColor(colour))
    for role in (QPalette.ColorRole.Text, QPalette.ColorRole.ButtonText, QPalette.ColorRole.WindowText):
        palette.setColor(QPalette.ColorGroup.Disabled, role, QColor(FAINT))
    application.setPalette(palette)
    font = QFont("Inter") if "Inter" in QFontDatabase.families() else QFont(application.font())
    font.setPixelSize(13)
    font.setHintingPreference(QFont.HintingPreference.PreferNoHinting)
    font.setFeature(QFont.Tag("tnum"), 1)
    application.setFont(font)
    chevron = str(resources.files("resources") / "icons" / "chevron.svg").replace("\\", "/")
    check = chevron.replace("chevron.svg", "ticked.svg")
    application.setStyleSheet(_SHEET.replace("CHEVRON", f'"{chevron}"').replace("CHECKMARK", f'"{check}"'))


@cache
def icon(name: str, colour: str = TEXT, checked_colour: str | None = None) -> QIcon:
    """A drawing of ``resources/icons`` in `colour` (and in `checked_colour` where a button is switched on)."""
    result = QIcon()
    for state, tint in ((QIcon.State.Off, colour), (QIcon.State.On, checked_colour or colour)):
        for size in (16, 20, 24, 32, 48, 64, 96):
            result.addPixmap(drawing(name, tint, QSize(size, size), 1.0), QIcon.Mode.Normal, state)
            result.addPixmap(drawing(name, FAINT, QSize(size, size), 1.0), QIcon.Mode.Disabled, state)
    return result


def drawing(name: str, colour: str, size: QSize, ratio: float | None = None) -> QPixmap:
    """The same as a picture of `size`, for the screen's own pixel ratio when none is given."""
    svg = (resources.files("resources") / "icons" / f"{name}.svg").read_text(encoding="utf-8").replace("currentColor", colour)
    if ratio is None:
        screen = QGuiApplication.primaryScreen()
        ratio = screen.devicePixelRatio() if screen is not None else 1.0
    picture = QPixmap(size * ratio)
    picture.fill(Qt.GlobalColor.transparent)
    painter = QPainter(picture)
    QSvgRenderer(QByteArray(svg.encode())).render(painter, QRectF(0, 0, picture.width(), picture.height()))
    painter.end()
    picture.setDevicePixelRatio(ratio)
    return picture
