"""What delivered files are called: a template with fields in braces, filled in so that it is a name on every system."""

from __future__ import annotations

import re
from collections.abc import Sequence
from datetime import date
from pathlib import Path

from scanner_core.case.records import Order
from scanner_core.errors import UsageError

FIELDS = ("order", "side", "type", "date", "rev", "code")
"""What may stand in braces in a template; ``code`` is the patient's code, never a name."""
DEFAULT_TEMPLATE = "{order}_{side}_{type}_{date}-{rev}"
_MOST_REVISIONS = 9999


def safe_stem(text: str) -> str:
    """The text as a file's name on every system."""
    return re.sub(r"[^\w.+-]+", "-", text).strip("-. ")[:120] or "case"


def file_stem(template: str, order: Order, revision: int, today: date) -> str:
    """The template filled in, without a suffix; unknown braces stay as they are, an order without a side has none in its name."""
    known = {
        "order": order.number or "order",
        "side": order.side,
        "type": order.type,
        "date": today.isoformat(),
        "rev": str(revision),
        "code": order.patient_code or "code",
    }
    filled = re.sub(r"\{(\w+)\}", lambda found: known.get(found[1], found[0]), template)
    return safe_stem(re.sub("__+", "_", filled))


def free_stem(folder: Path, template: str, order: Order, suffixes: Sequence[str], today: date) -> str:
    """The stem with the first revision of which no file is there; without ``{rev}`` simply the stem.

    Raises
    ------
    UsageError
        E-USE-01 when ten thousand revisions are there.
    """
    revision = 1
    stem = file_stem(template, order, revision, today)
    while "{rev}" in template and any(folder.joinpath(stem + suffix).exists() for suffix in suffixes):
        revision += 1
        if revision > _MOST_REVISIONS:
            raise UsageError("E-USE-01", what=f"There are {_MOST_REVISIONS} revisions of this file", do="choose another folder")
        stem = file_stem(template, order, revision, today)
    return stem
