"""Synthetic measurements of the artefacts, with known errors."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.devices.rig import RigConfig, load_preset
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.metrology.acceptance import AcceptanceResult
from scanner_core.metrology.ball_bar import bar_positions, measure_bar
from scanner_core.metrology.certificate import Occasion
from scanner_core.metrology.history import HistoryEntry
from scanner_core.metrology.reference_sphere import Reference, SphereResult, evaluate_acquisition
from scanner_core.metrology.static_statistics import StaticResult, evaluate_static

Array = NDArray[np.float64]
R, SPACING = 11.133, 80.0


def cap(rng: np.random.Generator, count: int, lowest_deg: float) -> Array:
    """Unit vectors (count, 3) evenly over a sphere from its top down to a polar angle."""
    z = rng.uniform(np.cos(np.radians(lowest_deg)), 1, count)
    turn = rng.uniform(0, 2 * np.pi, count)
    across = np.sqrt(1 - z * z)
    return np.c_[across * np.cos(turn), across * np.sin(turn), z]


def ball(rng: np.random.Generator, centre: Array, radius_mm: float, sigma_mm: float, count: int = 1500, lowest_deg: float = 115.0) -> Array:
    """Points of a sphere with normal radial errors."""
    return np.asarray(centre + (radius_mm + rng.normal(0, sigma_mm, count))[:, None] * cap(rng, count, lowest_deg), np.float64)


def sphere_result(rig: RigConfig, radius_mm: float = R, sigma_mm: float = 0.025, acquisitions: int = 3, lowest_deg: float = 115.0) -> SphereResult:
    rng = np.random.default_rng(1)
    clouds = [PointCloud(ball(rng, np.array([0, 0, 13.0]), radius_mm, sigma_mm, 3500, lowest_deg)) for _ in range(acquisitions)]
    return SphereResult(tuple(evaluate_acquisition(cloud, R) for cloud in clouds), Reference(R, 0.001), rig.acceptance)


def acceptance_result(rig: RigConfig, spacing_mm: float = SPACING, sigma_mm: float = 0.02, positions: int = 7) -> AcceptanceResult:
    rng = np.random.default_rng(2)
    bars = []
    for number, position in enumerate(bar_positions(rig.volume, SPACING, R)[:positions], 1):
        planned = position.centres(SPACING)
        centres = planned.mean(axis=0) + (planned - planned.mean(axis=0)) * spacing_mm / SPACING + 0.3
        rod = centres[0] + np.linspace(0.2, 0.8, 200)[:, None] * (centres[1] - centres[0]) + rng.normal(0, 1.0, (200, 3))
        points = np.concatenate([*(ball(rng, centre, R, sigma_mm, 900, 125.0) for centre in centres), rod])
        bars.append(measure_bar(PointCloud(rng.permutation(points)), position, number, SPACING, R))
    return AcceptanceResult(tuple(bars), Reference(R, 0.001), Reference(SPACING, 0.001), rig.acceptance, rig.volume)


def static_result(places: int = 32) -> StaticResult:
    rng = np.random.default_rng(3)
    place = np.tile(np.repeat(np.arange(places), 60), 2)
    stay = np.repeat(np.arange(2 * places), 60)
    points = rng.normal(0, 1, (len(place), 3)) * (13.9, 11.5, 10.6)
    spots = np.c_[rng.normal(300, 0.02, (len(place), 4)), np.full((len(place), 4), 0.8), np.full((len(place), 2), 200.0)]
    time_s = np.arange(len(place)) / 60
    rejected = {"hidden_left": 4, "no_spot": 3}
    return evaluate_static(points, place, stay, time_s, spots, np.array([0.9, 1.4, 0.9, 1.4]), 671.75, len(place) + 7, rejected)


def occasion(test: str, figures: dict[str, float], earlier: int, parameters: tuple[tuple[str, str], ...] = ()) -> Occasion:
    """With results of so many months before."""
    rig = load_preset("bench")
    assert rig.calibration is not None
    limits = {"size": 50.0, "dispersion": 200.0, "form": 400.0, "spacing": 100.0}
    spread = dict.fromkeys(figures, 3.0)
    rng = np.random.default_rng(4)
    history = []
    for month in range(1, earlier + 2):
        values = {name: value + float(rng.normal(0, 2)) for name, value in figures.items()}
        history.append(
            HistoryEntry(f"2026-{month:02d}-11T09:30:00+00:00", test, values, spread, limits, "pass", "8f12", "2026-01-01T09:00:00+00:00", "ab", 0)
        )
    long_name = "a-rig-file-with-a-name-that-is-much-too-long-for-its-place-on-the-page.toml"
    return Occasion(rig, long_name, rig.calibration, history[-1].date, 0, parameters, tuple(history))
