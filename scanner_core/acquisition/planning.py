"""From a request to a plan: first a coarse look at where the object is, then rows that cover it and nothing else.

The coarse pass (the *locating* plan) sweeps the whole cylinder that may hold the object with a few rows.  Its hits say
for every view which part of the raster meets the object; the scan plan covers that part, one coarse step wider, with
the step that gives the wanted number of points.  Light is not spent on the empty table, and both planned counts and
the time left are honest.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.aiming import beam_angles, cylinder_outline, row_range
from scanner_core.acquisition.plan import COARSE_TO_FINE, PlanRequest, Row, ScanPlan, ViewPlan
from scanner_core.devices.rig import LimitsConfig, RigConfig

Span = tuple[float, float, float]
"""A part of a row: y, x low, x high in degrees."""

COARSE_SHARE = 1 / 3
"""Of the points, for the first pass of an error-driven scan ..."""
COARSE_VIEWS = 8
"""... from so many angles at most ..."""
COARSE_LEAST = 4
"""... and at least: from fewer no body is closed."""

CLOSING_POINTS = 250
"""Points of the first view that are measured again after the turn; coarse to fine, so they lie all over it."""
_SPARE = 1.06
"""Planned over wanted points, beside the uncertainty of the located area, so that the quotas are reached."""


@dataclass(frozen=True, slots=True)
class _Raster:
    """The coarse raster of every view: rows and columns in degrees."""

    y_deg: NDArray[np.float64]
    step_deg: float
    ranges: tuple[tuple[float, float], ...]


def table_angles_deg(views: int) -> list[float]:
    """Evenly spread over the turn."""
    return [360.0 * view / views for view in range(views)]


def nearest_turn(table_deg: float, from_deg: float, allowed: Callable[[float], bool]) -> float:
    """The same place of the table by the shortest way from where it stands, forwards where both are as long; as it is where none is allowed."""
    near = table_deg + 360.0 * round((from_deg - table_deg) / 360.0)
    turns = sorted((near + turn for turn in (-360.0, 0.0, 360.0)), key=lambda to_deg: (round(abs(to_deg - from_deg), 6), -to_deg))
    return next((to_deg for to_deg in turns if allowed(to_deg)), table_deg)


def turned(views: Sequence[ViewPlan], from_deg: float, allowed: Callable[[float], bool]) -> tuple[ViewPlan, ...]:
    """The same views, each by the shortest way from the one before it; the first from there."""
    found = []
    for view in views:
        from_deg = nearest_turn(view.table_deg, from_deg, allowed)
        found.append(replace(view, table_deg=from_deg))
    return tuple(found)


def may_stand(limits: LimitsConfig, table_deg: float) -> bool:
    """Whether a table that may not turn on for ever comes to this place in some turn."""
    if limits.table_deg is None:
        return True
    low, high = limits.table_deg
    return table_deg + 360.0 * float(np.ceil((low - table_deg) / 360.0 - 1e-9)) <= high + 1e-9


def renumbered(views: Sequence[ViewPlan], first_view: int) -> tuple[ViewPlan, ...]:
    """The same views, counted from there on."""
    return tuple(replace(view, rows=tuple(replace(row, view=number) for row in view.rows)) for number, view in enumerate(views, first_view))


def locating_plan(rig: RigConfig, request: PlanRequest, rate_hz: float, first_id: int = 0) -> ScanPlan:
    """The coarse pass over the cylinder that may hold the object; `rate_hz` is the cameras' frame rate."""
    raster = _coarse_raster(rig, request, rate_hz)
    views, next_id = [], first_id
    for view, table_deg in enumerate(table_angles_deg(request.views)):
        rows = []
        for y_deg, (low, high) in zip(raster.y_deg, raster.ranges, strict=True):
            count = max(3, round((high - low) / raster.step_deg) + 1)
            rows.append(Row(view, next_id, count, float(y_deg), low, high))
            next_id += count
        views.append(ViewPlan(table_deg, tuple(rows)))
    return ScanPlan(tuple(views), raster.step_deg * rate_hz)


def coarse_request(request: PlanRequest) -> PlanRequest:
    """What the first pass of an error-driven scan is asked for: a part of the points from fewer angles."""
    return replace(request, views=min(max(request.views, COARSE_LEAST), COARSE_VIEWS), points=max(1, round(COARSE_SHARE * request.points)))


