"""A scan by a laser line on the virtual rig: controller and clock as in any scan, frames rendered, one sweep a view."""

from __future__ import annotations

import time
from collections import Counter
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.aiming import beam_angles, cylinder_outline
from scanner_core.acquisition.line_engine import LineEngine, LinePoints
from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.optics.stripe_detection import StripeDetector, StripeDetectorParameters
from scanner_core.virtual.image_formation import ImageSensor
from scanner_core.virtual.laser_fan import FanScene, LaserFan
from scanner_core.virtual.line_image import LineShutter
from scanner_core.virtual.presets import PRESETS
from scanner_core.virtual.specimens import Specimen

Array = NDArray[np.float64]
Images = NDArray[np.uint8]

_MARGIN_DEG = 0.35
_EXPOSED = 0.02
"""Frames begin so many seconds after a sweep has begun to move."""


@dataclass(frozen=True, slots=True, eq=False)
class SweptView:
    """The frames of one view, (f, 2, H, W) uint8, and where the table stood by the controller."""

    table_deg: float
    images: Images


@dataclass(frozen=True, slots=True, eq=False)
class LineScan:
    """All views, how long the rig took and how long it took to render them."""

    views: list[SweptView]
    rig_s: float
    render_s: float


class LineRig:
    """The virtual rig with a fan in place of the spot; sweeps a view and hands out its frames."""

    def __init__(self, rig: OpenRig, specimen: Specimen, seed: int, fan: LaserFan) -> None:
        assert rig.config.virtual is not None
        assert rig.bench is not None
        preset = PRESETS[rig.config.virtual].changed(rig.config.image_model)
        self._rig, self._preset = rig, preset
        self._timeline = rig.bench.timeline
        self._scene, self._shutter = FanScene(preset, fan, specimen, seed), LineShutter(preset)
        self._sensors = (ImageSensor(preset, 0, seed), ImageSensor(preset, 1, seed))
        self._key = 0
        self.render_s = 0.0

    def sweep(self, table_deg: float, x_deg: tuple[float, float], y_deg: float, speed_deg_s: float) -> SweptView:
        """One sweep at one place of the table."""
        motion, clock, preset = self._rig.motion, self._rig.clock, self._preset
        motion.rotate_to(table_deg)
        stands_deg = motion.status().table_deg
        motion.aim(x_deg[0], y_deg)
        motion.sweep(x_deg[1], y_deg, speed_deg_s)
        start_s = clock.now_s() + _EXPOSED
        frames = int((x_deg[1] - x_deg[0]) / speed_deg_s * preset.rate_hz)
        clock.wait_until(start_s + frames / preset.rate_hz)
        begin_s = time.process_time()
        images = np.stack([self._frame(start_s + number / preset.rate_hz) for number in range(frames)])
        self.render_s += time.process_time() - begin_s
        motion.wait_idle(30.0)
        return SweptView(stands_deg, images)

    def _frame(self, start_s: float) -> Images:
        self._key += 1
        preset = self._preset
        signals = self._shutter.expose(self._scene, self._timeline, start_s, preset.exposure_ms)
        pairs = zip(self._sensors, signals, strict=True)
        return np.stack([sensor.lit_frame(signal + np.float32(preset.ambient_dn), self._key) for sensor, signal in pairs])


def scan_by_line(rig: OpenRig, specimen: Specimen, seed: int, views: int, frames: int) -> LineScan:
    """Sweep `views` views in about `frames` frames; where the object is, is learnt from the views before."""
    line = LineRig(rig, specimen, seed, LaserFan())
    assert rig.calibration is not None
    engine, detector = LineEngine(rig.config, rig.calibration), StripeDetector()
    angles = beam_angles(rig.config.laser, cylinder_outline(specimen.radius_mm, specimen.height_mm))
    y_deg = 0.5 * float(angles[:, 1].min() + angles[:, 1].max())
    x_deg = float(angles[:, 0].min()), float(angles[:, 0].max())
    speed = (x_deg[1] - x_deg[0]) * views / frames * rig.left.rate_hz
    begin_s = rig.clock.now_s()
    known: list[Array] = []
    swept = []
    for view in range(views):
        table_deg = 360.0 * view / views
        if known:
            seen = RigidTransform.about_z(table_deg).apply(np.concatenate(known))
            pans = beam_angles(rig.config.laser, seen)[:, 0]
            x_deg = float(pans.min()) - _MARGIN_DEG, float(pans.max()) + _MARGIN_DEG
        swept.append(line.sweep(table_deg, x_deg, y_deg, speed))
        known.append(evaluated(swept[-1], detector, engine).points)
        print(f"view {view + 1} of {views}: {len(swept[-1].images)} frames, {len(known[-1])} points", flush=True)
    return LineScan(swept, rig.clock.now_s() - begin_s, line.render_s)


def evaluated(view: SweptView, detector: StripeDetector, engine: LineEngine) -> LinePoints:
    """The points of a view."""
    return engine.evaluate([(detector.detect(left), detector.detect(right)) for left, right in view.images], view.table_deg)


def line_cloud(views: list[SweptView], engine: LineEngine, parameters: StripeDetectorParameters) -> tuple[PointCloud, Counter[str], list[LinePoints]]:
    """All points of a scan in the object frame, not registered yet, the verdicts of all peaks, and each view's own."""
    detector, verdicts, parts = StripeDetector(parameters), Counter[str](), []
    for view in views:
        parts.append(evaluated(view, detector, engine))
        verdicts.update(parts[-1].verdicts)
    numbers = np.repeat(np.arange(len(parts), dtype=np.int32), [len(part.points) for part in parts])
    points, covariances = (np.concatenate([getattr(part, name) for part in parts]) for name in ("points", "covariances"))
    return PointCloud(points, covariances, numbers, np.arange(len(points))), verdicts, parts


def save(scan: LineScan, path: Path) -> None:
    """Keep the frames, to look at them again."""
    arrays: dict[str, NDArray[np.generic]] = {f"view{number}": view.images for number, view in enumerate(scan.views)}
    arrays |= {"table_deg": np.array([view.table_deg for view in scan.views]), "seconds": np.array([scan.rig_s, scan.render_s])}
    with path.open("wb") as file:
        np.savez(file, allow_pickle=False, **arrays)


def load(path: Path) -> LineScan:
    """What `save` kept."""
    with np.load(path) as kept:
        views = [SweptView(float(angle), kept[f"view{number}"]) for number, angle in enumerate(kept["table_deg"])]
        return LineScan(views, *kept["seconds"].tolist())
