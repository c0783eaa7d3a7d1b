"""A scan in a line: where it is, and what an error-driven one has come to."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QCoreApplication

from app.faults import sentence_of
from app.views import format as fmt
from scanner_core.acquisition.passes import PassesEnd, SteeringResult, SteeringStatus
from scanner_core.acquisition.status import FinishReason, ScanState, ScanStatus
from scanner_core.coverage.reason import Reason

if TYPE_CHECKING:
    from scanner_core.acquisition.scan_result import ScanResult


def step_words(status: ScanStatus) -> str:
    """What the scan does, or how it has ended."""
    translate = QCoreApplication.translate
    if status.finish_reason is FinishReason.COMPLETED:
        return translate("ScanPage", "The scan is complete.")
    if status.finish_reason is FinishReason.CANCELLED:
        return translate("ScanPage", "Stopped; what was measured is kept")
    if status.finish_reason is FinishReason.FAILED:
        return translate("ScanPage", "Ended by a fault; what was measured is kept")
    if status.pausing:
        return translate("ScanPage", "Pausing: the row that is being swept is finished first.")
    if status.closing and status.state is ScanState.SCANNING:
        return translate("ScanPage", "Closing the turn: the first view is measured again and compared.")
    if status.repeats is not None and status.state is ScanState.SCANNING:
        return translate("ScanPage", "View {view} once more").format(view=status.repeats + 1)
    steering = status.steering
    if steering is not None and status.state is ScanState.SCANNING:
        return _pass_words(status, steering)
    return {
        ScanState.IDLE: translate("ScanPage", "Starting…"),
        ScanState.PREPARING: translate("ScanPage", "Finding the object, view {view} of {views}"),
        ScanState.SCANNING: translate("ScanPage", "View {view} of {views}"),
        ScanState.PAUSED: translate(
            "ScanPage",
            "Paused in view {view} of {views}. The laser is dark, beam and table rest, all points so far are kept; it goes on with the next row.",
        ),
        ScanState.FINISHING: translate("ScanPage", "Bringing the views together…"),
        ScanState.FAULT: translate("ScanPage", "A fault: the laser is off"),
    }[status.state].format(view=_view(status), views=status.views)


def _pass_words(status: ScanStatus, steering: SteeringStatus) -> str:
    translate = QCoreApplication.translate
    if steering.computing:
        line = translate("ScanPage", "Computing where more points are needed…")
    elif steering.number == 1:
        line = translate("ScanPage", "Coarse pass: view {view} of {views}")
    else:
        line = translate("ScanPage", "Pass {number}, where it is needed: view {view} of {views}")
    line = line.format(number=steering.number, view=_view(status), views=status.views)
    if steering.within is None:
        return line
    within = translate("ScanPage", "{share} % within {wanted} µm so far")
    return f"{line}\n" + within.format(share=fmt.percent(steering.within), wanted=fmt.micrometres(steering.wanted_um))


def _view(status: ScanStatus) -> int:
    return min(status.view + 1, status.views)


def coverage_words(result: SteeringResult) -> str:
    """How much of the surface is as wanted, what cannot be, and why the scan did not go on."""
    translate = QCoreApplication.translate
    report = result.coverage
    if report is None:
        return "" if result.refused is None else sentence_of(result.refused)[0]
    wanted = fmt.micrometres(report.wanted_um)
    parts = [translate("ScanPage", "{share} % within {wanted} µm").format(share=fmt.percent(report.reachable_within_fraction), wanted=wanted)]
    hidden = sum(not place.reason.reachable for place in report.places)
    if hidden == 1:
        parts.append(translate("ScanPage", "1 place cannot be seen from this mount"))
    elif hidden:
        parts.append(translate("ScanPage", "{count} places cannot be seen from this mount").format(count=hidden))
    if result.end in (PassesEnd.POINTS_SPENT, PassesEnd.UNIFORM):
        parts.append(translate("ScanPage", "all points are spent"))
    elif result.end is PassesEnd.VIEWS_SPENT:
        parts.append(translate("ScanPage", "no further view fits into this scan"))
    elif result.end is PassesEnd.NO_GAIN:
        parts.append(translate("ScanPage", "more points would not help"))
    return "; ".join(parts)


def status_words(status: ScanStatus) -> str:
    """One line about a scan for the header of the 3D view."""
    points = fmt.count(status.counts.measured)
    if status.repeats is not None:  # which has no place of its own in the plan that is shown
        return QCoreApplication.translate("ScanPage", "{points} points  ·  view {view} once more").format(points=points, view=status.repeats + 1)
    return QCoreApplication.translate("ScanPage", "{points} points  ·  view {view} of {views}").format(
        points=points, view=min(status.view + 1, max(status.views, 1)), views=status.views
    )


def summary_lines(result: ScanResult) -> list[str]:
    """What a person should know of a scan that has ended, beside its points, its time and its closure."""
    translate = QCoreApplication.translate
    lines = []
    if result.repeated_views:
        lines.append(translate("ScanPage", "Views measured once more: {views}").format(views=_numbers(result.repeated_views)))
    if result.weak_views:
        lines.append(translate("ScanPage", "Still far fewer points than their neighbours: {views}").format(views=_numbers(result.weak_views)))
    if result.finish_reason is FinishReason.COMPLETED and result.closure_um is None and result.laser == "spot" and len(result.plan) > 1:
        lines.append(translate("ScanPage", "Whether the turn closes is not known: too few points of the first view were seen again."))
    return lines


def places_missing(result: ScanResult) -> bool:
    """Whether something of the scan is known to be missing that this rig could measure: then that comes before the surface."""
    report = None if result.steering is None else result.steering.coverage
    few = report is not None and any(place.reason is Reason.FEW_POINTS for place in report.places)
    return few or bool(result.weak_views)


def _numbers(views: list[int]) -> str:
    return ", ".join(str(view + 1) for view in views)
