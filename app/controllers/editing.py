"""The points of the open case as a person edits them: which are taken out, which would be by what is proposed."""

from __future__ import annotations

import threading
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QObject, Signal

from app.background import Background
from app.controllers.acquisition import AcquisitionController
from app.controllers.case import CaseController
from app.translation import QT_TRANSLATE_NOOP
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.jobs.progress import Cancelled, Progress

if TYPE_CHECKING:
    from scanner_core.editing.base_plane import BasePlane
    from scanner_core.editing.outliers import Outlyingness
    from scanner_core.editing.screen_region import BrushStroke, Outline
    from scanner_core.editing.sight import Sight

    Region = Outline | BrushStroke

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]
TAKE_OUT, BRING_BACK = QT_TRANSLATE_NOOP("draft", "Take points out"), QT_TRANSLATE_NOOP("draft", "Bring points back")


@dataclass(frozen=True, slots=True, eq=False)
class EditedPoints:
    """All points of a case, those taken out among them.

    Attributes
    ----------
    cloud : all, in the order of their trigger ids
    towards : (n, 3) unit, where they were seen from
    bounds_mm : (2, 3) lowest and highest corner
    base : the plane that was found at what the object stands on
    """

    cloud: PointCloud
    towards: NDArray[np.float32]
    bounds_mm: Array
    base: BasePlane

    def __len__(self) -> int:
        return len(self.cloud)


@dataclass(frozen=True, slots=True, eq=False)
class _Stroke:
    """What a person draws in one go: candidates `at` (m,) with their points and places in the picture, and which of them it has held so far."""

    sight: Sight
    at: NDArray[np.int64]
    points: Array
    places: Array
    back: bool
    through: bool
    held: Mask


