"""A laser that stands beside its nominal place is found by the points that its beams gave."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from scanner_core.acquisition.aiming import beam_angles
from scanner_core.acquisition.beam_fit import fitted_laser
from scanner_core.acquisition.plan import Row, ViewPlan
from scanner_core.devices.laser_config import LaserConfig
from scanner_core.devices.rig import load_preset
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.geometry.rigid import RigidTransform

NOMINAL = load_preset("bench").laser
TRUE = replace(NOMINAL, position_mm=(357.0, -1.7, 303.9), target_mm=(0.6, 0.9, 24.5))


def scanned(strays: float) -> tuple[list[ViewPlan], PointCloud]:
    """Points on a ball of 15 mm by beams of the true laser, in three views; some of them anywhere on it."""
    rng = np.random.default_rng(3)
    views, points, next_id = [], [], 100
    for view, table_deg in enumerate((0.0, 120.0, 240.0)):
        rows = []
        for y_deg in np.linspace(-1.2, 1.2, 12):
            row = Row(view, next_id, 15, float(y_deg), -1.4, 1.4)
            next_id += 15
            rows.append(row)
            for x_deg in np.linspace(-1.4, 1.4, 15):
                points.append(RigidTransform.about_z(-table_deg).apply(_hit(x_deg, y_deg)[None])[0])
        views.append(ViewPlan(table_deg, tuple(rows)))
    cloud = np.array(points)
    wrong = rng.random(len(cloud)) < strays
    cloud[wrong] += rng.normal(0, 4, (int(wrong.sum()), 3))
    return views, PointCloud(cloud, trigger_ids=np.arange(100, 100 + len(cloud)))


def _hit(x_deg: float, y_deg: float) -> np.ndarray:
    position, target = np.array(TRUE.position_mm), np.array(TRUE.target_mm)
    away = target - position
    azimuth, elevation = np.arctan2(away[1], away[0]) + np.radians(x_deg), np.arctan2(away[2], np.hypot(*away[:2])) + np.radians(y_deg)
    direction = np.array([np.cos(elevation) * np.cos(azimuth), np.cos(elevation) * np.sin(azimuth), np.sin(elevation)])
    to_middle = position - [0, 0, 25.0]
    b = float(direction @ to_middle)
    return np.asarray(position + (-b - np.sqrt(b * b - float(to_middle @ to_middle) + 15.0**2)) * direction)


def test_beams_hit_where_they_are_sent_with_the_fitted_laser() -> None:
    views, cloud = scanned(strays=0.05)
    found = fitted_laser(NOMINAL, views, cloud)
    aimed = np.array([[0.0, 0.0, 40.0], [10.0, 5.0, 30.0], [3.0, -12.0, 15.0]])

    def off_mm(laser: LaserConfig) -> float:
        return float(np.radians(np.abs(beam_angles(laser, aimed) - beam_angles(TRUE, aimed)).max()) * 450)

    assert off_mm(NOMINAL) > 0.5
    assert off_mm(found) < 0.05


def test_without_points_the_nominal_laser_stays() -> None:
    views, cloud = scanned(strays=0.0)
    assert fitted_laser(NOMINAL, [], cloud) is NOMINAL
    assert fitted_laser(NOMINAL, views, cloud.select(np.arange(50))) is NOMINAL
