"""One run of a pair tray, both ears on one table, becomes a case for each ear.

Which ear a point belongs to is told by the seat that it is over, and only where the two impressions stand clear of each
other: when something lies between the seats, or a seat holds next to nothing, nothing is split (E-TRAY-01, E-TRAY-02), and
the run stays one case that can be split after its points were edited.

A split copies the case and takes the points of the other ear out (:class:`~scanner_core.case.removed_points.RemovedPoints`),
so each of the two holds everything that was measured, can be reprocessed alone, and undoing that one edit brings the other
ear back.  The copies are written first: whenever it is interrupted, the run itself is as it was.
"""

from __future__ import annotations

from dataclasses import asdict, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from scanner_core.case.edits import ORDER, PROCESSING
from scanner_core.case.processing import chosen_processing, process_case
from scanner_core.case.removed_points import RemovedPoints
from scanner_core.case.store import CaseStore
from scanner_core.devices.pair_tray import PAIR_TRAY, PairTray, Side
from scanner_core.errors import CaseError, StorageError
from scanner_core.files import replaced_when_whole
from scanner_core.geometry.point_cloud import PointCloud

SIDES: tuple[Side, Side] = ("left", "right")
WORDS = "Split the pair tray"
"""Of the edit, in the menu and in the audit trail."""


def split_pair(store: CaseStore, paths: dict[Side, Path], tray: PairTray = PAIR_TRAY) -> dict[Side, int]:
    """Make the run of a pair tray into a case for each ear; the number of points of each.

    Parameters
    ----------
    store : the case of the run, open for writing
    paths : where the cases of the ears go; one of them may be the run's own, which is then edited; another that exists is
        replaced only while it is the case of an order for which nothing was measured yet

    Raises
    ------
    CaseError
        E-TRAY-01, E-TRAY-02, E-CASE-05 without points.
    StorageError, CaseLockedError
        E-DISK-03 a case with a scan is there, E-DISK-01, E-DISK-02; E-CASE-02 it is open.
    """
    processed = process_case(store, chosen_processing(store))
    seats = seats_of(processed.cloud, tray, store.path)
    order = store.order()
    own = [side for side in SIDES if paths[side] == store.path]
    for side in SIDES:
        if side not in own:
            _check_free(paths[side])
    for side in [*(side for side in SIDES if side not in own), *own]:
        taken_out = RemovedPoints.of_cloud(processed.cloud.select(~seats[side]))
        earlier = chosen_processing(store).removed.pairs()
        pairs = np.concatenate([earlier, taken_out.pairs()])
        choice = replace(chosen_processing(store), removed=RemovedPoints.of(pairs[:, 0], pairs[:, 1]))
        if side in own:
            _give(store, side, choice.as_dict(), asdict(order))
        else:
            with replaced_when_whole(paths[side], force=True) as partial:
                store.copy_to(partial)
                with CaseStore.open(partial) as copy:
                    _give(copy, side, choice.as_dict(), asdict(order))
    return {side: int(seats[side].sum()) for side in SIDES}


def seats_of(cloud: PointCloud, tray: PairTray, path: Path) -> dict[Side, NDArray[np.bool_]]:
    """Which points (n,) stand on the seat of each ear, object frame.

    Raises
    ------
    CaseError
        E-TRAY-01 when points lie between the seats, E-TRAY-02 when a seat is empty.
    """
    first, second = (np.array([seat.x_mm, seat.y_mm]) for seat in tray.seats)
    way = (second - first) / np.linalg.norm(second - first)
    along = (cloud.points[:, :2] - 0.5 * (first + second)) @ way
    between = int((np.abs(along) < 0.5 * tray.clear_mm).sum())
    if between:
        raise CaseError("E-TRAY-01", path=path, count=between)
    seats = {tray.seats[0].side: along < 0, tray.seats[1].side: along > 0}
    for side, held in seats.items():
        if held.mean() < tray.least_share:
            raise CaseError("E-TRAY-02", path=path, side=side, count=int(held.sum()))
    return seats


def _give(store: CaseStore, side: Side, processing: object, order: dict[str, object]) -> None:
    store.audit("split", f"{side} ear of a pair tray")
    store.edit(ORDER, order | {"side": side}, "Change side")
    store.edit(PROCESSING, processing, WORDS)


def _check_free(path: Path) -> None:
    """Only the case of an order that waits for its scan may give way."""
    if not path.exists():
        return
    with CaseStore.open(path) as there:
        if there.scans():
            raise StorageError("E-DISK-03", path=path)