class EditingController(QObject):
    """Edits of the case in the order in which a person did them; what is shown comes first, the file follows."""

    loaded = Signal()
    """Other points, or none."""
    changed = Signal()
    """`out` or `marked` are others, or the search for outliers went on."""

    def __init__(
        self,
        background: Background,
        case: CaseController,
        acquisition: AcquisitionController,
        tell: Callable[[BaseException], None],
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._background, self._case, self._acquisition, self._tell = background, case, acquisition, tell
        self.points: EditedPoints | None = None
        self.out: Mask = np.zeros(0, np.bool_)
        """Which points are taken out."""
        self.marked: Mask | None = None
        """Which would be taken out; None without a proposal."""
        self.loading = False
        self.searched: float | None = None
        """How much of the search for outliers is done, 0 to 1; None while there is none."""
        self._outlying: Outlyingness | None = None
        self._stroke: _Stroke | None = None
        self._progress = 0.0
        self._stop = threading.Event()
        self._wanted = False
        self._known: PointCloud | None = None  # the case's points that `out` belongs to
        self._turn = 0
        self._writing = 0
        case.opened.connect(self._look)
        acquisition.ended.connect(self._look)

    # -------------------------------------------------------------------------------- what there is
    @property
    def able(self) -> bool:
        """There are points that can be edited now."""
        return self.points is not None and not self._acquisition.running and not self._case.computing

    @property
    def left(self) -> Array:
        """(m, 3) mm, the points that are not taken out."""
        return np.zeros((0, 3)) if self.points is None else self.points.cloud.points[~self.out]

    @property
    def gain(self) -> int:
        """How many points more the proposal would take out."""
        return 0 if self.marked is None else int((self.marked & ~self.out).sum())

    def want(self, on: bool) -> None:
        """Whether anybody looks at the points: they are made ready only then."""
        self._wanted = on
        if on:
            self._look()

    # -------------------------------------------------------------------------------- edits
    def propose(self, mask: Mask | None) -> None:
        """Show what would be taken out, (n,); None for nothing."""
        if mask is not None or self.marked is not None:
            self.marked = mask
            self.changed.emit()

    def accept(self) -> None:
        """Take out what is proposed."""
        marked, self.marked = self.marked, None
        if marked is not None:
            self.put(self.out | marked, TAKE_OUT)

    def take(self, mask: Mask) -> None:
        """Take these (n,) out."""
        self.put(self.out | mask, TAKE_OUT)

    def give(self, mask: Mask) -> None:
        """Bring these (n,) back."""
        self.put(self.out & ~mask, BRING_BACK)

    def invert(self) -> None:
        """What was left is out and the reverse."""
        self.put(~self.out, TAKE_OUT)

    def put(self, out: Mask, words: str) -> None:
        """Which points (n,) are out from now on; nothing happens when all would be, or none would change."""
        if not self.able or out.all() or (out == self.out).all():
            self.changed.emit()
            return
        before, self.out = self.out, out
        self._writing += 1
        self._case.take_out(out, words, self._written, partial(self._refused, before))
        self.changed.emit()

    # -------------------------------------------------------------------------------- by hand, on the picture
    def begin_stroke(self, sight: Sight, *, back: bool, through: bool) -> None:
        """What is drawn from now on takes points out as they are seen, or brings such ones back; `through` also those that others hide."""
        if self.points is None:
            return
        at = np.flatnonzero(self.out if back else ~self.out)
        points = self.points.cloud.points[at]
        self._stroke = _Stroke(sight, at, points, sight.places(points), back, through, np.zeros(len(at), np.bool_))

    def draw(self, region: Region) -> None:
        """What a region of the picture holds is shown as what would be done."""
        from scanner_core.editing.screen_region import selected

        stroke, points = self._stroke, self.points
        if stroke is None or points is None:
            return
        stroke.held[:] |= selected(stroke.points, stroke.sight, region, through=stroke.through, places=stroke.places)
        self.propose(self._held(stroke))

    def end_stroke(self) -> None:
        """Do it."""
        stroke, self._stroke = self._stroke, None
        if stroke is None or self.points is None:
            return
        self.marked = None
        if len(stroke.at) and stroke.held.any():
            (self.give if stroke.back else self.take)(self._held(stroke))
        else:
            self.changed.emit()

    def _held(self, stroke: _Stroke) -> Mask:
        mask = np.zeros(len(self.out), np.bool_)
        mask[stroke.at[stroke.held]] = True
        return mask

    # -------------------------------------------------------------------------------- outliers
    def find_outliers(self, limit: float) -> None:
        """Propose the outliers beyond a limit, see :meth:`~scanner_core.editing.outliers.Outlyingness.beyond`; the first time they are looked for."""
        points = self.points
        if points is None:
            return
        if self._outlying is not None:
            self.propose(self._outlying.beyond(limit) & ~self.out)
            return
        if self.searched is not None:
            return
        self.searched, self._progress = 0.0, 0.0
        self._stop = stop = threading.Event()

        def work() -> Outlyingness:
            from scanner_core.editing.outliers import outlyingness

            def note(progress: Progress) -> None:
                self._progress = progress.fraction

            return outlyingness(points.cloud.points, progress=note, cancelled=stop.is_set)

        def done(found: Outlyingness) -> None:
            self.searched = None
            if points is self.points:
                self._outlying = found
                self.propose(found.beyond(limit) & ~self.out)
            self.changed.emit()

        self._background.run("outliers", work, done, self._not_found)
        self.changed.emit()

    def cancel(self) -> None:
        """Give the search for outliers up."""
        self._stop.set()

    def drain(self) -> None:
        """For the pump: the newest progress."""
        if self.searched is not None and self.searched != self._progress:
            self.searched = self._progress
            self.changed.emit()

    def shutdown(self) -> None:
        self._stop.set()

    # -------------------------------------------------------------------------------- inside
    def _not_found(self, fault: Exception) -> None:
        self.searched = None
        self.changed.emit()
        if not isinstance(fault, Cancelled):
            self._tell(fault)

    def _written(self) -> None:
        """An edit of this page is in the case, whose points are now those that are left."""
        self._writing -= 1
        self._known = self._case.cloud

    def _refused(self, before: Mask) -> None:
        self._writing -= 1
        if len(before) == len(self.out):
            self.out = before
        self.changed.emit()

    def _look(self) -> None:
        """The case may have other points than are known."""
        case = self._case
        if (case.cloud is self._known and (case.cloud is None) == (self.points is None)) or (self._writing and case.cloud is not None):
            return
        if case.cloud is None or case.cloud.trigger_ids is None or self._acquisition.running:
            self._stop.set()
            self._turn += 1
            had, self.points, self._known, self._stroke = self.points, None, None, None
            self.marked = self._outlying = None
            self.out = np.zeros(0, np.bool_)
            if had is not None:
                self.loaded.emit()
            return
        if not self._wanted:
            return
        self.loading = True
        self._turn += 1
        done = partial(self._loaded, self._turn, case.cloud)
        self._background.run("edited-points", partial(_edited, case.cloud, case.taken_out, self.points), done, partial(self._failed, self._turn))

    def _failed(self, turn: int, fault: Exception) -> None:
        if turn == self._turn:
            self.loading = False
            self._tell(fault)

    def _loaded(self, turn: int, known: PointCloud, found: tuple[EditedPoints, Mask]) -> None:
        if turn != self._turn:
            return
        self.loading = False
        points, self.out = found
        self._stroke = None
        self._known = known
        if points is self.points:
            self.changed.emit()
            return
        self._stop.set()
        self.points, self.marked, self._outlying = points, None, None
        self.loaded.emit()


def _edited(cloud: PointCloud, taken_out: PointCloud | None, before: EditedPoints | None) -> tuple[EditedPoints, Mask]:
    """All points together and which of them are out; `before` again where they are the same."""
    from scanner_core.case.removed_points import RemovedPoints, together
    from scanner_core.editing.base_plane import find_base
    from scanner_core.geometry.view_directions import outward, seen_from

    whole = together(cloud, taken_out)
    out = np.zeros(len(whole), np.bool_) if taken_out is None else RemovedPoints.of_cloud(taken_out).of_points(whole)
    if before is not None and len(before) == len(whole) and (before.cloud.points == whole.points).all():
        return before, out
    towards = outward(whole.points) if whole.table_deg is None else seen_from(whole.table_deg)
    bounds = np.array([whole.points.min(axis=0), whole.points.max(axis=0)])
    return EditedPoints(whole, towards.astype(np.float32), bounds, find_base(cloud.points)), out
