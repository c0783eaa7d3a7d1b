"""The moved teeth in the ranked list, what is false in it, and the motion of a marked tooth."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.comparison.area import Area, PartMotion
from scanner_core.comparison.compare import compare
from scanner_core.comparison.part_motion import part_motion
from scanner_core.geometry.rigid import RigidTransform
from tests.bench.comparison.clean_pair import CleanPair
from tests.bench.comparison.scan_pair import Disturbance, ScanPair, scan

Array = NDArray[np.float64]

FALSE_UM = 200.0
"""An entry that reads more than this where nothing moved is false."""
MOVED_MM = 0.2
"""Tissue counts as moved from here on: the bound of the entries and of the truth that they are held against."""
CROWN_MM = 0.1
"""What lies this near to a crown's own shape is crown; farther out begins the rounding towards gum and neighbours."""
TIE_MM = 0.05
"""Teeth whose displacements differ by less may stand in either order."""


@dataclass(frozen=True, slots=True, eq=False)
class AreaFigures:
    """Of one pair.

    Attributes
    ----------
    teeth, found : moved teeth, and those with an entry of their own
    false : entries above `FALSE_UM` on tissue that did not move
    surplus : other entries that are not the one of a moved tooth: a tooth that is listed twice, a part of one
    out_of_order : pairs of found teeth that stand in the wrong order
    overlap : (found,) intersection over union of an entry's vertices and the tooth's moved tissue
    place_um, angle_deg : (found,) errors of the entries' motions; empty where the truth is not told
    z : (found,) the errors along the displacement over their stated uncertainty
    """

    teeth: int
    found: int
    false: int
    surplus: int
    out_of_order: int
    overlap: NDArray[np.float64]
    place_um: NDArray[np.float64]
    angle_deg: NDArray[np.float64]
    z: NDArray[np.float64]


def report(pairs: Iterable[tuple[int, CleanPair]], disturbance: Disturbance, title: str) -> list[dict[str, object]]:
    """Print lines of all pairs; every pair's figures."""
    figures, marked = [], []
    for seed, clean in pairs:
        pair = scan(clean, disturbance, seed)
        result = compare(pair.before, pair.after)
        figures.append((seed, look(pair, result.areas)))
        marked += [_motion_errors(part_motion(pair.before, pair.after, result.alignment, mark), *true) for mark, *true in _marks(pair)]
    names = ("teeth", "found", "false", "surplus", "out_of_order")
    teeth, found, false, surplus, wrong = (sum(getattr(f, name) for _, f in figures) for name in names)
    overlap = np.concatenate([f.overlap for _, f in figures])
    print(
        f"areas: {title}: {found} of {teeth} moved teeth found, {wrong} pairs in the wrong order, "
        f"{false} false at {FALSE_UM:.0f} um, {surplus} more; IoU median {np.median(overlap):.3f}, worst {overlap.min():.3f}",
        flush=True,
    )
    _print_motions(f"entries' motions: {title}", *(np.concatenate([getattr(f, name) for _, f in figures]) for name in ("place_um", "angle_deg", "z")))
    _print_motions(f"marked crowns: {title}", *np.reshape(marked, (-1, 3)).T)
    return [{"what": "areas", "title": title, "seed": seed} | {name: getattr(f, name) for name in AreaFigures.__slots__} for seed, f in figures]


def _print_motions(title: str, place_um: Array, angle_deg: Array, z: Array) -> None:
    if len(place_um):
        print(
            f"{title}: median {np.median(place_um):.1f}, 90 % {np.percentile(place_um, 90):.0f}, worst {place_um.max():.1f} um; "
            f"median {np.median(angle_deg):.2f}, 90 % {np.percentile(angle_deg, 90):.1f}, worst {angle_deg.max():.2f} deg; "
            f"z rms {np.sqrt((z**2).mean()):.2f} (n={len(z)})",
            flush=True,
        )


def _marks(pair: ScanPair) -> Iterator[tuple[NDArray[np.bool_], RigidTransform, Array]]:
    """Each moved crown as a person would mark it: the crown itself, or, where that is not told, what of it has moved."""
    for tooth, (motion, centre) in enumerate(zip(pair.motions, pair.centres, strict=False)):
        crown = pair.crown_mm < CROWN_MM if np.isfinite(pair.crown_mm).all() else np.abs(pair.moved_mm) > MOVED_MM
        yield crown & (pair.tooth == tooth), motion, centre


def look(pair: ScanPair, areas: Iterable[Area]) -> AreaFigures:
    """Hold the entries of a comparison against the truth."""
    areas = list(areas)
    truth = _moved_tissue(pair)
    best: list[Area | None] = []
    overlap, entries = [], []
    for tissue in truth:
        shares = [_overlap(area.vertices, tissue) for area in areas]
        number = int(np.argmax(shares)) if shares else -1
        taken = number >= 0 and shares[number] > 0.3 and number not in entries
        best.append(areas[number] if taken else None)
        if taken:
            overlap.append(shares[number])
            entries.append(number)
    moved = np.abs(pair.moved_mm) > 0.5 * MOVED_MM
    false = sum(abs(area.max_um) > FALSE_UM and moved[area.vertices].mean() < 0.1 for area in areas)
    found = [(area.rank, pair.shifts_mm[tooth]) for tooth, area in enumerate(best) if area is not None]
    wrong = sum(a[0] < b[0] and a[1] < b[1] - TIE_MM for a in found for b in found)
    errors = [_motion_errors(area.motion, pair.motions[t], pair.centres[t]) for t, area in enumerate(best) if area and area.motion and pair.motions]
    place, angle, z = (np.array([error[i] for error in errors]) for i in range(3))
    surplus = len(areas) - len(found) - int(false)
    return AreaFigures(len(truth), len(found), int(false), surplus, int(wrong), np.array(overlap), place, angle, z)


def _moved_tissue(pair: ScanPair) -> list[NDArray[np.int64]]:
    """Of each tooth the vertices of the after surface that moved: its own, and the gum that it took along."""
    moved = np.flatnonzero(np.abs(pair.moved_mm) > MOVED_MM)
    return [moved[pair.tooth[moved] == tooth] for tooth in range(len(pair.centres))]


def _overlap(a: NDArray[np.int64], b: NDArray[np.int64]) -> float:
    both = len(np.intersect1d(a, b))
    return both / max(len(a) + len(b) - both, 1)


def _motion_errors(found: PartMotion, true: RigidTransform, centre: NDArray[np.float64]) -> tuple[float, float, float]:
    """At the middle of the crown, um; of the rotation, deg; along the displacement of the part's own centre, over its uncertainty."""
    error = found.transform.apply(centre) - true.apply(centre)
    along = (true.apply(found.centre) - found.centre) @ found.displacement_mm / np.linalg.norm(found.displacement_mm)
    z = 1e3 * (np.linalg.norm(found.displacement_mm) - along) / found.displacement_uncertainty_um
    return float(1e3 * np.sqrt(error @ error)), (found.transform.inverse() @ true).angle_deg(), float(z)
