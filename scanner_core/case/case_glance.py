"""A case in a list of orders; :mod:`scanner_core.case.glance` reads it."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from pathlib import Path

from scanner_core.case.records import Order


class OrderState(Enum):
    """How far the work on an order has come."""

    NEW = "new"
    INTERRUPTED = "interrupted"
    SCANNED = "scanned"
    RECONSTRUCTED = "reconstructed"
    DELIVERED = "delivered"


class Trouble(Enum):
    """Why a case cannot be looked into."""

    OPEN = "open elsewhere"
    NEWER = "newer"
    DAMAGED = "damaged"
    UNREADABLE = "unreadable"


@dataclass(frozen=True, slots=True)
class CaseGlance:
    """One line of a list of orders.

    Attributes
    ----------
    state : None where there is a trouble
    created, changed : ISO 8601 date and time, of the case's own audit trail; of the file where there is a trouble
    points : measured, of the scans that count
    mesh : id of the surface that the case shows; None without one
    """

    path: Path
    order: Order
    state: OrderState | None
    created: str
    changed: str
    points: int = 0
    mesh: int | None = None
    trouble: Trouble | None = None