def scan_plan(rig: RigConfig, request: PlanRequest, rate_hz: float, located: ScanPlan, hits: NDArray[np.int64], first_id: int) -> ScanPlan:
    """The plan that covers what the locating pass found.

    Parameters
    ----------
    located : the locating plan
    hits : (n,) trigger ids of it that gave a point
    first_id : of the new plan
    """
    return _rasters(rig, request, rate_hz, _Found.by(located, hits), 0, first_id)


def even_views(
    rig: RigConfig, request: PlanRequest, rate_hz: float, located: ScanPlan, hits: NDArray[np.int64], first_view: int, first_id: int
) -> tuple[ViewPlan, ...]:
    """More views over the whole object, half way between those of the locating pass; what either neighbour has found is covered.

    Parameters
    ----------
    first_view, first_id : numbers of the first view and the first trigger id
    """
    plan = _rasters(rig, request, rate_hz, _Found.by(located, hits).between(), first_view, first_id)
    return tuple(replace(view, sweep_speed_deg_s=plan.sweep_speed_deg_s) for view in plan.views)


def closing_plan(plan: ScanPlan, first_id: int, table_deg: float) -> ScanPlan:
    """The rows of the first view once more, at the same place of the table after the turn: whether the turn closes."""
    first, rows = plan.views[0], []
    for row in first.rows:
        rows.append(replace(row, first_id=first_id))
        first_id += row.count
    return ScanPlan((replace(first, table_deg=table_deg, rows=tuple(rows), quota=CLOSING_POINTS),), plan.sweep_speed_deg_s)


# ------------------------------------------------------------------------------------------ inner
@dataclass(frozen=True, slots=True, eq=False)
class _Found:
    """What the locating pass has found in each view: the angle, what is to be covered, and the solid angle that gave points, square degrees."""

    table_deg: list[float]
    covers: list[list[Span]]
    areas: NDArray[np.float64]
    hits: int

    @staticmethod
    def by(located: ScanPlan, hits: NDArray[np.int64]) -> _Found:
        hit_ids = set(hits.tolist())
        areas = np.array([_area(view, hit_ids) for view in located.views])
        return _Found([view.table_deg for view in located.views], [_cover(view, hit_ids) for view in located.views], areas, len(hits))

    def between(self) -> _Found:
        """Half way from each view to the next: what either of the two has found."""
        table_deg = [angle + 180.0 / len(self.table_deg) for angle in self.table_deg]
        covers = [_joined(one, other) for one, other in zip(self.covers, self.covers[1:] + self.covers[:1], strict=True)]
        return _Found(table_deg, covers, 0.5 * (self.areas + np.roll(self.areas, -1)), self.hits)


def _rasters(rig: RigConfig, request: PlanRequest, rate_hz: float, found: _Found, first_view: int, first_id: int) -> ScanPlan:
    """Rows over what is to be covered in each view, with the step that gives the wanted number of points."""
    total = float(found.areas.sum())
    # The located area is a count of hits: two and a half of its standard deviations are planned on top.
    spare = _SPARE + 2.5 / np.sqrt(max(found.hits, 1))
    step = float(np.sqrt(total / (spare * request.points)))
    step = min(step, rig.limits.sweep_speed_deg_s / rate_hz)
    quotas = _quotas(found.areas, request.points)
    views, next_id = [], first_id
    for view, table_deg in enumerate(found.table_deg):
        rows = []
        for y_deg, low, high in _coarse_to_fine(found.covers[view], step):
            count = max(3, int(np.ceil((high - low) / step)) + 1)
            rows.append(Row(first_view + view, next_id, count, y_deg, low, low + (count - 1) * step))
            next_id += count
        views.append(ViewPlan(table_deg, tuple(rows), int(quotas[view])))
    return ScanPlan(tuple(views), step * rate_hz)


