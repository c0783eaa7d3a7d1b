"""A large cloud in chunks that are drawn one after the other into the picture that is there."""

from __future__ import annotations

from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkRenderingCore import vtkProperty, vtkRenderer, vtkShaderProperty

from app.views.cloud_buffer import CloudBuffer
from app.views.cloud_points import CloudPoints, Floats
from app.views.point_colour import PointColour

CHUNK = 10_000
"""Most points of a chunk; a slice of the picture draws one or several."""
AIM_S = 0.04
"""A slice should take about so long ..."""
MOST = 6
"""... and never holds more chunks than this."""


class CloudChunks:
    """Chunks of points that together are the whole cloud."""

    def __init__(self, lookup: vtkLookupTable, look: vtkProperty, shader: vtkShaderProperty) -> None:
        self._lookup, self._look, self._shader = lookup, look, shader
        self._renderer: vtkRenderer | None = None
        self._chunks: list[CloudBuffer] = []
        self._done = 0
        self._at_once = 1
        self.count = 0
        """Points in all chunks."""

    def put_into(self, renderer: vtkRenderer) -> None:
        """Where they are drawn; none of them is visible but in its slice of the picture."""
        self._renderer = renderer

    @property
    def pending(self) -> bool:
        """Some of them are not in the picture yet."""
        return self._done < len(self._chunks)

    def clear(self) -> None:
        if self._renderer is not None:
            for chunk in self._chunks:
                self._renderer.RemoveActor(chunk.actor)
        self._chunks, self._done, self.count = [], 0, 0

    def add(self, points: CloudPoints, normals: Floats) -> None:
        chunk = CloudBuffer(len(points), self._lookup, self._look, self._shader)
        chunk.append(points, normals)
        chunk.actor.SetVisibility(False)
        if self._renderer is not None:
            self._renderer.AddActor(chunk.actor)
        self._chunks.append(chunk)
        self.count += len(points)

    def restart(self) -> None:
        """The picture holds none of them."""
        self._done = 0

    def show_next(self, by: PointColour) -> None:
        """Have the next slice of the picture draw some more."""
        for chunk in self._chunks[self._done : self._done + self._at_once]:
            chunk.colour(by, True)
            chunk.actor.SetVisibility(True)

    def hide(self, seconds: float) -> None:
        """They are drawn, which took so long: the next slice draws more or fewer."""
        for chunk in self._chunks[self._done : self._done + self._at_once]:
            chunk.actor.SetVisibility(False)
        self._done += self._at_once
        if seconds > 1.2 * AIM_S:
            self._at_once = max(1, self._at_once - 1)
        elif seconds < 0.7 * AIM_S:
            self._at_once = min(MOST, self._at_once + 1)
