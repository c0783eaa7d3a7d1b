"""The next pass of an error-driven scan: table angles and rows that bring points where the surface is still uncertain.

From the surface so far, its uncertainty and what beam and cameras reach of it: :mod:`~scanner_core.acquisition.allocation`
says how much every place deserves, :mod:`~scanner_core.acquisition.view_choice` from which angle it is measured best, and
:mod:`~scanner_core.acquisition.beam_rows` makes rows of that.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.beam_fit import fitted_laser
from scanner_core.acquisition.beam_rows import beam_rows
from scanner_core.acquisition.plan import ViewPlan
from scanner_core.acquisition.planning import may_stand
from scanner_core.acquisition.remount import RemountAdvice, remount_advice
from scanner_core.acquisition.surface_places import SurfacePlaces
from scanner_core.acquisition.view_choice import choose_views
from scanner_core.acquisition.yields import expected_yields
from scanner_core.coverage.sight import Sight
from scanner_core.coverage.sightlines import Sightlines
from scanner_core.devices.rig import RigConfig
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.optics.calibration import StereoCalibration
from scanner_core.optics.noise_model import NoiseModel

Array = NDArray[np.float64]

ROW_S, TURN_S = 0.065, 0.8
"""Time between two rows and for turning to the next view, beside the exposures: as the virtual rig's controller needs them."""

_EVERY_DEG = 10.0
_MOST_VIEWS = 24
_SPARE = 1.05
_NARROWEST_SPOTS = 0.3
"""Narrowest step, in diameters of the spot: what lies closer shares its light, and errs alike."""

_LEAST_YIELD = 0.25
"""Where fewer exposures give a point, no more of them are spent on it: the sight line is likely another than it seems."""

_NOT_MUCH_MORE = 1.3

_MEAN_COSINE = 0.5
"""Of the beam on the places that it measures: a raster is less dense on a slope."""

_LEAST_POINTS = 40
"""A view with fewer points cannot be registered, and is not worth a turn."""


@dataclass(frozen=True, slots=True, eq=False)
class NextPass:
    """A pass, and what it is good for.

    Attributes
    ----------
    views : of the pass, in the order of the table's turn; empty when there is nothing more to gain
    points : that it is expected to measure
    seconds : of the rig's time
    within_now, within_predicted : share of the area within the wanted uncertainty, of all that is, or can be measured as the object stands
    remount : how to set the object down anew for what cannot be measured as it stands; None when nothing is worth it
    """

    views: tuple[ViewPlan, ...]
    points: int
    seconds: float
    within_now: float
    within_predicted: float
    remount: RemountAdvice | None = None


