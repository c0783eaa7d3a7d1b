"""Points as they are drawn: single precision, with a value for every way to colour them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.views.colour_maps import MAPS
from app.views.point_colour import PointColour
from scanner_core.acquisition.live_points import LivePoints, standard_uncertainty_um
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.geometry.view_directions import outward, seen_from

Floats = NDArray[np.float32]
VIEW_COLOURS = len(MAPS[PointColour.VIEW].on_dark)
_VALUES = len(PointColour)
_COLUMN = {by: i for i, by in enumerate(PointColour)}


@dataclass(frozen=True, slots=True, eq=False)
class CloudPoints:
    """n points.

    Attributes
    ----------
    points : (n, 3) mm, object frame
    towards : (n, 3) unit vectors to where they were seen from
    values : (6, n) by what they are coloured, in the order of :class:`PointColour`: mm, place in the cycle of the views'
        colours, standard deviations, um, points / mm2, and seconds or a number in the order of measurement; NaN where not known
    """

    points: Floats
    towards: Floats
    values: Floats

    @classmethod
    def plain(cls, points: NDArray[np.float64], towards: NDArray[np.float64]) -> CloudPoints:
        """Points (n, 3) of which nothing more is known."""
        values = np.full((_VALUES, len(points)), np.nan, np.float32)
        values[_COLUMN[PointColour.HEIGHT]] = points[:, 2]
        return cls(points.astype(np.float32), np.asarray(towards, np.float32), values)

    @classmethod
    def of_scan(cls, live: LivePoints, seconds: float) -> CloudPoints:
        """Points that a scan has just measured."""
        made = cls.plain(live.points, seen_from(live.table_deg))
        made.put(PointColour.VIEW, live.views % VIEW_COLOURS)
        made.put(PointColour.RESIDUAL, np.abs(live.epipolar_sigmas))
        made.put(PointColour.UNCERTAINTY, live.uncertainty_um)
        made.put(PointColour.AGE, seconds)
        return made

    @classmethod
    def of_case(cls, cloud: PointCloud, rows: slice) -> CloudPoints:
        """Those rows of a cloud that was computed from a case or read from a file."""
        part = cloud.select(np.arange(*rows.indices(len(cloud))))
        made = cls.plain(part.points, outward(part.points) if part.table_deg is None else seen_from(part.table_deg))
        if part.views is not None:
            made.put(PointColour.VIEW, part.views % VIEW_COLOURS)
        if part.epipolar_sigmas is not None:
            made.put(PointColour.RESIDUAL, np.abs(part.epipolar_sigmas))
        if part.covariances is not None:
            made.put(PointColour.UNCERTAINTY, standard_uncertainty_um(part.covariances))
        if part.trigger_ids is not None:
            made.put(PointColour.AGE, np.arange(*rows.indices(len(cloud))))
        return made

    @classmethod
    def joined(cls, parts: Sequence[CloudPoints]) -> CloudPoints:
        """All of several."""
        if not parts:
            return cls.plain(np.empty((0, 3)), np.empty((0, 3)))
        return cls(
            np.concatenate([part.points for part in parts]),
            np.concatenate([part.towards for part in parts]),
            np.concatenate([part.values for part in parts], axis=1),
        )

    def __len__(self) -> int:
        return len(self.points)

    def rows(self, which: slice) -> CloudPoints:
        return CloudPoints(self.points[which], self.towards[which], self.values[:, which])

    def copy(self) -> CloudPoints:
        return CloudPoints(self.points.copy(), self.towards.copy(), self.values.copy())

    def put(self, by: PointColour, values: NDArray[np.generic] | float) -> None:
        self.values[_COLUMN[by]] = values

    def of(self, by: PointColour) -> Floats:
        """(n,)"""
        values: Floats = self.values[_COLUMN[by]]
        return values
