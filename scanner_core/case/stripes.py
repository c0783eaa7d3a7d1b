"""Many points of one frame: the places of a laser line, each with its verdict, beside the observations of their frames."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import chain
from typing import Any

import numpy as np
from numpy.typing import NDArray

from scanner_core.case.database import CaseDatabase
from scanner_core.case.decoding import MOST_ID, damaged
from scanner_core.case.observation import MEASURED, StereoObservation
from scanner_core.case.scans import insert_observations, verdict_ids
from scanner_core.optics.stripe_pairs import StripePairs

_INSERT = "INSERT INTO stripe_point VALUES (" + ",".join("?" * 12) + ")"
_FARTHEST_PX = 1e5
_BOUNDS = np.array([(0, MOST_ID), (0, 359), (-1e6, 1e6), *[(-_FARTHEST_PX, _FARTHEST_PX)] * 4, (0, 3), (0, 1e12), (0, 1e12), (-7, 7), (0, 2**20 - 1)])
_COLUMNS = ("trigger id", "view", "table angle", *["place"] * 4, "kind of peak", *["uncertainty"] * 2, "direction", "number")


@dataclass(frozen=True, slots=True, eq=False)
class StripeTable:
    """The measured places of a scan's laser line, n of them, in the order of their trigger ids.

    Attributes
    ----------
    trigger_id, view, table_deg : (n,), several of one trigger id
    place : (n,) number of the peak in its frame; with the trigger id it names a point
    pairs : where both images show them
    """

    trigger_id: NDArray[np.int64]
    view: NDArray[np.int32]
    table_deg: NDArray[np.float64]
    place: NDArray[np.int32]
    pairs: StripePairs

    def __len__(self) -> int:
        return len(self.trigger_id)

    def select(self, which: NDArray[np.bool_]) -> StripeTable:
        """The rows of a mask (n,)."""
        return StripeTable(self.trigger_id[which], self.view[which], self.table_deg[which], self.place[which], self.pairs.select(which))


@dataclass(frozen=True, slots=True, eq=False)
class MeasuredPlaces:
    """Places of the line that gave points: (n,) trigger ids, (n,) numbers of their peaks in the frame, and where both images show them."""

    trigger_id: NDArray[np.int64]
    number: NDArray[np.int64]
    pairs: StripePairs


@dataclass(frozen=True, slots=True, eq=False)
class RejectedPlaces:
    """Places of the line that gave none, n of one image: trigger ids, numbers of the peaks in the frame, which image, (n, 2) px, reasons."""

    trigger_id: NDArray[np.int64]
    number: NDArray[np.int64]
    in_right: NDArray[np.bool_]
    xy: NDArray[np.float64]
    verdict: NDArray[np.object_]


class StripeTables(CaseDatabase):
    """The part of a case that a laser line fills.  Nothing in it is ever changed or deleted."""

    def append_line(self, scan_id: int, frames: Sequence[StereoObservation], measured: MeasuredPlaces, rejected: RejectedPlaces) -> None:
        """Keep frames with all that they hold, in one transaction; once this returns it survives the death of the program and of the machine."""
        pairs = measured.pairs
        peak = pairs.by_right.astype(np.int64) + 2 * ~pairs.along_row
        left, right, lost = pairs.left_px.tolist(), pairs.right_px.tolist(), rejected.xy.tolist()
        numbers = [np.rint(1e6 * sigma).astype(np.int64).tolist() for sigma in (pairs.own_px, pairs.other_px)]
        with self._transaction() as connection:
            verdicts = verdict_ids(connection, (MEASURED, *rejected.verdict.tolist()))
            insert_observations(connection, scan_id, frames)
            of, number, tangent = measured.trigger_id.tolist(), measured.number.tolist(), pairs.tangent_rad.tolist()
            good = (
                (scan_id, frame, n, verdicts[MEASURED], *a, *b, *rest)
                for frame, n, a, b, *rest in zip(of, number, left, right, peak.tolist(), *numbers, tangent, strict=True)
            )
            of_lost, reasons, in_right = rejected.trigger_id.tolist(), rejected.verdict.tolist(), rejected.in_right.tolist()
            bad = (
                (scan_id, frame, n, verdicts[reason], *((None, None, *xy) if right else (*xy, None, None)), int(right), None, None, None)
                for frame, n, reason, xy, right in zip(of_lost, rejected.number.tolist(), reasons, lost, in_right, strict=True)
            )
            connection.executemany(_INSERT, chain(good, bad))

    def by_line(self, scan_id: int) -> bool:
        """Whether a scan holds places of a laser line."""
        return bool(self._rows("SELECT 1 FROM stripe_point WHERE scan_id = ? LIMIT 1", (scan_id,)))

    def stripe_points(self, scan_id: int) -> StripeTable:
        """The measured places of a scan in the order of their trigger ids."""
        rows = self._rows(
            "SELECT p.trigger_id, view, table_deg, p.left_x_px, p.left_y_px, p.right_x_px, p.right_y_px, "
            "peak, peak_u_upx, other_u_upx, tangent_rad, p.number "
            "FROM stripe_point p JOIN observation o ON o.trigger_id = p.trigger_id "
            "WHERE p.scan_id = ? AND p.verdict = (SELECT id FROM verdict WHERE name = ?) ORDER BY p.trigger_id, p.number",
            (scan_id, MEASURED),
        )
        with damaged(self.path, "list of the line's places"):
            return _table(rows)


def _table(rows: Sequence[tuple[Any, ...]]) -> StripeTable:
    numbers = np.array(rows, np.float64).reshape(-1, len(_COLUMNS))
    wrong = ~((numbers >= _BOUNDS[:, 0]) & (numbers <= _BOUNDS[:, 1]))
    if wrong.any():
        row, column = np.argwhere(wrong)[0]
        raise ValueError(f"a {_COLUMNS[column]} of {numbers[row, column]:g} in row {row + 1}")
    peak = numbers[:, 7].astype(np.int64)
    pairs = StripePairs(
        left_px=numbers[:, 3:5].copy(),
        right_px=numbers[:, 5:7].copy(),
        by_right=(peak & 1) == 1,
        along_row=(peak & 2) == 0,
        own_px=numbers[:, 8] * 1e-6,
        other_px=numbers[:, 9] * 1e-6,
        tangent_rad=numbers[:, 10].copy(),
    )
    return StripeTable(numbers[:, 0].astype(np.int64), numbers[:, 1].astype(np.int32), numbers[:, 2].copy(), numbers[:, 11].astype(np.int32), pairs)