def next_pass(
    surface: TriangleMesh,
    cloud: PointCloud,
    rig: RigConfig,
    calibration: StereoCalibration,
    rate_hz: float,
    wanted_um: float,
    budget_points: int,
    first_view: int,
    first_id: int,
    *,
    aim_um: float | None = None,
    done: Sequence[ViewPlan] = (),
    noise: NoiseModel | None = None,
    check: Callable[[], None] = lambda: None,
) -> NextPass:
    """Plan a pass.

    Parameters
    ----------
    surface : so far, object frame, with ``standard_uncertainty_um`` and ``supported``
    cloud : the points that it was made of, object frame, with covariances
    rate_hz : of the cameras
    wanted_um : standard uncertainty that is enough
    budget_points : the most that may still be measured; a pass takes as many as there are points so far at most, because what
        few points tell is not trusted with many
    first_view, first_id : numbers of the first view and trigger id of the pass
    aim_um : uncertainty that the pass is planned for where that is less than the wanted one; both shares are told of the wanted one
    done : the views so far, whose exposures show what gives points and what does not
    noise : of the scan so far
    check : raises when the caller asked to stop
    """
    places = SurfacePlaces.of(surface, cloud)
    rig = replace(rig, laser=fitted_laser(rig.laser, done, cloud))
    if noise is not None and noise.angle_rad <= 0:  # residuals that show nothing beside the pixels' noise would make points exact
        noise = replace(noise, angle_rad=NoiseModel.prior(calibration, rig.spot.floor_px).angle_rad)
    sightlines = Sightlines(rig, calibration, surface, places.points, places.normals, noise)
    sights = []
    for angle in np.arange(0.0, 360.0, _EVERY_DEG).tolist():
        check()
        if may_stand(rig.limits, angle):
            sights.append(sightlines.at(angle))
    angles = np.array([sight.table_deg for sight in sights])
    reach_deg = _reach_deg(places, rig)
    ids = np.zeros(0, np.int64) if cloud.trigger_ids is None else cloud.trigger_ids
    share = expected_yields(angles, len(places.points), done, ids, sightlines.at, reach_deg)
    # a point that only every second exposure gives takes two
    sd_um = np.stack([np.where(sight.measurable, sight.point_sd_um, np.inf) for sight in sights]) / np.sqrt(share)
    check()
    budget_points = _of_this_pass(budget_points, len(cloud))
    demand = places.demand
    view_points = rate_hz * TURN_S
    densest = _MEAN_COSINE / (_NARROWEST_SPOTS * rig.laser.spot_diameter_mm) ** 2
    choice = choose_views(demand, sd_um, float(budget_points), wanted_um if aim_um is None else aim_um, densest, view_points, _MOST_VIEWS)
    here = np.asarray(np.isfinite(sd_um).any(axis=0), np.bool_)
    now = demand.uncertainty_um <= wanted_um
    area = demand.area_mm2 * (here | now)
    total = max(float(area.sum()), 1e-12)
    after = choice.uncertainty_um <= 1.001 * wanted_um
    views, seconds, view, next_id, points = list[ViewPlan](), 0.0, first_view, first_id, 0
    for k in np.argsort(np.array([sights[a].table_deg for a in choice.chosen])).tolist():
        check()
        wanted = choice.points[k]
        quota = int(min(np.floor(wanted.sum()), budget_points - points))
        if quota < _LEAST_POINTS:
            continue
        plan = _view(sights[choice.chosen[k]], wanted, share[choice.chosen[k]], places, rig, rate_hz, view, next_id, quota)
        if not plan.rows:
            continue
        exposures = sum(row.count for row in plan.rows)
        seconds += TURN_S + ROW_S * len(plan.rows) + exposures / rate_hz
        next_id += exposures
        points += quota
        view += 1
        views.append(plan)
    within_now, within_then = float(area @ now) / total, float(area @ after) / total
    advice = remount_advice(surface, places.points, places.normals, demand.area_mm2, here, rig, calibration, check=check)
    return NextPass(tuple(views), points, seconds, within_now, within_then if views else within_now, advice)


def _of_this_pass(budget_points: int, so_far: int) -> int:
    """All that is left when that is not much more than there is."""
    return budget_points if budget_points < _NOT_MUCH_MORE * so_far else so_far


def _reach_deg(places: SurfacePlaces, rig: RigConfig) -> float:
    """How far from a place a beam still means it."""
    distance_mm = float(np.linalg.norm(np.subtract(rig.laser.position_mm, rig.laser.target_mm)))
    return float(np.degrees(0.8 * places.spacing_mm / distance_mm))


def _view(
    sight: Sight, wanted: Array, share: Array, places: SurfacePlaces, rig: RigConfig, rate_hz: float, view: int, first_id: int, quota: int
) -> ViewPlan:
    """The rows that measure `wanted` (n,) points of the places, where an exposure gives a point with the probability `share` (n,)."""
    exposures = wanted / np.maximum(share, _LEAST_YIELD)
    met = np.flatnonzero(sight.beam_free & (sight.cosines > 0).all(axis=1))
    laser = rig.laser
    distance_mm = float(np.linalg.norm(np.subtract(laser.position_mm, laser.target_mm)))
    # a place seen at an angle covers less of the beam's square degrees
    seen_deg2 = places.demand.area_mm2[met] * np.maximum(sight.cosines[met, 0], 0.05) * np.degrees(1 / distance_mm) ** 2
    limits = rig.limits
    narrowest = float(np.degrees(_NARROWEST_SPOTS * laser.spot_diameter_mm / distance_mm))
    steps = narrowest, max(limits.sweep_speed_deg_s / rate_hz, narrowest)
    within = limits.x_deg, limits.y_deg
    spent = _SPARE * quota * float(exposures.sum() / wanted.sum())
    found = beam_rows(sight.beam_deg[met], exposures[met] / seen_deg2, spent, _reach_deg(places, rig), steps, within, view, first_id)
    return ViewPlan(sight.table_deg, found.rows, quota, found.step_deg * rate_hz)
