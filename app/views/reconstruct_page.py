"""Reconstruct: what is wanted, the three phases with their progress, and the numbers of the result."""

from __future__ import annotations

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtWidgets import QGridLayout, QProgressBar, QVBoxLayout, QWidget

from app.controllers.reconstruction import PHASES
from app.services import Services
from app.theme import Sign
from app.translation import QT_TRANSLATE_NOOP
from app.views import format as fmt
from app.views.page import Page
from app.views.parts import BigNumber, button, label, number_field, row, seam
from app.views.processing_rows import ProcessingRows

PHASE_WORDS = {
    "inflate": (QT_TRANSLATE_NOOP("phases", "Inflate"), QT_TRANSLATE_NOOP("phases", "grows to the points")),
    "refine": (QT_TRANSLATE_NOOP("phases", "Refine"), QT_TRANSLATE_NOOP("phases", "where the error is")),
    "smooth": (QT_TRANSLATE_NOOP("phases", "Smooth"), QT_TRANSLATE_NOOP("phases", "without shrinking")),
}


class ReconstructPage(Page):
    """Stands beside the surface."""

    def __init__(self, services: Services) -> None:
        super().__init__(services)
        box = self.inspector(self.tr("Reconstruct"))
        self._error = BigNumber(self.tr("µm expected error"))
        self._supported = BigNumber(self.tr("% supported"))
        self._triangles = BigNumber(self.tr("triangles"))
        box.addWidget(self._error)
        box.addLayout(row(self._triangles, self._supported, spacing=6))
        box.addWidget(seam())
        self._phases = {name: _PhaseLine(name) for name in PHASES}
        for line in self._phases.values():
            box.addWidget(line)
        self._bar = QProgressBar()
        self._bar.setRange(0, 1000)
        self._bar.setTextVisible(False)
        self._step = label("", "muted", wrap=True)
        box.addWidget(self._bar)
        box.addWidget(self._step)
        box.addWidget(seam())
        self._told = QWidget()
        told = QVBoxLayout(self._told)
        told.setContentsMargins(0, 0, 0, 0)
        self._facts = QGridLayout()
        self._facts.setColumnStretch(0, 1)
        self._facts.setVerticalSpacing(5)
        told.addLayout(self._facts)
        self._warnings = label("", "bad", wrap=True)
        told.addWidget(self._warnings)
        box.addWidget(self._told)
        box.addStretch(1)
        box.addWidget(seam())
        self.processing = ProcessingRows(services)
        self.anew = button(self.tr("Compute the points anew…"), "link", self._unfold)
        box.addWidget(self.anew)
        box.addWidget(self.processing)
        self.processing.hide()
        draft = services.draft
        self._wanted = number_field(0, 2_000_000, 1000, lambda value: draft.edit("triangles", value), special=self.tr("automatic"))
        self._tolerance = number_field(0, 1000, 5, lambda value: draft.edit("tolerance_um", value), suffix=" µm", special=self.tr("not set"))
        self._tolerance.setToolTip(self.tr("When it is set, the surface gets as many triangles as this tolerance needs."))
        wishes = QGridLayout()
        wishes.setColumnStretch(0, 1)
        for line_number, (name, field) in enumerate(((self.tr("Triangles, at most"), self._wanted), (self.tr("Tolerance"), self._tolerance))):
            caption = label(name, "muted")
            caption.setBuddy(field)
            field.setFixedWidth(140)
            wishes.addWidget(caption, line_number, 0)
            wishes.addWidget(field, line_number, 1)
        box.addLayout(wishes)
        self._start = button(self.tr("Reconstruct"), "primary", lambda: self.intent.emit("reconstruct"))
        self._cancel = button(self.tr("Cancel"), "", services.reconstruction.cancel)
        self._next = button(self.tr("Deliver"), "primary", lambda: self.wanted.emit("deliver"))
        self.missing = button(self.tr("Coverage"), "", lambda: self.intent.emit("coverage"))
        self.missing.setToolTip(self.tr("Places that are not as certain as wanted, why, and what can be done about them (F8)"))
        box.addWidget(self._next)
        box.addWidget(self.missing)
        box.addWidget(self._start)
        box.addWidget(self._cancel)
        services.reconstruction.changed.connect(self._show)
        services.reconstruction.began.connect(self._show)
        services.reconstruction.ended.connect(self._show)
        services.reconstruction.ended.connect(self.processing.show_choice)
        services.case.opened.connect(self._show)
        services.case.meshed.connect(self._show)
        services.acquisition.ended.connect(self._show)
        services.acquisition.ended.connect(self.processing.show_choice)
        draft.changed.connect(self._show_field)
        for name in ("triangles", "tolerance_um"):
            self._show_field(name)
        self._show()

    def entered(self) -> None:
        self._show()

    def _unfold(self) -> None:
        """The place of the facts, which are those of the points as they were."""
        folded = self.processing.isHidden()
        self.processing.setVisible(folded)
        self._told.setVisible(not folded)

    def _show_field(self, name: str) -> None:
        values = self.services.draft.values
        if name == "triangles":
            self._wanted.setValue(values.triangles)
        elif name == "tolerance_um":
            self._tolerance.setValue(values.tolerance_um)

    def _show(self) -> None:
        job, case = self.services.reconstruction, self.services.case
        report = {} if job.running else case.report
        self._error.show_number(fmt.micrometres(_number(report, "expected_error_rms_um")))
        self._supported.show_number(fmt.percent(_number(report, "supported_area_fraction")))
        shown = job.shown_triangles if job.running else _number(report, "triangles")
        self._triangles.show_number(fmt.NO_VALUE if shown is None else fmt.count(int(shown)))
        seconds = job.phase_seconds if job.running or job.phase_seconds else {}
        if not job.running and report:
            seconds = {str(phase["name"]): _number(phase, "seconds") or 0.0 for phase in _list(report, "phases")}
        now = job.progress.phase if job.running and job.progress is not None else ""
        for name, line in self._phases.items():
            line.show_phase(active=name == now, seconds=seconds.get(name))
        self._bar.setVisible(job.running)
        self._bar.setValue(0 if job.progress is None else round(1000 * job.progress.fraction))
        self._step.setText(self._sentence())
        self._show_facts(report)
        self._show_buttons(bool(report))

    def _sentence(self) -> str:
        job, case = self.services.reconstruction, self.services.case
        if job.cancelling:
            return self.tr("Cancelling…")
        if job.running:
            left = None if job.progress is None else job.progress.seconds_left
            return self.tr("Starting…") if job.progress is None else self.tr("{left} left").format(left=fmt.left_time(left))
        if case.surface is not None:
            return self.tr("The surface is kept in the case.")
        if case.cloud is not None:
            return self.tr("{points} points are ready.").format(points=fmt.count(len(case.cloud)))
        return self.tr("Scan an object or open a case first.")

    def _show_facts(self, report: dict[str, object]) -> None:
        while self._facts.count():
            item = self._facts.takeAt(0)
            part = item.widget() if item is not None else None
            if part is not None:
                part.hide()
                part.deleteLater()
        if not report:
            self._warnings.setText("")
            self._warnings.hide()
            return
        crossing = _number(report, "self_intersections")
        facts: list[tuple[str, str, str]] = [
            (self.tr("Closed"), self.tr("yes") if report.get("closed") else self.tr("no"), "good" if report.get("closed") else "bad"),
            (self.tr("Self-intersections"), self.tr("none") if not crossing else fmt.count(int(crossing)), "good" if not crossing else "bad"),
            (self.tr("Points to surface"), self.tr("{n} µm rms").format(n=fmt.micrometres(_number(report, "residual_rms_um"))), ""),
            (self.tr("Noise of the points"), self.tr("{n} µm").format(n=fmt.micrometres(_number(report, "noise_sigma_um"))), ""),
            (self.tr("Outliers rejected"), fmt.count(int(_number(report, "outliers_rejected") or 0)), ""),
            (self.tr("Time"), self.tr("{n:.1f} s").format(n=_number(report, "seconds") or 0.0), ""),
        ]
        for line, (name, value, role) in enumerate(facts):
            self._facts.addWidget(label(name, "muted"), line, 0)
            self._facts.addWidget(label(value, role), line, 1, Qt.AlignmentFlag.AlignRight)
        warnings = [str(warning) for warning in _list(report, "warnings")]
        self._warnings.setText("\n".join(warnings))
        self._warnings.setVisible(bool(warnings))

    def _show_buttons(self, done: bool) -> None:
        job, case = self.services.reconstruction, self.services.case
        self._cancel.setVisible(job.running)
        self._cancel.setEnabled(not job.cancelling)
        self._start.setVisible(not job.running)
        self._start.setEnabled(case.cloud is not None and not self.services.acquisition.running)
        self._start.setText(self.tr("Reconstruct again") if done else self.tr("Reconstruct"))
        self._next.setVisible(done and not job.running)
        self.missing.setVisible(done and not job.running)
        role = "" if done else "primary"
        if self._start.property("role") != role:
            self._start.setProperty("role", role)
            self._start.style().unpolish(self._start)
            self._start.style().polish(self._start)
        for field in (self._wanted, self._tolerance):
            field.setEnabled(not job.running)


