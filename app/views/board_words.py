"""What is seen of the calibration board, in the technician's words."""

from __future__ import annotations

from PySide6.QtCore import QCoreApplication

from app.translation import QT_TRANSLATE_NOOP
from scanner_core.optics.board_view import BoardMissReason
from scanner_core.optics.board_watch import BoardWatch, CameraSighting, Phase, Side, ViewVerdict, Wish, WishKind

_MISSES = {
    BoardMissReason.TOO_DARK: QT_TRANSLATE_NOOP("board", "Too dark"),
    BoardMissReason.TOO_BRIGHT: QT_TRANSLATE_NOOP("board", "Too bright"),
    BoardMissReason.TOO_BLURRED: QT_TRANSLATE_NOOP("board", "Blurred"),
    BoardMissReason.NO_BOARD: QT_TRANSLATE_NOOP("board", "No board in sight"),
    BoardMissReason.CUT: QT_TRANSLATE_NOOP("board", "Cut by the picture's edge"),
    BoardMissReason.TOO_FEW_CORNERS: QT_TRANSLATE_NOOP("board", "Too little of the board in sight"),
}
_VERDICTS = {
    ViewVerdict.TAKEN: QT_TRANSLATE_NOOP("board", "View taken."),
    ViewVerdict.MISSED: QT_TRANSLATE_NOOP("board", "Neither camera sees the board."),
    ViewVerdict.ONE_CAMERA: QT_TRANSLATE_NOOP("board", "Only one camera sees the board."),
    ViewVerdict.FEW_IN_COMMON: QT_TRANSLATE_NOOP("board", "Both cameras see the board, but not the same part of it."),
    ViewVerdict.TOO_SIMILAR: QT_TRANSLATE_NOOP("board", "Too similar to an earlier view: move or tilt the board."),
    ViewVerdict.MOVING: QT_TRANSLATE_NOOP("board", "Hold the board still."),
}
_TASKS = {
    Phase.BOARD: QT_TRANSLATE_NOOP("board", "Hold the board into the volume"),
    Phase.BAR: QT_TRANSLATE_NOOP("board", "Hold the length bar into the volume"),
    Phase.TABLE: QT_TRANSLATE_NOOP("board", "Lay the board on the table"),
}
_TAKEN = {
    Phase.BOARD: QT_TRANSLATE_NOOP("board", "View {n} taken. Now tilt it another way."),
    Phase.BAR: QT_TRANSLATE_NOOP("board", "Bar {n} taken. Now hold it another way."),
    Phase.TABLE: QT_TRANSLATE_NOOP("board", "Angle {n} taken. The table turns: hands off."),
}
_MOVING = {
    Phase.BOARD: QT_TRANSLATE_NOOP("board", "Hold the board still."),
    Phase.BAR: QT_TRANSLATE_NOOP("board", "Hold the bar still."),
    Phase.TABLE: QT_TRANSLATE_NOOP("board", "Take your hands away."),
}
_COUNTS = {
    Phase.BOARD: QT_TRANSLATE_NOOP("board", "View {n} of {count}"),
    Phase.BAR: QT_TRANSLATE_NOOP("board", "Length bar {n} of {count}"),
    Phase.TABLE: QT_TRANSLATE_NOOP("board", "Angle {n} of {count}"),
}
_HINTS = {
    Phase.BOARD: QT_TRANSLATE_NOOP("board", "Each time at another place and tilted another way; hold it still until it is taken."),
    Phase.BAR: QT_TRANSLATE_NOOP("board", "Both of its ends in sight of both cameras."),
    Phase.TABLE: QT_TRANSLATE_NOOP("board", "Flat, face up, about the table's middle; then the table turns by itself."),
}
_COMPUTING = {
    Phase.BOARD: QT_TRANSLATE_NOOP("board", "Computing cameras and lenses from all views."),
    Phase.BAR: QT_TRANSLATE_NOOP("board", "Computing the scale from the length bar."),
    Phase.TABLE: QT_TRANSLATE_NOOP("board", "Computing the table's axis and the uncertainty."),
}
_PLACES = {
    (-1, -1): QT_TRANSLATE_NOOP("board", "Bring the board to the upper left of the {camera} picture"),
    (-1, 0): QT_TRANSLATE_NOOP("board", "Bring the board to the upper middle of the {camera} picture"),
    (-1, 1): QT_TRANSLATE_NOOP("board", "Bring the board to the upper right of the {camera} picture"),
    (0, -1): QT_TRANSLATE_NOOP("board", "Bring the board to the left of the {camera} picture"),
    (0, 0): QT_TRANSLATE_NOOP("board", "Bring the board to the middle of the {camera} picture"),
    (0, 1): QT_TRANSLATE_NOOP("board", "Bring the board to the right of the {camera} picture"),
    (1, -1): QT_TRANSLATE_NOOP("board", "Bring the board to the lower left of the {camera} picture"),
    (1, 0): QT_TRANSLATE_NOOP("board", "Bring the board to the lower middle of the {camera} picture"),
    (1, 1): QT_TRANSLATE_NOOP("board", "Bring the board to the lower right of the {camera} picture"),
}


