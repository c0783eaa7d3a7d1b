"""What was seen at one trigger id: two centroids, the table's angle and the verdict."""

from __future__ import annotations

from dataclasses import dataclass, fields

import numpy as np
from numpy.typing import NDArray

from scanner_core.optics.spot import Spot

MEASURED = "measured"
LINE_FRAME = "line"
"""Of a frame of the laser line: its places have verdicts of their own."""


@dataclass(frozen=True, slots=True)
class StereoObservation:
    """One planned measurement that was exposed.

    Attributes
    ----------
    verdict : ``measured``, or the reason of the rejection
    time_s : on the rig's clock
    table_deg : as read back from the controller
    left, right : the spots, None where a camera saw none
    """

    trigger_id: int
    view: int
    verdict: str
    time_s: float
    table_deg: float
    left: Spot | None
    right: Spot | None


@dataclass(frozen=True, slots=True, eq=False)
class ObservationTable:
    """The measured observations of a scan as arrays in the order of their trigger ids; all (n,) or (n, 2).

    The uncertainties are those of the detector, rms over x and y; the sigmas are the spots' sizes.
    """

    trigger_id: NDArray[np.int64]
    view: NDArray[np.int32]
    table_deg: NDArray[np.float64]
    left_px: NDArray[np.float64]
    right_px: NDArray[np.float64]
    left_uncertainty_px: NDArray[np.float64]
    right_uncertainty_px: NDArray[np.float64]
    left_sigma_px: NDArray[np.float64]
    right_sigma_px: NDArray[np.float64]

    def __len__(self) -> int:
        return len(self.trigger_id)

    def select(self, which: NDArray[np.bool_]) -> ObservationTable:
        """The rows of a mask (n,)."""
        return ObservationTable(*(getattr(self, column.name)[which] for column in fields(self)))


@dataclass(frozen=True, slots=True, eq=False)
class PairTable:
    """What both cameras saw as one spot each, whatever became of it, in the order of the trigger ids.

    Attributes
    ----------
    verdict : (n,) of strings
    peak_dn : (n, 2) brightest pixel of the left and the right spot
    """

    observations: ObservationTable
    verdict: NDArray[np.object_]
    peak_dn: NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class ExposureTable:
    """All exposures of a scan, whatever became of them, in the order of their trigger ids.

    Attributes
    ----------
    trigger_id, table_deg : (n,)
    verdict : (n,) of strings
    left_px, right_px : (n, 2) centroids, NaN where a camera saw no spot
    """

    trigger_id: NDArray[np.int64]
    table_deg: NDArray[np.float64]
    verdict: NDArray[np.object_]
    left_px: NDArray[np.float64]
    right_px: NDArray[np.float64]

    def select(self, which: NDArray[np.bool_]) -> ExposureTable:
        """The rows of a mask (n,)."""
        return ExposureTable(*(getattr(self, column.name)[which] for column in fields(self)))