def _coarse_raster(rig: RigConfig, request: PlanRequest, rate_hz: float) -> _Raster:
    radius = request.object_radius_mm or rig.volume.radius_mm
    height = request.object_height_mm or rig.volume.height_mm
    angles = beam_angles(rig.laser, cylinder_outline(radius * 1.05, height * 1.05))
    bottom, top = float(angles[:, 1].min()), float(angles[:, 1].max())
    width = float(np.ptp(angles[:, 0]))
    # About a twelfth of the wanted points, at least enough that no tooth falls between two rows.
    wanted = float(np.clip(request.points / request.views / 12, 80, 400))
    step = np.sqrt(width * (top - bottom) / wanted)
    if request.smallest_part_mm is not None:
        # Half of it: a disc holds at least one node of a square raster when its diameter is sqrt(2) steps.
        distance = float(np.linalg.norm(np.subtract(rig.laser.position_mm, rig.laser.target_mm)))
        step = min(step, np.degrees(0.5 * request.smallest_part_mm / distance))
    step = max(step, 1e-3)
    rows = max(8, int(np.ceil((top - bottom) / step)))
    y_deg = bottom + (np.arange(rows) + 0.5) * (top - bottom) / rows
    half = (top - bottom) / rows
    fine = _dense_outline(angles, half)
    ranges = [row_range(fine, y, half) or (float(angles[:, 0].min()), float(angles[:, 0].max())) for y in y_deg]
    return _Raster(y_deg, float(min(step, rig.limits.sweep_speed_deg_s / rate_hz)), tuple(ranges))


def _dense_outline(angles: NDArray[np.float64], step: float) -> NDArray[np.float64]:
    """Outline points joined so closely that every row meets some."""
    parts = [angles]
    for k in (0.25, 0.5, 0.75):
        parts.append((1 - k) * angles[:-48] + k * angles[48:])
    return np.concatenate(parts)


def _joined(one: Sequence[Span], other: Sequence[Span]) -> list[Span]:
    """What either of two covers has, row by row."""
    rows: dict[float, tuple[float, float]] = {}
    for y_deg, low, high in (*one, *other):
        before = rows.get(y_deg, (low, high))
        rows[y_deg] = min(before[0], low), max(before[1], high)
    return [(y_deg, *rows[y_deg]) for y_deg in sorted(rows)]


def _cover(view: ViewPlan, hits: set[int]) -> list[Span]:
    """(y, x low, x high) in degrees per coarse row: what the object meets, one coarse step wider on every side."""
    spans: list[tuple[float, float] | None] = []
    for row in view.rows:
        columns = [i for i in range(row.count) if row.first_id + i in hits]
        step = (row.x_to_deg - row.x_from_deg) / (row.count - 1)
        spans.append((row.x_from_deg + (columns[0] - 1) * step, row.x_from_deg + (columns[-1] + 1) * step) if columns else None)
    cover = []
    for i, row in enumerate(view.rows):
        # A row that meets nothing itself borders on one that does: the object's edge lies between them.
        near = [span for span in ([spans[i]] if spans[i] else spans[max(0, i - 1) : i + 2]) if span is not None]
        if near:
            cover.append((row.y_deg, min(low for low, _ in near), max(high for _, high in near)))
    return cover


def _area(view: ViewPlan, hits: set[int]) -> float:
    """Solid angle that gave points, square degrees."""
    y_deg = [row.y_deg for row in view.rows]
    pitch = abs(y_deg[1] - y_deg[0])
    area = 0.0
    for row in view.rows:
        count = sum(row.first_id + i in hits for i in range(row.count))
        area += count * pitch * (row.x_to_deg - row.x_from_deg) / (row.count - 1)
    return area


def _quotas(areas: NDArray[np.float64], points: int) -> NDArray[np.int64]:
    """Whole numbers in proportion to the areas whose sum is `points`."""
    edges = np.rint(np.r_[0, np.cumsum(areas)] / areas.sum() * points).astype(np.int64)
    quotas: NDArray[np.int64] = np.diff(edges)
    return quotas


def _coarse_to_fine(cover: Sequence[Span], step: float) -> list[Span]:
    """Rows (y, x low, x high) every `step` degrees over the cover, in eight interleaved combs.

    A row between two coarse rows is as wide as both together.
    """
    if not cover:
        return []
    known = np.array(cover)
    pitch = float(np.min(np.diff(known[:, 0]))) if len(known) > 1 else 2 * step
    bottom, top = known[0, 0], known[-1, 0]
    fine = bottom + (np.arange(max(1, round((top - bottom) / step))) + 0.5) * step
    rows = []
    for comb in COARSE_TO_FINE:
        for y_deg in fine[comb::8]:
            near = known[np.abs(known[:, 0] - y_deg) < pitch]
            if len(near):
                rows.append((float(y_deg), float(near[:, 1].min()), float(near[:, 2].max())))
    return rows
