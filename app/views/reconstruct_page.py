"""Reconstruct: what is wanted, the balloon with its phases and distances while it is at it, and what came of it."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QGridLayout, QVBoxLayout, QWidget

from app.services import Services
from app.views import format as fmt
from app.views.distance_chart import DistanceChart
from app.views.page import Page
from app.views.parts import BigNumber, button, give_role, label, make_primary, scrolled, seam
from app.views.processing_rows import ProcessingRows
from app.views.reconstruction_phases import ReconstructionPhases
from app.views.reconstruction_waiting import ReconstructionWaiting
from app.views.reconstruction_wishes import ReconstructionWishes
from app.views.reconstruction_words import other_remarks, verdict
from scanner_core.geometry.distance_histogram import CLASSES
from scanner_core.reconstruction.forecast import Carried, carried_after, carried_by


class ReconstructPage(Page):
    """Stands beside the surface."""

    def __init__(self, services: Services) -> None:
        super().__init__(services)
        job = services.reconstruction
        box = self.inspector(self.tr("Reconstruct"))
        self.verdict = label("", wrap=True)
        self._error = BigNumber(self.tr("µm expected error"))
        self._supported = BigNumber(self.tr("% supported"))
        self._supported.setToolTip(
            self.tr(
                "Share of the whole surface that rests on measured points, the base on which the object stood included; Deliver leaves the base out."
            )
        )
        self._triangles = BigNumber(self.tr("triangles"))
        self._volume = BigNumber(self.tr("mm³ volume"))
        self._numbers = QWidget()
        numbers = QGridLayout(self._numbers)
        numbers.setContentsMargins(0, 0, 0, 0)
        for place, number in enumerate((self._error, self._supported, self._triangles, self._volume)):
            numbers.addWidget(number, place // 2, place % 2)
        self._phases = ReconstructionPhases(job)
        self._chart_title = label(self.tr("Distance of the points from the surface"), "section", wrap=True)
        self._chart = DistanceChart()
        self._told = _Facts()
        self.wishes = ReconstructionWishes(services.draft)
        self.again = button(self.tr("Other settings…"), "link", self._unfold_wishes)
        self.processing = ProcessingRows(services)
        self.anew = button(self.tr("Compute the points anew…"), "link", lambda: self.processing.setVisible(self.processing.isHidden()))
        self.processing.hide()
        middle = QWidget()
        inside = QVBoxLayout(middle)
        inside.setContentsMargins(0, 0, 6, 0)
        inside.setSpacing(9)
        for part in (self.verdict, self._numbers, self._phases, self._chart_title, self._chart, self._told):
            inside.addWidget(part)
        inside.addWidget(self.again, alignment=Qt.AlignmentFlag.AlignLeft)
        inside.addWidget(self.wishes)
        inside.addWidget(self.anew, alignment=Qt.AlignmentFlag.AlignLeft)
        inside.addWidget(self.processing)
        inside.addStretch(1)
        box.addWidget(scrolled(middle), 1)
        self.waiting = ReconstructionWaiting(job)
        self._next = button(self.tr("Deliver"), "primary", lambda: self.wanted.emit("deliver"))
        self.missing = button(self.tr("Complete"), "", lambda: self.intent.emit("coverage"))
        self.missing.setToolTip(self.tr("Places that are not as certain as wanted, why, and what can be done about them (F8)"))
        self._start = button(self.tr("Reconstruct"), "primary", lambda: self.intent.emit("reconstruct"))
        self.enough = button(self.tr("Stop here and keep"), "", job.end_early)
        self.enough.setToolTip(self.tr("Finishes the surface as it is now: whole and closed, but coarser than the points allow."))
        self._cancel = button(self.tr("Cancel"), "", job.cancel)
        box.addWidget(seam())
        for part in (self.waiting, self._next, self.missing, self._start, self.enough, self._cancel):
            box.addWidget(part)
        for told in (services.case.opened, services.case.meshed):
            told.connect(self._fold)
        self._carried: tuple[object, object, Carried | None] = (None, None, None)
        for told in (job.changed, job.began, job.ended, services.case.opened, services.case.meshed, services.acquisition.ended):
            told.connect(self._show)
        for told in (job.ended, services.acquisition.ended):
            told.connect(self.processing.show_choice)
        services.draft.changed.connect(lambda _: self._show_start())
        self._fold()
        self._show()

    def entered(self) -> None:
        self._show()

    def tick(self) -> None:
        """The time of a phase goes on between two messages."""
        if self.isVisible() and self.services.reconstruction.mine:
            self._phases.show_job()

    # -------------------------------------------------------------------------------- inside
    def _fold(self) -> None:
        """Another case or surface: what was unfolded for the last one is not of this one."""
        self.processing.hide()
        self.wishes.setVisible(not self.services.case.report)

    def _unfold_wishes(self) -> None:
        self.wishes.setVisible(self.wishes.isHidden())
        self._show()

    def _show(self) -> None:
        job, case = self.services.reconstruction, self.services.case
        mine, report = job.mine, case.report
        done = bool(report) and not mine
        if not report and not mine:
            self.wishes.show()
        wishing = not mine and not self.wishes.isHidden()
        words, role = ("", "") if mine else verdict(report) if done else (self._ready_words(), "muted")
        self.verdict.setText(words)
        self.verdict.setVisible(not mine)
        give_role(self.verdict, role)
        self._show_numbers(report, done, mine)
        self._phases.setVisible(mine)
        if mine:
            self._phases.show_job()
        self._show_chart(report, done and not wishing, mine)
        self._told.setVisible(done and not wishing)
        self._told.show_report(report)
        self.again.setVisible(done)
        self.again.setText(self.tr("Back to the result") if wishing else self.tr("Other settings…"))
        self.wishes.setVisible(wishing)
        self.wishes.show_carried(self._known())
        self.anew.setVisible(not mine and case.cloud is not None)
        if mine:
            self.processing.hide()
        self.waiting.show_queue()
        self._show_buttons(done, mine)

    def _ready_words(self) -> str:
        case, job = self.services.case, self.services.reconstruction
        if job.waits:
            return self.tr("These points wait for their turn.")
        if case.surface is not None:
            return self.tr("The surface is kept in the case.")
        if case.cloud is not None:
            return self.tr("{points} points are ready.").format(points=fmt.count(len(case.cloud)))
        return self.tr("Scan first, or open a case with points.")

    def _show_numbers(self, report: dict[str, object], done: bool, mine: bool) -> None:
        job = self.services.reconstruction
        self._numbers.setVisible(done or mine)
        for number in (self._error, self._supported, self._volume):
            number.setVisible(done)
        self._error.show_number(fmt.micrometres(_number(report, "expected_error_rms_um")))
        self._supported.show_number(fmt.percent(_number(report, "supported_area_fraction")))
        volume = _number(report, "volume_mm3")
        self._volume.show_number(fmt.NO_VALUE if not volume else fmt.count(round(volume)))
        shown = job.shown_triangles if mine else _number(report, "triangles")
        self._triangles.show_number(fmt.NO_VALUE if shown is None else fmt.count(int(shown)))

    def _show_chart(self, report: dict[str, object], done: bool, mine: bool) -> None:
        live, kept = self.services.reconstruction.distances, _distances(report)
        self._chart_title.setVisible(mine or (done and kept is not None))
        self._chart.setVisible(mine or (done and kept is not None))
        if mine:
            self._chart.show_distances(*((live.counts, live.median_um, live.p95_um) if live is not None else ((), 0.0, 0.0)))
        elif kept is not None:
            self._chart.show_distances(*kept)

    def _known(self) -> Carried | None:
        """What the points of the case give; looked at again only when they or the surface are others."""
        case = self.services.case
        cloud, provenance = case.cloud, case.provenance
        if self._carried[0] is not cloud or self._carried[1] is not provenance:
            parameters = provenance.get("parameters")
            after = carried_after(case.report, parameters) if isinstance(parameters, dict) else None
            self._carried = (cloud, provenance, after if after is not None or cloud is None else carried_by(cloud))
        return self._carried[2]

    def _show_buttons(self, done: bool, mine: bool) -> None:
        job = self.services.reconstruction
        self._cancel.setVisible(mine)
        self._cancel.setEnabled(not job.cancelling)
        self.enough.setVisible(mine)
        self.enough.setEnabled(not job.cancelling and not job.ending_early)
        self._next.setVisible(done)
        self.missing.setVisible(done)
        self._show_start()

    def _show_start(self) -> None:
        job, case = self.services.reconstruction, self.services.case
        done = bool(case.report)
        self._start.setVisible(not job.mine)
        full = job.running and job.queue.full and not job.waits
        self._start.setEnabled(case.cloud is not None and not self.services.acquisition.running and not full and not job.waits)
        self._start.setToolTip(self.tr("As many orders wait as can be kept in mind. Take one out, or wait for the next to begin.") if full else "")
        words = self.tr("Reconstruct again") if done else self.tr("Reconstruct")
        if job.running:
            words = self.tr("It waits") if job.waits else self.tr("Reconstruct next")
        self._start.setText(words)
        make_primary(self._start, not done and not job.waits)


class _Facts(QWidget):
    """What else a report tells, a line each."""

    def __init__(self) -> None:
        super().__init__()
        self._grid = QGridLayout()
        self._grid.setColumnStretch(0, 1)
        self._grid.setVerticalSpacing(5)
        self._remarks = label("", "bad", wrap=True)
        box = QVBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.addLayout(self._grid)
        box.addWidget(self._remarks)
        self._names = (self.tr("Closed"), self.tr("Points to surface"), self.tr("Noise of the points"), self.tr("Outliers rejected"), self.tr("Time"))
        self._values = [label("") for _ in self._names]
        for line, (name, value) in enumerate(zip(self._names, self._values, strict=True)):
            self._grid.addWidget(label(name, "muted"), line, 0)
            self._grid.addWidget(value, line, 1, Qt.AlignmentFlag.AlignRight)

    def show_report(self, report: dict[str, object]) -> None:
        closed = bool(report.get("closed"))
        give_role(self._values[0], "good" if closed else "bad")
        said = (
            self.tr("yes") if closed else self.tr("no"),
            self.tr("{n} µm rms").format(n=fmt.micrometres(_number(report, "residual_rms_um"))),
            self.tr("{n} µm").format(n=fmt.micrometres(_number(report, "noise_sigma_um"))),
            fmt.count(int(_number(report, "outliers_rejected") or 0)),
            self.tr("{n} s").format(n=fmt.decimal(_number(report, "seconds") or 0.0, 1)),
        )
        for value, words in zip(self._values, said, strict=True):
            value.setText(words)
        remarks = other_remarks(report)
        self._remarks.setText(remarks)
        self._remarks.setVisible(bool(remarks))


def _number(report: dict[str, object], key: str) -> float | None:
    value = report.get(key)
    return float(value) if isinstance(value, int | float) else None


def _distances(report: dict[str, object]) -> tuple[tuple[int, ...], float, float] | None:
    """Of the finished surface, where the case keeps them."""
    kept = report.get("distances")
    if not isinstance(kept, dict):
        return None
    counts, median_um, p95_um = kept.get("counts"), _number(kept, "median_um"), _number(kept, "p95_um")
    if not isinstance(counts, list) or len(counts) != CLASSES or median_um is None or p95_um is None:
        return None
    return tuple(int(count) for count in counts), median_um, p95_um