class _PhaseLine(QWidget):
    """A phase: a mark, its name, what it does, and its time."""

    def __init__(self, name: str) -> None:
        super().__init__()
        title, what = (QCoreApplication.translate("phases", word) for word in PHASE_WORDS[name])
        self._mark = Sign(15)
        self._title = label(title)
        self._time = label("", "muted")
        line = row(self._mark, self._title, label(what, "faint"), 1, self._time, spacing=6)
        line.setContentsMargins(0, 0, 0, 0)
        self.setLayout(line)
        self._shown: tuple[bool, float | None] | None = None
        self.show_phase(active=False, seconds=None)

    def show_phase(self, *, active: bool, seconds: float | None) -> None:
        if (active, seconds) == self._shown:
            return
        self._shown = (active, seconds)
        name, colour = ("play", "accent") if active else ("check", "accent") if seconds is not None else ("note", "faint")
        self._mark.show_sign(name, colour)
        self._title.setStyleSheet("font-weight: 600;" if active else "")
        self._time.setText("" if seconds is None else f"{seconds:.1f} s")


def _number(report: dict[str, object], key: str) -> float | None:
    value = report.get(key)
    return float(value) if isinstance(value, int | float) else None


def _list(report: dict[str, object], key: str) -> list[dict[str, object]]:
    value = report.get(key)
    return value if isinstance(value, list) else []
