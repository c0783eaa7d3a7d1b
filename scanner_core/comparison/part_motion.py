"""The rigid motion of a part of the surface, a tooth, and how well it is known."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.comparison.alignment import Alignment
from scanner_core.comparison.arch_frame import arch_frame
from scanner_core.comparison.area import PartMotion
from scanner_core.comparison.concavity import Concavity
from scanner_core.comparison.measuring import LEAST_NOISE_UM
from scanner_core.comparison.part_fit import PartFit, PartFitter
from scanner_core.comparison.part_refinement import PartRefinement
from scanner_core.comparison.surface import ComparedSurface
from scanner_core.comparison.surface_smoothing import SurfaceSmoother
from scanner_core.errors import ComparisonError
from scanner_core.geometry.edges import EdgeTable
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.rigid import RigidTransform

Array = NDArray[np.float64]
LEAST_VERTICES = 30
"""Five for each of the six unknowns."""
CENTRE_BELOW_MM = 2.5
"""From the middle of a crown's free part down to the middle of the whole crown, half of which the gum and the neighbours hide: there
a tooth that only tips has moved little."""


def part_motion(before: ComparedSurface, after: ComparedSurface, alignment: Alignment, part: NDArray[np.bool_]) -> PartMotion:
    """Rigid motion of the marked vertices `part` (v_after,) from before to after.

    The part, without the rims where furrows bound it and the gum bends it, is fitted back onto the before surface from where it
    lies, with robust weights: gum that was marked along, and what is not to be seen on both surfaces, falls out.

    Raises
    ------
    ComparisonError
        ``E-CMP-10`` when fewer than `LEAST_VERTICES` vertices that are a measurement are marked.
    """
    marked = part & after.supported
    if marked.sum() < LEAST_VERTICES:
        raise ComparisonError("E-CMP-10", marked=int(marked.sum()), least=LEAST_VERTICES)
    mesh = TriangleMesh(alignment.transform.apply(after.mesh.vertices), after.mesh.triangles)
    table = EdgeTable.of(mesh.triangles)
    smoother = SurfaceSmoother(mesh, table)
    core = marked & Concavity(mesh, smoother, table).core(marked.astype(np.int64), marked)
    rigid = core if core.sum() >= LEAST_VERTICES else marked
    which = np.flatnonzero(rigid)
    frame = arch_frame(before.mesh, before.supported)
    middle = mesh.vertices[marked].mean(axis=0)
    noise_mm = max(alignment.noise_um, LEAST_NOISE_UM) / 1e3
    fit = PartFitter(before.mesh).fit(mesh.vertices[which], mesh.vertex_normals()[which], noise_mm)
    fit = PartRefinement(before.mesh, mesh).refine(fit, rigid, noise_mm, alignment.correlation_length_mm)
    area = float(smoother.area_mm2[which].sum())
    return motion_of_fit(fit, middle, area, alignment, None if frame is None else frame.up)


def motion_of_fit(fit: PartFit, middle: Array, area_mm2: float, alignment: Alignment, up: Array | None) -> PartMotion:
    """The motion that a fit of points over `area_mm2` tells, of a part with its `middle` (3,) on the aligned after surface.

    `up` (3,) is the way out of the gum on an arch, None elsewhere.

    The covariance is the fit's own, see `PartRefinement`, or where it was not refined s^2 (J^T W J)^-1 times the number of points that
    share one error: with noise alike as ``exp(-h^2 / l^2)``, 1 + pi l^2 per area of a point.  The alignment's own covariance at the
    part's place is added.  The uncertainties that are told are those along the displacement and about the axis.
    """
    back = fit.transform
    motion = back.inverse()
    centre = back.apply(middle if up is None else middle - CENTRE_BELOW_MM * up)
    displacement = motion.apply(centre) - centre
    own = _moved_to(_covariance(fit, area_mm2, alignment) if fit.covariance is None else fit.covariance, fit.centre, centre)
    covariance = own + _moved_to(alignment.covariance, alignment.centre, centre)
    angle = motion.angle_deg()
    axis = _axis(motion)
    rms = float(np.sqrt(np.average(fit.residual_mm**2, weights=fit.weights))) if fit.weights.sum() > 0 else float("nan")
    length = float(np.linalg.norm(displacement))
    direction = displacement / length if length > 1e-9 else np.zeros(3)
    along = direction @ covariance[3:, 3:] @ direction if length > 1e-9 else np.trace(covariance[3:, 3:]) / 3
    about = axis @ covariance[:3, :3] @ axis
    return PartMotion(motion, centre, displacement, angle, axis, float(1e3 * np.sqrt(along)), float(np.degrees(np.sqrt(about))), 1e3 * rms)


def _covariance(fit: PartFit, area_mm2: float, alignment: Alignment) -> Array:
    """(6, 6) about the fit's centre: s^2 (J^T W J)^-1, times the number of points that share one error.

    Noise that is alike as ``exp(-h^2 / l^2)`` counts as one over ``pi l^2``.
    """
    weights = fit.weights
    rms = float(np.sqrt(np.average(fit.residual_mm**2, weights=weights))) if weights.sum() > 0 else float("nan")
    # the weights themselves cut the tails off the residuals: the alignment's noise, which did not, is the least
    noise = max(rms, alignment.noise_um / 1e3 if weights.mean() > 0.5 else 0.0, LEAST_NOISE_UM / 1e3)
    shared = 1 + np.pi * alignment.correlation_length_mm**2 * len(weights) / max(area_mm2, 1e-9)
    information = (fit.jacobian * weights[:, None]).T @ fit.jacobian
    return np.asarray(noise**2 * shared * np.linalg.pinv(information, rcond=1e-12, hermitian=True))


def _moved_to(covariance: Array, centre: Array, place: Array) -> Array:
    """A motion's covariance (6, 6), its rotation taken about `place` (3,) instead of `centre` (3,)."""
    arm = place - centre
    moving = np.eye(6)
    moving[3:, :3] = -np.array([[0.0, -arm[2], arm[1]], [arm[2], 0.0, -arm[0]], [-arm[1], arm[0], 0.0]])
    return np.asarray(moving @ covariance @ moving.T)


def _axis(motion: RigidTransform) -> Array:
    """Unit axis (3,) of the rotation; +z where there is none."""
    values, vectors = np.linalg.eig(motion.rotation)
    axis = np.real(vectors[:, np.argmin(np.abs(values - 1))])
    skew = motion.rotation - motion.rotation.T
    turning = np.array([skew[2, 1], skew[0, 2], skew[1, 0]])
    length = float(np.linalg.norm(turning))
    if length < 1e-12:
        return np.array([0.0, 0.0, 1.0])
    return np.asarray(axis if axis @ turning > 0 else -axis)
