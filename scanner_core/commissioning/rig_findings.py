"""What the cameras saw of a rig that was told to do something: measured values, each None where it could not be measured."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field


@dataclass(frozen=True, slots=True)
class AxisFinding:
    """How an axis follows its commands.

    The positive directions are those of the plan and of the calibration: beam x turns to the left and beam y upwards as the
    cameras see it, the table turns counter-clockwise as seen from above.

    Attributes
    ----------
    axis : ``x``, ``y`` or ``table``
    direction : +1 as it should be, -1 the other way round, None where no motion was seen
    ratio : measured over commanded angle, its magnitude; None where nothing could measure it
    ratio_uncertainty : of it, k = 1
    linearity : largest deviation of the measured places from a straight relation to the commanded ones, as a part of their range
    play_deg : difference of the places that are reached from below and from above; None where it drowns in noise
    """

    axis: str
    direction: int | None
    ratio: float | None = None
    ratio_uncertainty: float | None = None
    linearity: float | None = None
    play_deg: float | None = None


@dataclass(frozen=True, slots=True)
class CameraFinding:
    """What was seen of one camera.

    Attributes
    ----------
    laser_seen : its spot was found in the difference of lit and dark frames
    spot_px : where, (x, y)
    spot_dn : brightest pixel of that difference
    background_dn : mean of the dark frames
    rate_hz : measured; `wanted_hz` what was asked for
    dropped : frames that were missing in the run that measured it
    exposure_ms, gain_db : proposed for the object on the table
    """

    laser_seen: bool | None = None
    spot_px: tuple[float, float] | None = None
    spot_dn: float | None = None
    background_dn: float | None = None
    rate_hz: float | None = None
    wanted_hz: float | None = None
    dropped: int | None = None
    exposure_ms: float | None = None
    gain_db: float | None = None


@dataclass(frozen=True, slots=True)
class RigFindings:
    """Everything that a check of a rig has measured.

    Attributes
    ----------
    cameras : by name, ``left`` and ``right``
    axes : by name, ``x``, ``y`` and ``table``
    exchanged : what is called the right camera stands to the left of the other
    skew_ms : the right camera exposes so much later than the left one (negative: earlier); `skew_uncertainty_ms` is of k = 1
    laser_left_off : neither camera saw the spot after the laser was switched off
    """

    cameras: Mapping[str, CameraFinding] = field(default_factory=dict)
    axes: Mapping[str, AxisFinding] = field(default_factory=dict)
    exchanged: bool | None = None
    skew_ms: float | None = None
    skew_uncertainty_ms: float | None = None
    laser_left_off: bool | None = None
