"""The point cloud as VTK draws it: at most 60,000 points while anything moves, the rest chunk by chunk once nothing does."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkRenderingCore import vtkActor, vtkProperty, vtkShaderProperty

from app.palettes import DARK, LIGHT
from app.views.cloud_buffer import CloudBuffer
from app.views.cloud_chunks import CloudChunks
from app.views.cloud_points import CloudPoints, Floats
from app.views.cloud_store import CloudStore, StoredPart, every
from app.views.colour_maps import MAPS, MISSING
from app.views.point_colour import PointColour
from app.views.points_shader import install, put_ground
from app.views.surface_colours import rgb
from app.views.value_range import ValueRange
from app.views.vtk_arrays import copied
from scanner_core.geometry.point_cloud import PointCloud

LIVE_LIMIT = 60_000
"""Points drawn while the cloud grows."""
MOVING_LIMIT = 30_000
"""Points drawn while the camera moves."""
POINT_SIZES = ((2_500, 6.0), (8_000, 5.0), (60_000, 4.0), (10**9, 3.0))
"""Most points, and their size on the screen."""

FirstNormals = Callable[[Floats, Floats], Floats]
"""What is known of normals at points (n, 3) mm that were seen from (n, 3) unit vectors."""


def _towards(points: Floats, towards: Floats) -> Floats:
    return towards


class CloudActor:
    """Points coloured by what a person chose and lit by their normals.

    The live buffer never holds more than ``LIVE_LIMIT`` points: when it is full every second one is dropped, and from
    then on only every second new one is taken, and so on.  Rows come coarse to fine, so the thinned cloud stays even.
    """

    def __init__(self) -> None:
        self._store = CloudStore()
        self._lookup = vtkLookupTable()
        self._look = vtkProperty()
        self._look.SetRepresentationToPoints()
        self._shader = vtkShaderProperty()
        install(self._shader)
        self._live = CloudBuffer(LIVE_LIMIT, self._lookup, self._look, self._shader)
        self.chunks = CloudChunks(self._lookup, self._look, self._shader)
        """The whole cloud, where it is more than the live buffer holds."""
        self.stride = 1
        """Every so many-th point is in the live buffer."""
        self._quiet = self._moving = self._growing = False
        self._by = PointColour.HEIGHT
        self._dark = True
        self.generation = 0
        """Changes whenever points that were there go away; stale answers are told by it."""
        self.first_normals: FirstNormals = _towards
        self._corners = np.array([[np.inf] * 3, [-np.inf] * 3])
        self.range = ValueRange()
        self.views = 0
        """How many views have points."""
        self.in_seconds = True
        """Whether the age of the points is known in seconds, or only their order."""
        self.actor: vtkActor = self._live.actor
        self.restyle(dark=True)

    def __len__(self) -> int:
        return self._store.count

    @property
    def bounds_mm(self) -> NDArray[np.float64] | None:
        """(2, 3) lowest and highest corner, or None without points."""
        return self._corners if len(self) else None

    @property
    def drawn(self) -> int:
        """Number of points that the picture holds once it is complete."""
        return self._live.drawn if self._moving or self._growing else max(self._live.drawn, self.chunks.count)

    @property
    def by(self) -> PointColour:
        return self._by

    def clear(self) -> None:
        self._store.clear()
        self.stride, self.views = 1, 0
        self._live.clear()
        self.chunks.clear()
        self.generation += 1
        self._corners = np.array([[np.inf] * 3, [-np.inf] * 3])
        self.range = ValueRange()
        self.first_normals = _towards

    def append(self, points: CloudPoints) -> None:
        """Add points that were just measured."""
        if len(points):
            start = len(self)
            self._store.append(points)
            self.in_seconds = True
            self._take(start, points.points, lambda first, stride: points.rows(slice(first, None, stride)))

    def hold(self, cloud: PointCloud) -> None:
        """Add all points of a case at once; those that the live buffer does not take are converted in other threads."""
        if len(cloud):
            start = len(self)
            self._store.hold(cloud)
            self.in_seconds = False
            if cloud.views is not None:
                self.see_views(cloud.views)
            self._take(start, cloud.points, lambda first, stride: CloudPoints.of_case(cloud, slice(first, len(cloud), stride)))

    def see_views(self, views: NDArray[np.int32]) -> None:
        """Points of views with these numbers have come."""
        if len(views):
            self.views = max(self.views, int(views.max()) + 1)

    def parts(self) -> tuple[StoredPart, ...]:
        """All points; they may be read in another thread."""
        return self._store.parts()

    def live_points(self) -> tuple[Floats, Floats]:
        """Copies of the points in the live buffer, (m, 3) mm, and of the directions to where they were seen from."""
        live = every(self._store.parts(), 0, self.stride)
        return live.points, live.towards

    def light_live(self, normals: Floats, density: Floats, generation: int) -> None:
        """Normals (m, 3) and points / mm2 (m,) of the first m live points, unless the buffer was thinned meanwhile."""
        if generation == self.generation:
            self._live.light(normals)
            self._live.put(PointColour.DENSITY, density)
            self.range.forget()

    def take_chunk(self, points: CloudPoints, normals: Floats, generation: int, *, first: bool) -> None:
        """Some more of the whole cloud, unless points went away meanwhile."""
        if generation == self.generation:
            if first:
                self.chunks.clear()
            self.chunks.add(points, normals)

    # -------------------------------------------------------------------------------- how it looks
    def restyle(self, *, dark: bool) -> None:
        """The ground is dark, or light."""
        self._dark = dark
        self._lookup.SetTable(copied(MAPS[self._by].table(dark)))
        red, green, blue = (channel / 255 for channel in rgb(MISSING[dark]))
        self._lookup.SetNanColor(red, green, blue, 1.0)
        self._look.SetColor(red, green, blue)
        palette = DARK if dark else LIGHT
        low, high = (np.array(rgb(colour)) / 255 for colour in (palette.scene_low, palette.scene_high))
        red, green, blue = 0.5 * (low + high)
        put_ground(self._shader, (red, green, blue))
        self.prepare(1.0)

    def colour_by(self, by: PointColour) -> None:
        self._by = by
        self.restyle(dark=self._dark)

    def prepare(self, pixel_ratio: float) -> None:
        """Before a picture: the range of what is coloured, and larger points while they are few, so that the surface closes to the eye."""
        if self._by is PointColour.VIEW:
            self._lookup.SetTableRange(-0.5, len(MAPS[self._by].on_dark) - 0.5)
        else:
            self._lookup.SetTableRange(*self.shown_range())
        size = next(size for most, size in POINT_SIZES if self.drawn <= most)
        self._look.SetPointSize(pixel_ratio * (2.0 if self._quiet else size))
        self._live.colour(self._by, not self._quiet)

    def shown_range(self) -> tuple[float, float]:
        """What the ends of the colour map stand for."""
        if self._by is PointColour.HEIGHT:
            low, high = self._corners[:, 2].tolist() if len(self) else (0.0, 1.0)
            return low, max(high, low + 1e-3)
        return self.range.of(self._by, self._live.rows)

    def quiet(self, on: bool) -> None:
        """Small and grey: the surface that grows among the points is what matters."""
        self._quiet = on

    def grow(self, on: bool) -> None:
        """More points come: the whole cloud is not worth drawing."""
        self._growing = on

    def thin_for_motion(self, moving: bool) -> None:
        """Fewer points while the camera moves."""
        self._moving = moving
        self._live.thin(-(-self._live.count // MOVING_LIMIT) if moving else 1)

    # -------------------------------------------------------------------------------- inside
    def _take(self, start: int, points: NDArray[np.generic], rows: Callable[[int, int], CloudPoints]) -> None:
        self._corners[0] = np.minimum(self._corners[0], points.min(axis=0))
        self._corners[1] = np.maximum(self._corners[1], points.max(axis=0))
        first, new = -start % self.stride, len(points)
        while self._live.count + len(range(first, new, self.stride)) > LIVE_LIMIT:
            self._live.halve()
            self.stride *= 2
            self.generation += 1
            first = -start % self.stride
        taken = rows(first, self.stride)
        self._live.append(taken, self.first_normals(taken.points, taken.towards))
        self.chunks.clear()
