"""What files are called: a template with fields in braces, filled in from the order.  The patient stays out of it unless a person wants that."""

from __future__ import annotations

import re
from datetime import date
from pathlib import Path

from app.draft import DraftValues

FIELDS = ("order", "side", "type", "date", "rev", "code")
"""What may stand in braces in a template."""
PATIENT = "code"
"""The field that says whose it is; left out unless it is allowed."""
_BRACES = re.compile(r"\{([^{}]*)\}")


def file_name(template: str, values: DraftValues, revision: int, suffix: str, today: date, *, with_code: bool = False) -> str:
    """The template filled in; unknown braces stay as they are and the result is a name on every system.

    Without `with_code` the patient's code is left out, also where the template asks for it.
    """
    known = {
        "order": values.order or "order",
        "side": values.side,
        "type": values.kind,
        "date": today.isoformat(),
        "rev": str(revision),
        PATIENT: (values.patient_code or "code") if with_code else "",
    }
    filled = _BRACES.sub(lambda found: known.get(found[1], found[0]), template)
    return safe_stem(re.sub("([_-])[_-]*_+", r"\1", filled).strip("_")) + suffix  # an order may have no side


def free_name(folder: Path, template: str, values: DraftValues, suffix: str, today: date, *, with_code: bool = False) -> Path:
    """The path with the first revision that is not taken; without ``{rev}`` simply the name."""
    revision = 1
    path = folder / file_name(template, values, revision, suffix, today, with_code=with_code)
    while "{rev}" in template and path.exists():
        revision += 1
        path = folder / file_name(template, values, revision, suffix, today, with_code=with_code)
    return path


def unknown_fields(template: str) -> list[str]:
    """What stands in braces in a template and is no field, in its order."""
    return [name for name in dict.fromkeys(_BRACES.findall(template)) if name not in FIELDS]


def names_the_patient(template: str) -> bool:
    return PATIENT in _BRACES.findall(template)


def safe_stem(text: str) -> str:
    """The text as a file's name on every system."""
    return re.sub(r"[^\w.+-]+", "-", text).strip("-. ")[:120] or "case"