def _tr(text: str) -> str:
    return QCoreApplication.translate("board", text)


def task_text(phase: Phase) -> str:
    """What to do."""
    return _tr(_TASKS[phase])


def hint_text(phase: Phase) -> str:
    """How to do it."""
    return _tr(_HINTS[phase])


def count_text(watch: BoardWatch) -> str:
    """View 7 of 25."""
    return _tr(_COUNTS[watch.phase]).format(n=watch.index + 1, count=watch.count)


def verdict_text(verdict: ViewVerdict) -> str:
    """What became of the view."""
    return _tr(_VERDICTS[verdict])


def sighting_text(watch: BoardWatch, side: Side) -> str:
    """At a camera's picture: how many corners it sees, or why the view is of no use."""
    seen: CameraSighting = getattr(watch, side)
    if seen.reason is not None:
        return _tr(_MISSES[seen.reason])
    if watch.verdict is not ViewVerdict.TAKEN:
        return verdict_text(watch.verdict)
    return _tr(QT_TRANSLATE_NOOP("board", "{n} corners")).format(n=seen.corners)


def now_text(watch: BoardWatch) -> str:
    """What to do now, short enough to be shown large: what is wrong first, then what would help most."""
    if watch.verdict is ViewVerdict.TAKEN:
        if watch.index + 1 == watch.count:
            return computing_text(watch.phase)
        return _tr(_TAKEN[watch.phase]).format(n=watch.index + 1)
    if watch.verdict is ViewVerdict.MOVING:
        return _tr(_MOVING[watch.phase])
    if watch.phase is not Phase.BOARD and watch.index == 0:
        return task_text(watch.phase)  # what is seen is still the step before
    if watch.verdict is ViewVerdict.TOO_SIMILAR and watch.wishes:
        return _wish_text(watch.wishes[0]) if watch.wishes[0].kind is not WishKind.MORE_VIEWS else verdict_text(watch.verdict)
    if watch.verdict in (ViewVerdict.MISSED, ViewVerdict.ONE_CAMERA):
        left, right = watch.left.reason, watch.right.reason
        if left is right is BoardMissReason.NO_BOARD:
            return task_text(watch.phase)
        if left is right and left is not None:
            return _tr(_MISSES[left])
        side, reason = ("left camera's", left) if left is not None else ("right camera's", right)
        if reason is not None:
            return _tr(QT_TRANSLATE_NOOP("board", "{what} in the {camera} picture")).format(what=_tr(_MISSES[reason]), camera=_tr(side))
    return verdict_text(watch.verdict)


def computing_text(phase: Phase) -> str:
    """What is computed after the last view of a phase."""
    return _tr(_COMPUTING[phase])


def missing_texts(watch: BoardWatch) -> list[str]:
    """What is still wanted, most helpful first."""
    if watch.phase is Phase.BOARD:
        return [_wish_text(wish) for wish in watch.wishes]
    rest = watch.count - watch.index - (watch.verdict is ViewVerdict.TAKEN)
    if rest <= 0:
        return []
    if watch.phase is Phase.BAR:
        return [_tr(QT_TRANSLATE_NOOP("board", "More views of the length bar: {n}")).format(n=rest)]
    return [_tr(QT_TRANSLATE_NOOP("board", "More angles of the table: {n}")).format(n=rest)]


def _wish_text(wish: Wish) -> str:
    if wish.kind is WishKind.MORE_VIEWS:
        return _tr(QT_TRANSLATE_NOOP("board", "More views: {n}")).format(n=wish.count)
    if wish.kind is WishKind.TILT_MORE:
        return _tr(QT_TRANSLATE_NOOP("board", "Tilt the board more, each time to another side"))
    if wish.kind is WishKind.VARY_DISTANCE:
        return _tr(QT_TRANSLATE_NOOP("board", "Bring the board nearer and farther"))
    side = QT_TRANSLATE_NOOP("board", "left camera's") if wish.camera == "left" else QT_TRANSLATE_NOOP("board", "right camera's")
    return _tr(_PLACES[wish.row, wish.column]).format(camera=_tr(side))
