"""The other ear of an order, and whether the two can be a pair."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from scanner_core.case.glance import glance, look_into
from scanner_core.case.records import Order
from scanner_core.case.store import SUFFIX
from scanner_core.delivery.check import Check, CheckVerdict
from scanner_core.delivery.side import DECIDED, SideFit, SideMatch, match_sides
from scanner_core.errors import ImprontaError
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.jobs.progress import Cancelled, IsCancelled, OnProgress

EAR, _ARCH = "ear", "arch"
JAWS = ("upper", "lower")
_MOST = 400
"""Cases of a folder that are looked into, the newest first: of one order they were made within days."""


@dataclass(frozen=True, slots=True, eq=False)
class OtherEar:
    """Another case of the same order: its file, the side that it is labelled with, and its surface."""

    path: Path
    side: str
    mesh: TriangleMesh


def find_other_ear(path: Path, order: Order, cancelled: IsCancelled = lambda: False) -> OtherEar | None:
    """The newest ear with the same order number in the folder of a case, one labelled with the other side before one of the same.

    Cases that are open elsewhere, damaged, or without a surface are passed over.

    Parameters
    ----------
    path : of the case itself

    Raises
    ------
    Cancelled
    """
    if order.type != EAR or not order.number:
        return None
    same: OtherEar | None = None
    for place in _newest_cases(path):
        if cancelled():
            raise Cancelled
        found = _ear_of(place, order)
        if found is None:
            continue
        if found.side != order.side:
            return found
        same = same or found
    return same


def check_side(
    order: Order, mesh: TriangleMesh, other: OtherEar | None, *, progress: OnProgress = lambda _: None, cancelled: IsCancelled = lambda: False
) -> Check:
    """Whether a surface is what its label says, as far as the other ear can tell; `Cancelled`."""
    if order.type.startswith(_ARCH) and order.side not in JAWS:
        return Check("side", CheckVerdict.WARN, "side.jaw")
    if order.type != EAR:
        return Check("side", CheckVerdict.OPEN, "side.open")
    if order.side not in ("left", "right"):
        return Check("side", CheckVerdict.WARN, "side.missing")
    if other is None:
        return Check("side", CheckVerdict.OPEN, "side.alone")
    return judged_sides(order.side, other.side, match_sides(mesh, other.mesh, progress=progress, cancelled=cancelled))


def judged_sides(side: str, other_side: str, match: SideMatch) -> Check:
    """What a match says of two labels, left or right."""
    fields: dict[str, object] = {"mirrored_um": f"{match.mirrored_um:.0f}", "direct_um": f"{match.direct_um:.0f}", "side": side}
    value = match.mirrored_um / max(match.direct_um, 1e-9)
    if side == other_side:
        if match.fit is SideFit.MIRRORED:
            return Check("side", CheckVerdict.FAIL, "side.same", fields, value, "", DECIDED)
        return Check("side", CheckVerdict.OPEN, "side.alone")  # the same ear once more
    verdict, code = {
        SideFit.MIRRORED: (CheckVerdict.PASS, "side.pass"),
        SideFit.DIRECT: (CheckVerdict.FAIL, "side.fail"),
        SideFit.UNDECIDED: (CheckVerdict.WARN, "side.undecided"),
    }[match.fit]
    return Check("side", verdict, code, fields, value, "", DECIDED)


def _newest_cases(path: Path) -> list[Path]:
    try:
        beside = [place for place in path.parent.iterdir() if place.suffix == SUFFIX and place != path and not place.name.startswith(".")]
        return sorted(beside, key=lambda place: place.stat().st_mtime, reverse=True)[:_MOST]
    except OSError:
        return []


def _ear_of(place: Path, order: Order) -> OtherEar | None:
    told = glance(place)
    found = told.order
    if told.mesh is None or found.number != order.number or found.type != EAR or found.side not in ("left", "right"):
        return None
    try:
        with look_into(place) as store:
            return OtherEar(place, found.side, store.mesh()[0])
    except (ImprontaError, OSError):
        return None
