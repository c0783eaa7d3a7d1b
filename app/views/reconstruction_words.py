"""What is said of a reconstruction: whose it is, what came of it, and what a wish will give."""

from __future__ import annotations

from PySide6.QtCore import QCoreApplication

from app.controllers.reconstruction import ReconstructionController
from app.draft import DraftValues
from app.views import format as fmt
from app.views.order_words import side_word
from scanner_core.reconstruction.forecast import Carried
from scanner_core.reconstruction.remarks import RemarkKind

_MEASURED_SHARE = 0.98
_REJECTED_SHARE = 0.05
_TOLD_HERE = ("CAPPED", "OPEN", "REJECTED")


def order_words(values: DraftValues) -> str:
    """Number and side of an order, as short as they can be told from others."""
    translate = QCoreApplication.translate
    number = values.order or translate("reconstruction", "No order number")
    if not values.side:
        return number
    return translate("reconstruction", "{order} · {side}").format(order=number, side=side_word(values.side))


def reconstruction_words(job: ReconstructionController, *, with_count: bool = True) -> str:
    """Of what runs, and how many wait, for every page; empty when nothing runs."""
    translate = QCoreApplication.translate
    if not job.running or job.wanted is None:
        return ""
    order, left = order_words(job.wanted.values), None if job.progress is None else job.progress.seconds_left
    if job.ending_early:
        return translate("reconstruction", "{order}: being finished").format(order=order)
    if left is None:
        return translate("reconstruction", "{order}: reconstructing").format(order=order)
    if job.queue.waiting and with_count:
        words = translate("reconstruction", "{order}: reconstructing, {left} left, {count} waiting")
        return words.format(order=order, left=fmt.left_time(left), count=len(job.queue.waiting))
    return translate("reconstruction", "{order}: reconstructing, {left} left").format(order=order, left=fmt.left_time(left))


def verdict(report: dict[str, object]) -> tuple[str, str]:
    """One sentence on a finished surface, and the role of its label: ``good`` or ``bad``."""
    translate = QCoreApplication.translate
    supported = _number(report, "supported_area_fraction")
    if not report.get("closed"):
        return translate("reconstruction", "Left open where nothing was scanned, as it was asked for."), "bad"
    if report.get("stopped_early"):
        return translate("reconstruction", "Kept early: closed and whole, but coarser than the points allow."), "bad"
    if supported < _MEASURED_SHARE:
        words = translate("reconstruction", "Closed; {share} % of it was not scanned and is only bridged.")
        return words.format(share=fmt.percent(1 - supported)), "bad"
    points = _number(report, "points")
    if points and _number(report, "outliers_rejected") > _REJECTED_SHARE * points:
        words = translate("reconstruction", "Closed and whole; {share} % of the points did not belong to it and were left out.")
        return words.format(share=fmt.percent(_number(report, "outliers_rejected") / points)), "bad"
    return translate("reconstruction", "Closed and whole: points support all of it."), "good"


def other_remarks(report: dict[str, object]) -> str:
    """What else the reconstruction remarked, a line each; what the verdict tells is left out."""
    remarks, lines = report.get("remarks"), []
    for remark in remarks if isinstance(remarks, list) else ():
        kind, fields = remark.get("kind"), remark.get("fields")
        if kind in RemarkKind.__members__ and kind not in _TOLD_HERE and isinstance(fields, dict):
            lines.append(QCoreApplication.translate("remarks", RemarkKind[kind].value).format(**fmt.own_mark(fields)))
    return "\n".join(lines)


def wish_words(values: DraftValues, carried: Carried | None) -> str:
    """What the wishes of the form will give."""
    translate = QCoreApplication.translate
    if values.tolerance_um:
        words = translate("reconstruction", "As many triangles as a tolerance of {n} µm needs (set under Expert).")
        return words.format(n=values.tolerance_um)
    if carried is None:
        return translate("reconstruction", "The points carry the number of triangles.")
    triangles = values.triangles or round(carried.triangles * 2.0**values.detail)
    error_um, count = carried.error_um(triangles), fmt.count(_rounded(triangles))
    if error_um is None:
        return translate("reconstruction", "About {triangles} triangles.").format(triangles=count)
    words = translate("reconstruction", "About {triangles} triangles, expected error about {n} µm.")
    if triangles > 1.2 * carried.triangles:
        words = translate("reconstruction", "About {triangles} triangles, expected error about {n} µm: rounder, but no more certain.")
    return words.format(triangles=count, n=fmt.micrometres(error_um))


def _rounded(count: int) -> int:
    """Two digits of a number that is an estimate."""
    size = int(10.0 ** max(len(str(count)) - 2, 0))
    return round(count / size) * size


def _number(report: dict[str, object], key: str) -> float:
    value = report.get(key)
    return float(value) if isinstance(value, int | float) else 0.0
