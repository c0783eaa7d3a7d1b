"""What is asked of a cloud before any work: enough different points, numbers all of them, one object, more than a sheet.

Whatever is refused here costs a second or two instead of minutes, and is said in one sentence.  What is only suspicious
(a size that no anatomical part has, an origin far away, coordinates that were rounded) becomes a warning.

*Objects* are told apart by single linkage at ten spacings, one setting for every cloud.  Stray points must not build a
bridge between two objects, so a point that is much lonelier than its neighbours does not link.  A cloud that falls into
many crumbs is not many objects but sampled in lines or clumps: there the link grows until the crumbs hold together.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from scanner_core.errors import ReconstructionError
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.weld import weld
from scanner_core.reconstruction.remarks import Remark, RemarkKind

Array = NDArray[np.float64]
Labels = NDArray[np.int64]
Mask = NDArray[np.bool_]

LEAST_POINTS = 50

_FARTHEST_MM = 1e13
"""Coordinates beyond this are damage; within it no square overflows.  Files are refused much earlier."""

_LINK = 10.0
"""Gap between two objects, in spacings."""

_LINK_SHARE = 0.01
"""A gap below this share of the extent is a shadow of the scan, however dense the points are."""

_OBJECT_SHARE = 0.05
_CRUMB_SHARE = 0.10
"""What is below the first is no object; when all such pieces together are above the second, they are no strays either."""

_LONELY = 2.2
"""A point so many times lonelier than its neighbours is a stray beside the surface.  At 10:1 in density, surface points stay below."""

_LONELIEST = 5.0
"""The same against the whole cloud: strays among strays."""

_SAMPLE = 2000
_CELLS = 150_000
_MOST_PIECES = 1000

_FLAT = 0.01
_THIN = 0.1

_DEEP_SHARE = 0.04
"""Of the points deeper than half the greatest depth: bodies filled with points have more than 0.05, surfaces with a noise of a
quarter of their radius less than 0.025."""

_LEAST_NEAR, _LEAST_NEAR_OPEN = 0.6, 0.4
"""Share of the surface that lies near points.  A dental arch without its base has 0.66 and is whole for who scanned it on a
table; a half-shell has 0.69 and cannot be told from a dome that stands there.  Less is a scan from one side, or a curve."""

_MOST_NOISE = 1.2
"""Noise in volume by area, a third of the radius of a ball.  A ball with a noise of a quarter of its radius has 0.75."""

_SMALL_MM, _LARGE_MM = 3.0, 1000.0
_TYPICAL_MM = 40.0
_FAR_EXTENTS, _FAR_MM = 1000.0, 1e5


@dataclass(frozen=True, slots=True, eq=False)
class Accepted:
    """A cloud that may become a surface.

    Attributes
    ----------
    points : (m, 3) float64 mm about `centre_mm`, each place once, without strays, in the order of the cloud, on a fine grid
    index : (m,) int64, which points of the cloud they are; the first of equal ones
    centre_mm : (3,) middle of the box around them, in the object frame
    strays : points that were left out because they lie far from the object
    remarks : for the report
    """

    points: Array
    index: Labels
    centre_mm: Array
    strays: int
    remarks: tuple[Remark, ...]


def accept(given: NDArray[np.floating], seed: int, check: Callable[[], None]) -> Accepted:
    """The points to work with, from (n, 3) coordinates in mm.

    `check` is called between the steps and may raise to stop.

    Raises
    ------
    ReconstructionError
        E-REC-01 too few points, E-REC-02 flat, E-REC-04 not finite, E-REC-05 more than one object.
    """
    everything = np.asarray(given, np.float64).reshape(-1, 3)
    broken = int(np.count_nonzero(~(np.abs(everything) <= _FARTHEST_MM)))
    if broken:
        raise ReconstructionError("E-REC-04", count=broken)
    if len(everything) < LEAST_POINTS:
        raise ReconstructionError("E-REC-01", points=len(everything), least=LEAST_POINTS)
    check()
    distinct, copies = weld(everything)
    first = np.unique(copies, return_index=True)[1]
    check()
    if len(distinct) < LEAST_POINTS:
        raise ReconstructionError("E-REC-01", points=f"{len(distinct)} different", least=LEAST_POINTS)
    remarks = []
    if len(distinct) < len(everything):
        remarks.append(Remark(RemarkKind.COPIES, {"share": _percent(1 - len(distinct) / len(everything))}))

    # Far from the origin squares and products lose the digits that matter, so all that follows is about a middle.
    near = distinct - np.median(distinct, axis=0)
    spacing = _spacing(near, seed)
    check()
    strays, link = _strays(near, spacing, check)
    kept = distinct[~strays]
    if len(kept) < LEAST_POINTS:
        raise ReconstructionError("E-REC-01", points=f"{len(kept)} connected", least=LEAST_POINTS)
    lost = int(np.count_nonzero(strays))
    if lost:
        fields = {"count": str(lost), "share": _percent(lost / len(distinct)), "link_mm": f"{link:.3g}"}
        remarks.append(Remark(RemarkKind.STRAYS, fields))
    low, high = kept.min(axis=0), kept.max(axis=0)
    centre = 0.5 * (low + high)
    extent = float((high - low).max())
    points = _on_grid(kept - centre, extent)
    noise = _thickness(points, seed)
    check()
    if _is_flat(points, noise):
        raise ReconstructionError("E-REC-02", reason="they lie in a plane or on a line")
    remarks += _size_remarks(extent) + _place_remarks(centre, extent) + _step_remarks(kept, centre, min(noise, spacing))
    return Accepted(points, first[~strays], centre, lost, tuple(remarks))


def _on_grid(points: Array, extent_mm: float) -> Array:
    """Points about their middle, (n, 3), rounded to about the four-millionth of their extent: 5 nm for an ear.

    The phases decide by comparisons, and the last bit of one coordinate can change which triangles there are.  Rounded like
    this, a cloud in other units or at another place gives the same mesh, unless a coordinate lies just between two steps.
    """
    step = 2.0 ** np.round(np.log2(extent_mm) - 22)
    return np.asarray(np.round(points / step) * step)


# --------------------------------------------------------------------------------------------- objects and strays


def _spacing(points: Array, seed: int) -> float:
    """Side of the square that one of (n, 3) different points stands for, mm; never zero.

    From the k-th neighbours, as if the points were spread over a plane.  For points on a surface every k says the same;
    where they stand in lines or clumps a small k sees these only, so the largest answer holds.
    """
    tree = cKDTree(points)
    sample = _sampled(points, seed)
    counts = [k for k in (8, 32, 128) if k == 8 or 16 * k <= len(points)]
    away = tree.query(sample, k=[k + 1 for k in counts])[0]
    return float(max(np.median(away, axis=0) / np.sqrt(np.array(counts) / np.pi)))


def _strays(points: Array, spacing_mm: float, check: Callable[[], None]) -> tuple[Mask, float]:
    """Which of (n, 3) points belong to no object, and the gap in mm that decided; E-REC-05 for more than one object."""
    low, high = np.quantile(points, [0.01, 0.99], axis=0)
    link = max(_LINK * spacing_mm, _LINK_SHARE * float((high - low).max()))
    while True:
        pieces = _pieces(points, link, check)
        if pieces is not None:
            labels, lonely = pieces
            sizes = np.bincount(labels[labels >= 0])
            objects = np.flatnonzero(sizes > _OBJECT_SHARE * len(points))
            objects = objects[np.argsort(-sizes[objects], kind="stable")]
            crumbs = len(points) - int(sizes[objects].sum())
            # Several pieces of which the largest is a line or a sheet are the contours or the faces of one object.
            if crumbs <= _CRUMB_SHARE * len(points) and (len(objects) == 1 or not _is_flat(points[labels == objects[0]], 0.0)):
                break
        link *= 2
    if len(objects) > 1:
        first, second = objects[:2]
        gap = _gap(points[(labels == first) & ~lonely], points[(labels == second) & ~lonely])
        raise ReconstructionError("E-REC-05", count=len(objects), share=f"{100 * sizes[second] / len(points):.0f}", gap_mm=f"{gap:.3g}")
    return labels != objects[0], link


def _gap(one: Array, two: Array) -> float:
    """Least distance between two clouds, mm."""
    tree = cKDTree(one)
    # A neighbour far away is dear to find, one within a bound is cheap: a few points give the bound for all.
    bound = float(tree.query(two[:: max(1, len(two) // 200)])[0].min())
    return min(bound, float(tree.query(two, distance_upper_bound=bound)[0].min()))


def _pieces(points: Array, link_mm: float, check: Callable[[], None]) -> tuple[Labels, Mask] | None:
    """Single linkage: the piece of each of (n, 3) points, (n,), -1 for a lonely one far from all pieces, and which are
    lonely, (n,); None when there are too many pieces.

    The links run between one point for each small cell, so that a million points cost no more than a hundred thousand.
    """
    side = link_mm / 40 if len(points) <= _CELLS else 0.12 * link_mm * np.sqrt(len(points) / _CELLS)
    first, cell = _cells(points, side)
    while len(first) > _CELLS:
        side *= np.sqrt(1.2 * len(first) / _CELLS)
        first, cell = _cells(points, side)
    check()
    chosen = points[first]
    around = min(9, len(chosen))
    away, near = cKDTree(chosen).query(chosen, k=around)
    check()
    reach = away[:, -1]
    lonely = (reach > _LONELY * np.median(reach[near[:, 1:]], axis=1)) | (reach > max(_LONELIEST * float(np.median(reach)), link_mm))
    start, to = np.repeat(np.arange(len(chosen)), around - 1), near[:, 1:].ravel()
    linked = (away[:, 1:].ravel() <= link_mm) & ~lonely[start] & ~lonely[to]
    graph = coo_array((np.ones(int(linked.sum()), np.int8), (start[linked], to[linked])), shape=(len(chosen), len(chosen)))
    _, labels = connected_components(graph, directed=False)
    labels[~lonely] = np.unique(labels[~lonely], return_inverse=True)[1]
    labels = labels.astype(np.int64)
    labels[lonely] = -1
    if labels.max() >= _MOST_PIECES:
        return None
    core = ~lonely[cell]
    labels = _joined(points[core], labels, labels[cell][core], link_mm, check)
    if lonely.any():  # what is lonely belongs to the piece that it lies at
        whole = np.flatnonzero(~lonely)
        distance, nearest = cKDTree(chosen[whole]).query(chosen[lonely], distance_upper_bound=link_mm)
        labels[lonely] = np.append(labels[whole], -1)[np.where(np.isfinite(distance), nearest, len(whole))]
    return labels[cell], ~core


def _cells(points: Array, side_mm: float) -> tuple[Labels, Labels]:
    """The first point in each occupied cell of a grid, (c,), and the cell of each point, (n,)."""
    place = np.floor((points - points.min(axis=0)) / side_mm)
    bits = 20
    if float(place.max()) < 2**bits:
        whole = place.astype(np.int64)
        _, first, cell = np.unique((whole[:, 0] << 2 * bits) | (whole[:, 1] << bits) | whole[:, 2], return_index=True, return_inverse=True)
        return first, cell
    # A far stray makes more cells on an axis than one integer can number.
    _, cell = weld(place)
    first = np.full(int(cell.max()) + 1, -1, np.int64)
    first[cell[::-1]] = np.arange(len(points))[::-1]
    return first, cell


def _joined(points: Array, labels: Labels, of_point: Labels, link_mm: float, check: Callable[[], None]) -> Labels:
    """Join pieces of which two points are within the link; `of_point` is the piece of each of (n, 3) points, all >= 0."""
    count = int(of_point.max()) + 1
    if count == 1:
        return labels
    order = np.argsort(of_point, kind="stable")
    members = np.split(points[order], np.searchsorted(of_point[order], np.arange(1, count)))
    low, high = (np.array([edge(part, axis=0) for part in members]) for edge in (np.min, np.max))
    between = np.maximum(0, np.maximum(low[:, None] - high[None], low[None] - high[:, None]))
    one, two = np.nonzero(np.triu((between**2).sum(axis=2) <= link_mm**2, 1))
    trees: dict[int, cKDTree] = {}
    near = np.zeros(len(one), bool)
    for row, (a, b) in enumerate(zip(one.tolist(), two.tolist(), strict=True)):
        small, large = (a, b) if len(members[a]) < len(members[b]) else (b, a)
        if large not in trees:
            check()
            trees[large] = cKDTree(members[large])
        near[row] = np.isfinite(trees[large].query(members[small], distance_upper_bound=link_mm)[0]).any()
    graph = coo_array((np.ones(int(near.sum()), np.int8), (one[near], two[near])), shape=(count, count))
    _, joined = connected_components(graph, directed=False)
    return np.where(labels >= 0, joined[labels], -1).astype(np.int64)


# --------------------------------------------------------------------------------------------- flatness


def _thickness(points: Array, seed: int) -> float:
    """Thickness of the cloud, one sigma, mm: across neighbourhoods that are five times as wide as they are thick."""
    tree = cKDTree(points)
    sample = _sampled(points, seed)
    most = min(len(points), 600)
    neighbours = min(12, most)
    while True:
        away, which = tree.query(sample, k=neighbours)
        patch = points[which]
        patch = patch - patch.mean(axis=1, keepdims=True)
        spread = np.linalg.eigvalsh(np.einsum("nki,nkj->nij", patch, patch) / (neighbours - 3))
        sigma = float(np.sqrt(np.median(np.maximum(spread[:, 0], 0))))
        if float(np.median(away[:, -1])) >= 5 * sigma or neighbours == most:
            return sigma
        neighbours = min(2 * neighbours, most)


def _is_flat(points: Array, noise_mm: float) -> bool:
    """Whether (n, 3) points lie in a plane or on a line, up to their noise and a few strays."""
    inner = points
    for _ in range(3):
        middle = inner.mean(axis=0)
        axes = np.linalg.svd((inner - middle).T, full_matrices=False)[0]
        across = np.abs((points - middle) @ axes[:, 2])
        inner = points[across <= np.quantile(across, 0.97)]
    longest = float(((inner - inner.mean(axis=0)) @ axes[:, 0]).std())
    thick = float(np.quantile(across, 0.95)) / 1.96
    return thick <= _FLAT * longest or (thick <= _THIN * longest and thick <= 1.5 * noise_mm)


# --------------------------------------------------------------------------------------------- later checks


def check_hollow(depths_mm: NDArray[np.floating], deepest_mm: float) -> None:
    """Refuse points that fill a volume (E-REC-02), by their depths in the region that they enclose, (n,) mm, and its greatest depth.

    Points on a surface lie at depth zero, give or take their noise; points that fill a body lie everywhere in it.
    """
    share = float((depths_mm > 0.5 * deepest_mm).mean())
    if share > _DEEP_SHARE:
        raise ReconstructionError("E-REC-02", reason=f"{100 * share:.0f} % of them lie deep inside, where the scan of a surface has none")


def check_fit(mesh: TriangleMesh, supported: Mask, noise_mm: float, *, standing: bool, open_holes: bool) -> None:
    """Refuse a fitted surface that the points do not bear (E-REC-02, or E-REC-03 when none of it can be confirmed).

    Parameters
    ----------
    mesh : the surface
    supported : which of its vertices the points bear out, (v,)
    noise_mm : one sigma of the points about the surface
    standing : whether the object is known to stand on a table, which hides its base
    open_holes : whether the parts without points are left open anyway
    """
    areas = mesh.areas()
    area = float(areas.sum())
    share = float((areas * supported[mesh.triangles].mean(axis=1)).sum()) / area
    if share < (_LEAST_NEAR_OPEN if standing or open_holes else _LEAST_NEAR):
        raise ReconstructionError("E-REC-02", reason=f"they cover only {100 * share:.0f} % of the surface that closes round them")
    if noise_mm > _MOST_NOISE * mesh.volume() / area:
        raise ReconstructionError("E-REC-02", reason=f"they scatter by {noise_mm:.2g} mm about a surface that is hardly thicker itself")
    if not supported[mesh.triangles].all(axis=1).any():
        raise ReconstructionError("E-REC-03", reason="no part of it can be confirmed by the points", do="scan the object more densely")


# --------------------------------------------------------------------------------------------- remarks


def _size_remarks(extent_mm: float) -> list[Remark]:
    """For a largest extent that no anatomical part has."""
    if extent_mm > _LARGE_MM:
        return [Remark(RemarkKind.LARGE, {"extent_mm": f"{extent_mm:.4g}"})]
    if extent_mm >= _SMALL_MM:
        return []
    unit, option = min((("metres", "m", 1000.0), ("inches", "inch", 25.4)), key=lambda unit: abs(np.log(extent_mm * unit[2] / _TYPICAL_MM)))[:2]
    return [Remark(RemarkKind.SMALL, {"extent_mm": f"{extent_mm:.3g}", "unit": unit, "option": option})]


def _place_remarks(centre_mm: Array, extent_mm: float) -> list[Remark]:
    """For an origin so far away that single precision loses digits."""
    away = float(np.linalg.norm(centre_mm))
    if away <= min(_FAR_EXTENTS * extent_mm, _FAR_MM):
        return []
    return [Remark(RemarkKind.FAR, {"away_mm": f"{away:.4g}"})]


def _step_remarks(points: Array, centre_mm: Array, matters_mm: float) -> list[Remark]:
    """For coordinates that were in single precision far from the origin, whatever their unit was: steps of 2^-24 to 2^-23 of their size."""
    steps = []
    for axis in range(3):
        gaps = np.diff(np.unique(points[:, axis]))
        step = float(gaps.min()) if len(gaps) else 0.0
        if 5e-8 * abs(centre_mm[axis]) < step < 1.3e-7 * abs(centre_mm[axis]):
            steps.append(step)
    if not steps or max(steps) <= 0.1 * matters_mm:
        return []
    return [Remark(RemarkKind.ROUNDED, {"step_mm": f"{max(steps):.3g}"})]


def _sampled(points: Array, seed: int) -> Array:
    if len(points) <= _SAMPLE:
        return points
    return points[np.sort(np.random.default_rng(seed).choice(len(points), _SAMPLE, replace=False))]


def _percent(share: float) -> str:
    return f"{100 * share:.0f} %" if share >= 0.095 else f"{100 * share:.2g} %"
