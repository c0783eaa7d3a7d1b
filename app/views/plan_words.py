"""A view of a scan's plan, in words."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QCoreApplication

from app.translation import QT_TRANSLATE_NOOP
from app.views import format as fmt
from app.views.reasons import reason_text
from scanner_core.acquisition.view_state import ViewProgress, ViewState

_STATES: Final = {
    ViewState.COMING: QT_TRANSLATE_NOOP("PlanBar", "to come"),
    ViewState.DOING: QT_TRANSLATE_NOOP("PlanBar", "being measured"),
    ViewState.DONE: QT_TRANSLATE_NOOP("PlanBar", "done"),
    ViewState.TO_REDO: QT_TRANSLATE_NOOP("PlanBar", "will be measured once more"),
    ViewState.WEAK: QT_TRANSLATE_NOOP("PlanBar", "far fewer points than its neighbours"),
}


def view_words(view: ViewProgress) -> str:
    """Which view it is, and its state, in one line."""
    translate = QCoreApplication.translate
    text = translate("PlanBar", "View {number} at {angle:.0f}°: {state}")
    return text.format(number=view.number + 1, angle=view.table_deg % 360.0, state=translate("PlanBar", _STATES[view.state]))


def view_counts(view: ViewProgress) -> str:
    """Its points and rejects, in one line."""
    translate = QCoreApplication.translate
    rejected = sum(view.rejected.values())
    if not view.measured and not rejected:
        return ""
    text = translate("PlanBar", "{points} points, {rejected} rejected")
    if view.wanted:
        text = translate("PlanBar", "{points} of {wanted} points, {rejected} rejected")
    told = text.format(points=fmt.count(view.measured), wanted=fmt.count(view.wanted), rejected=fmt.count(rejected))
    return translate("PlanBar", "{told}; measured twice").format(told=told) if view.repeated else told


def view_tooltip(view: ViewProgress) -> str:
    """All that is known of it, line by line."""
    ranked = sorted(view.rejected.items(), key=lambda entry: -entry[1])[:3]
    lines = [view_words(view), view_counts(view), *(f"{reason_text(name)}: {fmt.count(many)}" for name, many in ranked)]
    return "\n".join(line for line in lines if line)
