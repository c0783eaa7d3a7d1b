"""What a person has entered: order, plan and parameters; one frozen value, edited through the undo stack."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass, replace

from PySide6.QtCore import QCoreApplication, QObject, Signal
from PySide6.QtGui import QUndoCommand, QUndoStack

from app.translation import QT_TRANSLATE_NOOP
from scanner_core import wall_clock

SIDES = {
    "left": QT_TRANSLATE_NOOP("draft", "Left"),
    "right": QT_TRANSLATE_NOOP("draft", "Right"),
    "upper": QT_TRANSLATE_NOOP("draft", "Upper jaw"),
    "lower": QT_TRANSLATE_NOOP("draft", "Lower jaw"),
    "both": QT_TRANSLATE_NOOP("draft", "Both"),
}
EARS, JAWS = ("left", "right"), ("upper", "lower")
"""The sides of an order's file, by what it is; with ``both`` the order has two files."""
KINDS = {
    "ear": QT_TRANSLATE_NOOP("draft", "Ear impression"),
    "arch": QT_TRANSLATE_NOOP("draft", "Dental model"),
    "arch-before": QT_TRANSLATE_NOOP("draft", "Dental model, before treatment"),
    "arch-after": QT_TRANSLATE_NOOP("draft", "Dental model, after treatment"),
    "other": QT_TRANSLATE_NOOP("draft", "Other"),
}


@dataclass(frozen=True, slots=True)
class DraftValues:
    """Order, plan and parameters as entered.

    Attributes
    ----------
    order, patient_code : free text; the code is never a full name by default
    side : a key of SIDES, or empty; ``both`` only until the two cases are made
    kind : a key of KINDS
    views, points : of the scan plan
    until_um : scan on where the surface is less certain than this, with `points` as the most; 0 = spread them evenly
    triangles : at most so many, 0 = as many as the points carry
    tolerance_um : wanted tolerance, 0 = none; it goes before the number of triangles
    detail : doublings of the triangles that the points carry, where neither of the two above is given
    smoothing, pass_band_percent : rounds of the filter of phase three, and what it leaves, of the highest spatial frequency
    support_percent : density of the points, of that among themselves, from which on the surface counts as measured
    open_base : leave away what no point supports
    seed : of the reconstruction's random choices
    """

    order: str = ""
    patient_code: str = ""
    side: str = "left"
    kind: str = "ear"
    views: int = 16
    points: int = 20_000
    until_um: int = 0
    triangles: int = 0
    tolerance_um: int = 0
    detail: int = 0
    smoothing: int = 3
    pass_band_percent: int = 10
    support_percent: int = 45
    open_base: bool = False
    seed: int = 0


ORDER_FIELDS = ("order", "patient_code", "side", "kind")
"""What belongs to the order, and so to the case while one is open."""


class Draft(QObject):
    """The current values; `changed(name)` after every edit, undo and redo."""

    changed = Signal(str)

    def __init__(self, stack: QUndoStack, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._values = DraftValues()
        self._stack = stack
        self._sealed = 0
        self.keep_order: Callable[[str], None] | None = None
        """While a case is open, called with the field of the order that was edited, and undo is the case's affair."""

    @property
    def values(self) -> DraftValues:
        return self._values

    def edit(self, name: str, value: object) -> None:
        """A person's edit: it can be undone."""
        old = getattr(self._values, name)
        if value == old:
            return
        if self.keep_order is not None and name in ORDER_FIELDS:
            self.put(name, value)
            self.keep_order(name)
        else:
            self._stack.push(_Edit(self, name, old, value, self._sealed))

    def edit_all(self, values: Mapping[str, object], words: str) -> None:
        """Several edits as one step, called `words` in the window's language."""
        self._stack.beginMacro(words)
        for name, value in values.items():
            self.edit(name, value)
        self._stack.endMacro()

    def seal(self) -> None:
        """What is typed from now on is a step of its own, also in the field of the last one."""
        self._sealed += 1

    def load(self, values: DraftValues) -> None:
        """Values that come with an opened case: nothing to undo before them."""
        self._stack.clear()
        self._values = values
        for name in DraftValues.__dataclass_fields__:
            self.changed.emit(name)

    def put(self, name: str, value: object) -> None:
        """Set without a way back; the undo commands use it."""
        self._values = DraftValues(**{**asdict(self._values), name: value})
        self.changed.emit(name)


EDIT_TEXTS = {
    "order": QT_TRANSLATE_NOOP("draft", "Edit order number"),
    "patient_code": QT_TRANSLATE_NOOP("draft", "Edit patient code"),
    "side": QT_TRANSLATE_NOOP("draft", "Change side"),
    "kind": QT_TRANSLATE_NOOP("draft", "Change type"),
    "views": QT_TRANSLATE_NOOP("draft", "Change number of views"),
    "points": QT_TRANSLATE_NOOP("draft", "Change number of points"),
    "until_um": QT_TRANSLATE_NOOP("draft", "Change wanted uncertainty"),
    "triangles": QT_TRANSLATE_NOOP("draft", "Change number of triangles"),
    "tolerance_um": QT_TRANSLATE_NOOP("draft", "Change tolerance"),
    "detail": QT_TRANSLATE_NOOP("draft", "Change detail"),
    "smoothing": QT_TRANSLATE_NOOP("draft", "Change smoothing"),
    "pass_band_percent": QT_TRANSLATE_NOOP("draft", "Change pass-band"),
    "support_percent": QT_TRANSLATE_NOOP("draft", "Change support threshold"),
    "open_base": QT_TRANSLATE_NOOP("draft", "Change open or closed base"),
    "seed": QT_TRANSLATE_NOOP("draft", "Change seed"),
}


class _Edit(QUndoCommand):
    """One field; typing on in the same field is one step."""

    def __init__(self, draft: Draft, name: str, old: object, new: object, sealed: int) -> None:
        super().__init__(QCoreApplication.translate("draft", EDIT_TEXTS[name]))
        self._draft, self._name, self._old, self.new, self.sealed = draft, name, old, new, sealed

    def redo(self) -> None:
        self._draft.put(self._name, self.new)

    def undo(self) -> None:
        self._draft.put(self._name, self._old)

    def id(self) -> int:
        return 1 + list(EDIT_TEXTS).index(self._name)

    def mergeWith(self, other: QUndoCommand) -> bool:  # noqa: N802 - Qt's name
        if not isinstance(other, _Edit) or other.id() != self.id() or other.sealed != self.sealed or self._name in ("side", "kind"):
            return False
        self.new = other.new
        return True


def sides_of(kind: str) -> tuple[str, ...]:
    """Which sides an order of that type can have."""
    return JAWS if kind.startswith("arch") else EARS


def orders_of(values: DraftValues) -> tuple[DraftValues, ...]:
    """One for every file: both sides of a pair with the same number."""
    return tuple(replace(values, side=side) for side in sides_of(values.kind)) if values.side == "both" else (values,)


def first_order(last: str) -> DraftValues:
    """What the form opens with: the first number of the year on the first start, then the one after the last; the side is never guessed."""
    stem = last.rstrip("0123456789")
    digits = last[len(stem) :]
    if not digits:
        return DraftValues(order=f"{wall_clock.today().year}-0001", side="")
    return DraftValues(order=f"{stem}{int(digits) + 1:0{len(digits)}d}", side="")
