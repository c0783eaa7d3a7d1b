"""The sentences of what the marks on the table's rim tell."""

from __future__ import annotations

from collections.abc import Iterator
from math import hypot

from scanner_core.acquisition.finding import Finding
from scanner_core.acquisition.mark_causes import BALLS, Cause
from scanner_core.acquisition.mark_watch import MarkStep, MarkWatch


def mark_findings(watch: MarkWatch) -> Iterator[tuple[Finding, tuple[object, ...]]]:
    """All findings of the visits so far, each with the key under which a later one replaces it."""
    for step in watch.steps:
        yield step_finding(step), ("marks", step.view, step.table_deg)
    for number, (view, table_deg, seen_before) in watch.missing.items():
        fields: dict[str, object] = {"number": number + 1, "table_deg": f"{table_deg:.1f}"}
        yield Finding("H-MARK-05", "warning" if seen_before else "info", fields, view, table_deg), ("marks", "missing", number)
    scale = watch.scale_error()
    if scale is not None and watch.scale_is_off():
        details: dict[str, object] = {"uncertainty_ppm": round(1e6 * scale[1], 1)}
        fields = {"percent": f"{100 * scale[0]:+.3f}"}
        yield Finding("H-MARK-06", "warning", fields, 0, 0.0, -1, 100 * scale[0], "%", details), ("marks", "scale")


def step_finding(step: MarkStep) -> Finding:
    """The sentence of one step."""
    place = f"{step.table_deg:.1f}"
    details: dict[str, object] = {"cause": step.likeliest.name.lower(), "decided": step.cause is not None, "shift_um": round(step.shift_um, 1)}
    details["chi_square"] = round(step.worth, 1)

    def told(code: str, fields: dict[str, object], value: float, unit: str) -> Finding:
        return Finding(code, "warning", {"table_deg": place, **fields}, step.view, step.table_deg, -1, value, unit, details)

    match step.cause:
        case Cause.TABLE:
            return told("H-MARK-01", {"turn_deg": f"{step.amounts[0]:.3f}"}, step.amounts[0], "deg")
        case Cause.LEFT | Cause.RIGHT:
            shift_px = hypot(*step.amounts)
            return told("H-MARK-02", {"shift_um": f"{step.shift_um:.0f}", "shift_px": f"{shift_px:.2f}"}, shift_px, "px")
        case Cause.SCALE:
            percent = 100 * step.amounts[0]
            return told("H-MARK-03", {"percent": f"{percent:+.3f}"}, percent, "%")
        case None | Cause.OTHER:
            return told("H-MARK-04", {"shift_um": f"{step.shift_um:.0f}"}, step.shift_um, "um")
    return told("H-MARK-07", {"number": BALLS.index(step.cause) + 1, "shift_um": f"{step.shift_um:.0f}"}, step.shift_um, "um")
