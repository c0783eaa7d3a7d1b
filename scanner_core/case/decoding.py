"""Values out of a case: every one may be of any type, whatever its column says, and any number may be absurd.

Every function raises ValueError (or another of :data:`FAULTS`) for what cannot be right; :func:`damaged` makes the
sentence of it.
"""

from __future__ import annotations

import json
import zlib
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from scanner_core.case.observation import ExposureTable, ObservationTable, PairTable
from scanner_core.errors import CaseFormatError, ImprontaError
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.one_line import one_line

FAULTS = (LookupError, TypeError, ValueError, OverflowError, AttributeError, RecursionError, zlib.error)

LONGEST_TEXT = 100_000_000
"""Characters of a JSON text; the plan of 5 million points has some 10 million."""
DEEPEST = 32
_AT_ONCE = 2_000
"""Rows that become numbers in one go."""
MOST_ID = 2**53
"""Trigger ids are exact as float64 up to here."""
MOST_VIEWS = 360
MOST_MOUNTS = 1000
MOST_PLANNED = 20_000_000
"""Trigger ids of a plan; at most 5 million points are asked for."""
_MOST_PLANNED_TURN_DEG, _WIDEST_BEAM_DEG, _FASTEST_DEG_S = 1440.0, 90.0, 1000.0
_FARTHEST_PX = 1e5
_MOST_TURN_DEG = 1e6
_FARTHEST_MM = 1e4

_BOUNDS = np.array(
    [
        *[(0, MOST_ID), (0, MOST_VIEWS - 1), (-_MOST_TURN_DEG, _MOST_TURN_DEG)],
        *[(-_FARTHEST_PX, _FARTHEST_PX)] * 4,
        *[(0, 1e12)] * 2,  # uncertainties, 1e-6 px
        *[(0, 1e9)] * 4,  # sigmas, 1e-3 px
    ]
)
_COLUMNS = ("trigger id", "view", "table angle", *["centroid"] * 4, *["uncertainty"] * 2, *["size"] * 4)


@contextmanager
def damaged(path: Path, what: str) -> Iterator[None]:
    """Turn whatever a damaged value does into E-CASE-01, naming it."""
    try:
        yield
    except ImprontaError:
        raise
    except FAULTS as fault:
        raise CaseFormatError("E-CASE-01", path=path, reason=f"its {what} is damaged ({one_line(fault)})", details=repr(fault)) from fault


def text(value: object) -> str:
    if not isinstance(value, str):
        raise TypeError(f"{type(value).__name__} instead of a text")
    return value


def tree(value: object) -> Any:
    """What a JSON text holds: at most :data:`DEEPEST` deep, and finite numbers only."""
    content = text(value)
    if len(content) > LONGEST_TEXT:
        raise ValueError(f"{len(content)} characters")
    found = json.loads(content, parse_constant=_refuse)
    level: list[Any] = [found]
    for _ in range(DEEPEST):
        level = [inner for outer in level if isinstance(outer, dict | list) for inner in (outer.values() if isinstance(outer, dict) else outer)]
        if not level:
            return found
        if any(isinstance(number, int | float) and not abs(number) < 1e300 for number in level):
            raise ValueError("a number beyond all bounds")
    raise ValueError(f"nested more than {DEEPEST} deep")


def table(value: object) -> dict[str, Any]:
    """A JSON object."""
    found = tree(value)
    if not isinstance(found, dict):
        raise TypeError("no JSON object")
    return found


def plan(value: object, kind: str = "") -> dict[str, Any]:
    """A plan as it was kept: views with rows, each with its first trigger id and count.

    Whoever goes on with it sweeps the beam and turns the table, so all of it is within what a plan of this program can be.
    The whole object's plans (`kind` locate or scan) hold all views in their order; the others hold some of them.
    """
    found = table(value)
    views = found["views"]
    if not isinstance(views, list) or len(views) > MOST_VIEWS:
        raise ValueError(f"more than {MOST_VIEWS} views, or none")
    _within(found, "sweep_speed_deg_s", 1e-9, _FASTEST_DEG_S)
    total = 0
    for number, view in enumerate(views):
        _within(view, "table_deg", -_MOST_PLANNED_TURN_DEG, _MOST_PLANNED_TURN_DEG)
        if view.get("sweep_speed_deg_s") is not None:
            _within(view, "sweep_speed_deg_s", 1e-9, _FASTEST_DEG_S)
        if view.get("quota") is not None:
            _whole(view, "quota", -MOST_PLANNED, MOST_PLANNED)
        if view.get("repeats") is not None:
            _whole(view, "repeats", 0, number - 1)
        for row in view["rows"]:
            first, count = _whole(row, "first_id", 0, MOST_ID), _whole(row, "count", 0, MOST_PLANNED)
            if "view" in row and _whole(row, "view", 0, MOST_VIEWS - 1) != number and kind in ("locate", "scan"):
                raise ValueError(f"a row of view {row['view']} in view {number}")
            for angle in ("y_deg", "x_from_deg", "x_to_deg"):
                _within(row, angle, -_WIDEST_BEAM_DEG, _WIDEST_BEAM_DEG)
            if first + count > MOST_ID:
                raise ValueError(f"a row of {count} trigger ids from {first}")
            total += count
    if total > MOST_PLANNED:
        raise ValueError(f"{total} trigger ids")
    return found


