"""What delivered files are called: a template with fields in braces, filled in from the order.  The patient stays out of it unless a
person wants that."""

from __future__ import annotations

import re
from collections.abc import Sequence
from datetime import date
from pathlib import Path

from scanner_core.case.records import Order

FIELDS = ("order", "side", "type", "date", "rev", "code")
"""What may stand in braces in a template."""
PATIENT = "code"
"""The field that says whose it is; left out unless it is allowed."""
DEFAULT_TEMPLATE = "{order}_{side}_{type}_{date}-{rev}"
_BRACES = re.compile(r"\{([^{}]*)\}")


def file_stem(template: str, order: Order, revision: int, today: date, *, with_code: bool = False) -> str:
    """The template filled in, without a suffix; unknown braces stay as they are and the result is a name on every system.

    Without `with_code` the patient's code is left out, also where the template asks for it.
    """
    known = {
        "order": order.number or "order",
        "side": order.side,
        "type": order.type,
        "date": today.isoformat(),
        "rev": str(revision),
        PATIENT: (order.patient_code or "code") if with_code else "",
    }
    filled = _BRACES.sub(lambda found: known.get(found[1], found[0]), template)
    return safe_stem(re.sub("([_-])[_-]*_+", r"\1", filled).strip("_"))  # an order may have no side


def free_stem(folder: Path, template: str, order: Order, suffixes: Sequence[str], today: date, *, with_code: bool = False) -> str:
    """The stem with the first revision of which no file is there; without ``{rev}`` simply the stem."""
    revision = 1
    first = stem = file_stem(template, order, revision, today, with_code=with_code)
    while "{rev}" in template and any(folder.joinpath(stem + suffix).exists() for suffix in suffixes):
        revision += 1
        stem = file_stem(template, order, revision, today, with_code=with_code)
        if stem == first:  # so long that its revision was cut off
            stem = f"{first[:110]}-{revision}"
    return stem


def unknown_fields(template: str) -> list[str]:
    """What stands in braces in a template and is no field, in its order."""
    return [name for name in dict.fromkeys(_BRACES.findall(template)) if name not in FIELDS]


def names_the_patient(template: str) -> bool:
    return PATIENT in _BRACES.findall(template)


def safe_stem(text: str) -> str:
    """The text as a file's name on every system."""
    return re.sub(r"[^\w.+-]+", "-", text).strip("-. ")[:120] or "case"
