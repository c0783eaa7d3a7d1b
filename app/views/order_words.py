"""An order in words: its state, with the sign that stands before it, its side, its type, its age."""

from __future__ import annotations

from PySide6.QtCore import QCoreApplication

from app.draft import KINDS, SIDES
from app.translation import QT_TRANSLATE_NOOP
from app.views import format as fmt
from scanner_core.case.case_glance import CaseGlance, OrderState, Trouble

STATES: dict[OrderState | Trouble, tuple[str, str, str]] = {
    OrderState.NEW: (QT_TRANSLATE_NOOP("worklist", "New"), "order", "muted"),
    OrderState.INTERRUPTED: (QT_TRANSLATE_NOOP("worklist", "Interrupted"), "warning", "warning"),
    OrderState.SCANNED: (QT_TRANSLATE_NOOP("worklist", "Scanned"), "points", "text"),
    OrderState.RECONSTRUCTED: (QT_TRANSLATE_NOOP("worklist", "Reconstructed"), "surface", "text"),
    OrderState.DELIVERED: (QT_TRANSLATE_NOOP("worklist", "Delivered"), "check", "good"),
    Trouble.OPEN: (QT_TRANSLATE_NOOP("worklist", "Open in another program"), "warning", "warning"),
    Trouble.NEWER: (QT_TRANSLATE_NOOP("worklist", "Made by a newer version"), "warning", "warning"),
    Trouble.DAMAGED: (QT_TRANSLATE_NOOP("worklist", "Damaged"), "warning", "warning"),
    Trouble.UNREADABLE: (QT_TRANSLATE_NOOP("worklist", "Cannot be read"), "warning", "warning"),
}
"""Word, drawing and colour of the palette."""
RUNNING = (QT_TRANSLATE_NOOP("worklist", "Being scanned"), "scan", "accent")

_PAGES = {
    OrderState.NEW: "scan",
    OrderState.INTERRUPTED: "home",  # where it is offered to go on with it
    OrderState.SCANNED: "reconstruct",
    OrderState.RECONSTRUCTED: "deliver",
    OrderState.DELIVERED: "deliver",
}


_NEXT = {
    OrderState.NEW: QT_TRANSLATE_NOOP("worklist", "Scan it"),
    OrderState.INTERRUPTED: QT_TRANSLATE_NOOP("worklist", "Go on with it"),
    OrderState.SCANNED: QT_TRANSLATE_NOOP("worklist", "Reconstruct it"),
    OrderState.RECONSTRUCTED: QT_TRANSLATE_NOOP("worklist", "Deliver it"),
}
_OPEN = QT_TRANSLATE_NOOP("worklist", "Open it")


def next_step(told: CaseGlance | None) -> str:
    """What opening an order leads to."""
    state = None if told is None or told.trouble is not None else told.state
    return QCoreApplication.translate("worklist", _OPEN if state is None else _NEXT.get(state, _OPEN))


def state_of(told: CaseGlance, *, running: bool = False) -> tuple[str, str, str]:
    """Word, drawing and colour."""
    key = told.trouble or told.state or OrderState.NEW
    word, sign, colour = RUNNING if running else STATES[key]
    return QCoreApplication.translate("worklist", word), sign, colour


def side_word(side: str) -> str:
    """In the window's language; empty for none, and as it is for one that is not known."""
    return QCoreApplication.translate("draft", SIDES[side]) if side in SIDES else side


def kind_word(kind: str) -> str:
    return QCoreApplication.translate("draft", KINDS[kind]) if kind in KINDS else kind


def page_of(told: CaseGlance) -> str:
    """Id of the page where the work on an order goes on."""
    return _PAGES[told.state or OrderState.NEW]


def order_sentence(told: CaseGlance, *, running: bool = False, aged: bool = True) -> str:
    """Everything that a line of the list shows, for those who hear it; without its age what is searched."""
    parts = (told.order.number, side_word(told.order.side), kind_word(told.order.type), told.order.patient_code)
    return ", ".join(part for part in (*parts, state_of(told, running=running)[0], fmt.ago(told.changed) if aged else "") if part)
