"""What files are called, from the form; see :mod:`scanner_core.delivery.file_name`."""

from __future__ import annotations

from datetime import date
from pathlib import Path

from app.draft import DraftValues
from scanner_core.case.records import Order
from scanner_core.delivery.file_name import FIELDS, PATIENT, file_stem, free_stem, names_the_patient, safe_stem, unknown_fields

__all__ = ["FIELDS", "PATIENT", "file_name", "free_name", "names_the_patient", "order_of", "safe_stem", "unknown_fields"]


def order_of(values: DraftValues) -> Order:
    """The order that stands in the form."""
    return Order(values.order, values.patient_code, values.side, values.kind)


def file_name(template: str, values: DraftValues, revision: int, suffix: str, today: date, *, with_code: bool = False) -> str:
    """A file's name for the order of the form."""
    return file_stem(template, order_of(values), revision, today, with_code=with_code) + suffix


def free_name(folder: Path, template: str, values: DraftValues, suffix: str, today: date, *, with_code: bool = False) -> Path:
    """The path with the first revision that is not taken; without ``{rev}`` simply the name."""
    return folder / (free_stem(folder, template, order_of(values), [suffix], today, with_code=with_code) + suffix)
