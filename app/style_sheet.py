"""The style sheet of a palette.

Input widgets are left to the palette: a border or padding in the style sheet clips the value out of a spin box.
"""

from __future__ import annotations

from app.palettes import Palette


def style_sheet(p: Palette, *, chevron: str, ticked: str) -> str:
    """Everything that Fusion and the palette do not say; `chevron` and `ticked` are paths of drawings, with "/"."""
    return f"""
QMainWindow, QDialog {{ background: {p.ground}; }}
QToolTip {{ background: {p.raised}; color: {p.text}; border: 1px solid {p.seam}; padding: 4px; }}
QMenuBar {{ background: {p.panel}; border-bottom: 1px solid {p.seam}; }}
QMenuBar::item {{ padding: 4px 10px; background: transparent; }}
QMenuBar::item:selected {{ background: {p.raised}; }}
QWidget[role="panel"], QFrame[role="panel"] {{ background: {p.panel}; }}
QWidget[role="ground"] {{ background: {p.ground}; }}
QFrame[role="seam"] {{ background: {p.seam}; border: none; }}
QLabel[role="title"] {{ font-size: 17px; font-weight: 600; }}
QLabel[role="headline"] {{ font-size: 24px; font-weight: 600; }}
QLabel[role="section"] {{ font-size: 12px; font-weight: 600; color: {p.muted}; }}
QLabel[role="large"] {{ font-size: 32px; font-weight: 600; }}
QLabel[role="large-good"] {{ font-size: 32px; font-weight: 600; color: {p.good}; }}
QLabel[role="muted"] {{ color: {p.muted}; }}
QLabel[role="faint"] {{ color: {p.faint}; font-size: 12px; }}
QLabel[role="unit"] {{ color: {p.muted}; font-size: 12px; }}
QLabel[role="number"] {{ font-size: 23px; font-weight: 600; }}
QLabel[role="hero"] {{ font-size: 52px; font-weight: 600; }}
QLabel[role="good"] {{ color: {p.good}; }}
QLabel[role="bad"] {{ color: {p.warning}; }}
QLabel[role="notice"] {{ background: {p.warning_ground}; border-left: 3px solid {p.warning}; padding: 9px 12px; }}
QPushButton {{ background: {p.raised}; border: 1px solid {p.seam}; border-radius: 5px; padding: 7px 14px; }}
QPushButton:hover {{ background: {p.hovered}; }}
QPushButton:pressed {{ background: {p.pressed}; }}
QPushButton:focus {{ border-color: {p.accent}; }}
QPushButton:disabled {{ color: {p.faint}; background: {p.panel}; border-color: {p.seam}; }}
QPushButton:checked {{ border-color: {p.accent}; color: {p.accent}; }}
QPushButton[role="primary"] {{ background: {p.accent}; color: {p.on_accent}; border-color: {p.accent}; font-weight: 600; padding: 9px 16px; }}
QPushButton[role="primary"]:hover {{ background: {p.accent_hovered}; }}
QPushButton[role="primary"]:pressed {{ background: {p.accent_pressed}; }}
QPushButton[role="primary"]:focus {{ border-color: {p.text}; }}
QPushButton[role="primary"]:disabled {{ background: {p.accent_dim}; color: {p.on_accent_dim}; border-color: {p.accent_dim}; }}
QPushButton[role="laser"] {{ background: transparent; color: {p.laser_text}; border: 1px solid {p.laser}; font-weight: 600; padding: 9px 12px; }}
QPushButton[role="laser"]:hover {{ background: {p.laser_ground}; }}
QPushButton[role="laser"][lit="true"] {{ background: {p.laser}; color: {p.on_laser}; }}
QPushButton[role="laser"]:focus {{ border-color: {p.text}; }}
QPushButton[role="step"] {{ text-align: left; background: transparent; border: none; border-radius: 0; border-left: 3px solid transparent;
    padding: 9px 12px 9px 15px; color: {p.muted}; }}
QPushButton[role="step"]:hover {{ background: {p.raised}; color: {p.text}; }}
QPushButton[role="step"]:checked {{ background: {p.raised}; color: {p.text}; border-left: 3px solid {p.accent}; font-weight: 600; }}
QPushButton[role="step"]:focus {{ color: {p.text}; border-left: 3px solid {p.text}; }}
QPushButton[role="step"]:checked:focus {{ border-left: 3px solid {p.text}; }}
QPushButton[role="link"] {{ background: transparent; border: none; color: {p.accent}; padding: 2px 0; text-align: left; }}
QPushButton[role="quiet-link"] {{ background: transparent; border: none; color: {p.muted}; padding: 2px 0; text-align: left; }}
QPushButton[role="link"]:hover, QPushButton[role="link"]:focus {{ text-decoration: underline; }}
QPushButton[role="quiet-link"]:hover, QPushButton[role="quiet-link"]:focus {{ text-decoration: underline; }}
QPushButton[role="choice"] {{ padding: 8px 10px; }}
QPushButton[role="choice"]:checked {{ background: {p.accent_ground}; color: {p.text}; border-color: {p.accent}; }}
QPushButton[side="left"]:checked {{ background: {p.left_ground}; color: {p.left_ear}; border: 2px solid {p.left_ear}; font-weight: 600; }}
QPushButton[side="right"]:checked {{ background: {p.right_ground}; color: {p.right_ear}; border: 2px solid {p.right_ear}; font-weight: 600; }}
QPushButton:checked:focus, QPushButton[role="choice"]:checked:focus {{ border-color: {p.text}; }}
QPushButton[side="left"]:checked:focus, QPushButton[side="right"]:checked:focus {{ border-color: {p.text}; }}
QToolButton {{ background: transparent; border: 1px solid transparent; border-radius: 5px; padding: 5px 7px; }}
QToolButton:hover {{ background: {p.raised}; }}
QToolButton:checked {{ background: {p.raised}; border-color: {p.seam}; }}
QToolButton:focus {{ border-color: {p.accent}; }}
QRadioButton, QCheckBox {{ spacing: 9px; }}
QRadioButton::indicator, QCheckBox::indicator {{ width: 14px; height: 14px; border: 1px solid {p.edge}; background: {p.ground}; }}
QRadioButton::indicator {{ border-radius: 8px; }}
QCheckBox::indicator {{ border-radius: 3px; }}
QRadioButton::indicator:disabled, QCheckBox::indicator:disabled {{ border-color: {p.seam}; background: {p.panel}; }}
QRadioButton::indicator:focus, QCheckBox::indicator:focus {{ border-color: {p.text}; }}
QRadioButton::indicator:checked {{ background: qradialgradient(cx: 0.5, cy: 0.5, radius: 0.5, fx: 0.5, fy: 0.5,
    stop: 0 {p.accent}, stop: 0.55 {p.accent}, stop: 0.65 {p.ground}, stop: 1 {p.ground}); border-color: {p.accent}; }}
QCheckBox::indicator:checked {{ border-color: {p.accent}; image: url("{ticked}"); }}
QListWidget::indicator {{ width: 14px; height: 14px; border: 1px solid {p.edge}; border-radius: 3px; background: {p.ground}; }}
QListWidget::indicator:checked {{ border-color: {p.accent}; image: url("{ticked}"); }}
QLineEdit {{ border: 1px solid {p.field_edge}; border-radius: 4px; padding: 1px 4px; background: {p.field}; }}
QLineEdit:focus {{ border-color: {p.accent}; }}
QLineEdit:disabled {{ color: {p.faint}; background: {p.panel}; }}
QLineEdit#qt_spinbox_lineedit, QComboBox QLineEdit {{ border: none; padding: 0; background: transparent; }}
QProgressBar {{ background: {p.raised}; border: none; border-radius: 3px; max-height: 6px; min-height: 6px; }}
QProgressBar::chunk {{ background: {p.accent}; border-radius: 3px; }}
QListWidget {{ background: transparent; border: none; outline: none; }}
QListWidget::item {{ border-bottom: 1px solid {p.seam}; padding: 0; }}
QListWidget::item:selected {{ background: {p.raised}; color: {p.text}; }}
QListWidget::item:hover {{ background: {p.raised}; }}
QListWidget::item:focus {{ background: {p.raised}; }}
QComboBox {{ background: {p.raised}; border: 1px solid {p.seam}; border-radius: 5px; padding: 3px 10px; }}
QComboBox:hover {{ background: {p.hovered}; }}
QComboBox:focus {{ border-color: {p.accent}; }}
QComboBox:disabled {{ color: {p.faint}; background: {p.panel}; }}
QComboBox::drop-down {{ border: none; width: 26px; }}
QComboBox::down-arrow {{ image: url("{chevron}"); width: 12px; height: 12px; }}
QComboBox QAbstractItemView {{ background: {p.raised}; border: 1px solid {p.seam}; selection-background-color: {p.accent_dim}; outline: none; }}
QScrollBar:vertical {{ background: transparent; width: 10px; margin: 0; }}
QScrollBar::handle:vertical {{ background: {p.seam}; border-radius: 3px; min-height: 24px; margin: 0 2px; }}
QScrollBar::add-line, QScrollBar::sub-line {{ height: 0; width: 0; }}
QScrollBar:horizontal {{ background: transparent; height: 10px; margin: 0; }}
QScrollBar::handle:horizontal {{ background: {p.seam}; border-radius: 3px; min-width: 24px; margin: 2px 0; }}
QScrollArea {{ border: none; background: transparent; }}
QPlainTextEdit[role="details"] {{ background: {p.ground}; border: 1px solid {p.seam}; color: {p.muted}; }}
QFrame[role="banner"] {{ background: {p.warning_ground}; border: none; border-bottom: 1px solid {p.warning}; }}
QFrame[role="banner"][mood="note"] {{ background: {p.accent_ground}; border-bottom: 1px solid {p.accent}; }}
QFrame[role="help"] {{ background: {p.raised}; border-left: 1px solid {p.seam}; }}
QFrame[role="card"] {{ background: {p.raised}; border: 1px solid {p.accent}; border-radius: 8px; }}
QTreeWidget {{ background: {p.panel}; border: 1px solid {p.seam}; outline: none; }}
QTreeWidget::item {{ padding: 4px 2px; }}
QHeaderView::section {{ background: {p.panel}; color: {p.muted}; border: none; border-bottom: 1px solid {p.seam}; padding: 5px 6px; }}
QFrame[role="status"] {{ background: {p.panel}; border-top: 1px solid {p.seam}; }}
QLabel[role="arrow"] {{ color: {p.faint}; font-size: 26px; }}
QLabel[role="strong"] {{ font-weight: 600; }}
QLabel[role="badge"] {{ border: 1px solid {p.seam}; border-radius: 4px; padding: 1px 7px; font-weight: 600; }}
QLabel[role="badge"][side="left"] {{ color: {p.left_ear}; border-color: {p.left_ear}; }}
QLabel[role="badge"][side="right"] {{ color: {p.right_ear}; border-color: {p.right_ear}; }}
QFrame[role="target"] {{ border: 2px dashed {p.edge}; border-radius: 8px; }}
QFrame[role="target"][lit="true"] {{ border-color: {p.accent}; }}
"""