def _whole(record: Any, name: str, least: int, most: int) -> int:
    number = record[name]
    if isinstance(number, bool) or not isinstance(number, int):
        raise TypeError(f"a {name} that is no whole number")
    if not least <= number <= most:
        raise ValueError(f"a {name} of {number}")
    return number


def _within(record: Any, name: str, least: float, most: float) -> None:
    """A number in those limits; the plans of the oldest cases do not tell every one."""
    if name not in record:
        return
    number = record[name]
    if isinstance(number, bool) or not isinstance(number, int | float):
        raise TypeError(f"a {name} that is no number")
    if not least <= number <= most:
        raise ValueError(f"a {name} of {number:g}")


def correction(value: object) -> RigidTransform:
    """A rigid motion (object frame to object frame) of at most 10 m."""
    rows = tree(value)
    matrix = np.array(rows, np.float64)
    if matrix.shape != (4, 4) or not np.isfinite(matrix).all():
        raise ValueError("not 4 x 4 finite numbers")
    rotation = matrix[:3, :3]
    if np.abs(rotation @ rotation.T - np.eye(3)).max() > 1e-6 or np.linalg.det(rotation) < 0 or (matrix[3] != (0, 0, 0, 1)).any():
        raise ValueError("no rigid motion")
    if np.abs(matrix[:3, 3]).max() > _FARTHEST_MM:
        raise ValueError("a motion of more than 10 m")
    return RigidTransform.from_matrix(matrix)


def mount(value: object) -> int:
    """The number of a mount."""
    if isinstance(value, bool) or not isinstance(value, int):
        raise TypeError("a mount that is no whole number")
    if not 0 <= value < MOST_MOUNTS:
        raise ValueError(f"a mount {value}")
    return value


def observations(parts: Sequence[NDArray[np.float64]]) -> ObservationTable:
    """Rows of trigger id, view, table angle, centroids (left x, y, right x, y), uncertainties, sigmas (left x, y, right x, y), in parts."""
    numbers = np.concatenate(parts) if len(parts) else np.empty((0, len(_COLUMNS)))
    wrong = ~((numbers >= _BOUNDS[:, 0]) & (numbers <= _BOUNDS[:, 1]))
    if wrong.any():
        row, column = np.argwhere(wrong)[0]
        raise ValueError(f"a {_COLUMNS[column]} of {numbers[row, column]:g} in row {row + 1}")
    return ObservationTable(
        trigger_id=numbers[:, 0].astype(np.int64),
        view=numbers[:, 1].astype(np.int32),
        table_deg=numbers[:, 2].copy(),
        left_px=numbers[:, 3:5].copy(),
        right_px=numbers[:, 5:7].copy(),
        left_uncertainty_px=numbers[:, 7] * 1e-6,
        right_uncertainty_px=numbers[:, 8] * 1e-6,
        left_sigma_px=numbers[:, 9:11] * 1e-3,
        right_sigma_px=numbers[:, 11:13] * 1e-3,
    )


def pairs(rows: Sequence[tuple[Any, ...]]) -> PairTable:
    """Rows as of :func:`observations`, then the two peaks and the verdict's name."""
    width = len(_COLUMNS)
    numbers = _numbers(rows, width + 2)
    peaks = numbers[:, width:]
    if not ((peaks >= 0) & (peaks <= 65_535)).all():
        raise ValueError("a peak that no camera has")
    verdicts = np.array([text(row[width + 2]) for row in rows], np.object_)
    return PairTable(observations([numbers[:, :width]]), verdicts, peaks)


def trigger_ids(rows: Sequence[tuple[Any, ...]]) -> NDArray[np.int64]:
    """One whole number a row."""
    found = np.array(rows, np.int64).reshape(-1)
    if len(found) and not 0 <= found.min() <= found.max() <= MOST_ID:
        raise ValueError("a trigger id that no scan has")
    return found


def exposures(rows: Sequence[tuple[Any, ...]]) -> ExposureTable:
    """Rows of trigger id, table angle, centroids (left x, y, right x, y; None without a spot) and the verdict's name."""
    numbers = _numbers(rows, 6)  # None becomes NaN
    bounds = _BOUNDS[[0, 2, 3, 4, 5, 6]]
    wrong = (numbers < bounds[:, 0]) | (numbers > bounds[:, 1])
    if wrong.any() or np.isnan(numbers[:, :2]).any():
        raise ValueError("an exposure that no rig makes")
    verdicts = np.array([text(row[-1]) for row in rows], np.object_)
    return ExposureTable(numbers[:, 0].astype(np.int64), numbers[:, 1].copy(), verdicts, numbers[:, 2:4].copy(), numbers[:, 4:].copy())


def _numbers(rows: Sequence[tuple[Any, ...]], width: int) -> NDArray[np.float64]:
    """The first columns; some rows at a time, because numpy holds Python's lock meanwhile."""
    parts = [np.array([row[:width] for row in rows[begin : begin + _AT_ONCE]], np.float64) for begin in range(0, len(rows), _AT_ONCE)]
    return np.concatenate(parts) if parts else np.empty((0, width))


def _refuse(name: str) -> float:
    raise ValueError(f"the number {name}")
