"""What a page shows in the 3D view in the place of the open case's points and surface."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from app.views.point_slices import PointSlices

Array = NDArray[np.float64]


class Aside(Protocol):
    """Made when the 3D view is there."""

    @property
    def actors(self) -> Sequence[Any]:
        """As VTK has them."""

    @property
    def bounds_mm(self) -> Array | None:
        """(2, 3) lowest and highest corner, or None while it is empty."""

    @property
    def range_um(self) -> tuple[float, float] | None:
        """What the ends of the uncertainty's colours mean; None when it is not shown."""

    @property
    def slices(self) -> PointSlices | None:
        """Points that are drawn after the others, when nothing moves."""

    def fit_pixels(self, ratio: float) -> None:
        """Points and lines as large as they shall look, with so many pixels of the screen to one of the window."""
