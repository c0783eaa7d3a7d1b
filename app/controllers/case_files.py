"""The files of orders: an order is a case file, made as soon as the order is entered."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass
from datetime import date
from pathlib import Path
from typing import TYPE_CHECKING

from app.draft import KINDS, DraftValues, orders_of
from app.file_names import safe_stem
from scanner_core import wall_clock

if TYPE_CHECKING:
    from scanner_core.case.store import CaseStore

SUFFIX = ".impronta"
DEMO = "DEMO-"
"""Orders whose number begins so are tried out: the others are not counted on from them."""


def create_cases(folder: Path, values: DraftValues) -> CaseStore:
    """A new case for every order of the form, each whole on its disk; the first of them open.

    Raises
    ------
    StorageError
        E-DISK-01 or E-DISK-02 when one cannot be written; those that were made before it stay.
    """
    from scanner_core.case.store import CaseStore, Order
    from scanner_core.files import storage_error

    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as fault:
        raise storage_error(folder, fault) from fault
    made: list[CaseStore] = []
    try:
        for order in orders_of(values):
            made.append(CaseStore.create(free_case_path(folder, order, wall_clock.today())))
            made[-1].put_order(Order(order.order, order.patient_code, order.side, order.kind))
    except BaseException:
        for store in made:
            store.close()
        raise
    for store in made[1:]:
        store.close()
    return made[0]


def is_new(store: CaseStore) -> bool:
    """Nothing was scanned into it yet."""
    from scanner_core.case.case_glance import OrderState
    from scanner_core.case.glance import glance_of

    return glance_of(store).state is OrderState.NEW


def free_case_path(folder: Path, values: DraftValues, today: date) -> Path:
    """``2026-0142_left_ear_2026-11-23.impronta``, with -2, -3 ... when that is taken, be it by the log of a case that is gone."""
    from scanner_core.case.logs import left_behind

    stem = safe_stem("_".join(part for part in (values.order or "order", values.side, values.kind, today.isoformat()) if part))
    path, number = folder / f"{stem}{SUFFIX}", 1
    while path.exists() or left_behind(path) is not None:
        number += 1
        path = folder / f"{stem}-{number}{SUFFIX}"
    return path


@dataclass(frozen=True, slots=True)
class CaseName:
    """What the name of a case file tells."""

    order: str
    side: str
    kind: str


_NAME = re.compile(rf"(.+?)(?:_(left|right|upper|lower))?_({'|'.join(KINDS)})_\d{{4}}-\d\d-\d\d(-\d+)?")


def read_case_name(stem: str) -> CaseName | None:
    """The reverse of :func:`free_case_path`; None for a name that a person has chosen."""
    found = _NAME.fullmatch(stem)
    return None if found is None else CaseName(found[1], found[2] or "", found[3])


def free_number(number: str, taken: Iterable[str]) -> str:
    """The number counted on until no order has it; one without digits at its end as it is."""
    used = set(taken)
    while number in used:
        stem = number.rstrip("0123456789")
        digits = number[len(stem) :]
        if not digits:
            return number
        number = f"{stem}{int(digits) + 1:0{len(digits)}d}"
    return number
