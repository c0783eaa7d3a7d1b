"""What a reconstruction says of itself."""

from __future__ import annotations

from dataclasses import dataclass

from scanner_core.geometry.distance_histogram import DistanceHistogram
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.reconstruction.remarks import Remark


@dataclass(frozen=True, slots=True)
class Phase:
    """One of the three phases: its seconds, and the triangles at its end."""

    name: str
    seconds: float
    triangles: int


@dataclass(frozen=True, slots=True)
class ReconstructionReport:
    """The figures of one reconstruction; the attributes are the keys of the JSON of ``impronta reconstruct``.

    ``facet_sag_um`` is what 95 of 100 facets depart from the rounded surface at most, ``distances`` are those of some of the points
    from the mesh, without their sign, and ``volume_mm3`` is 0 for a mesh that was left open.  ``stopped_early`` tells that a person
    wanted no better surface: it is whole, and coarser than the points allow.
    ``noise_sigma_um`` is along the normal, ``residual_rms_um`` from the points to the mesh without rejected ones, and
    ``expected_error_rms_um`` what the mesh is predicted to be off the unknown truth, over the supported surface.
    """

    points: int
    outliers_rejected: int
    noise_sigma_um: float
    vertices: int
    triangles: int
    closed: bool
    genus: int
    self_intersections: int
    supported_area_fraction: float
    residual_rms_um: float
    expected_error_rms_um: float
    phases: tuple[Phase, ...]
    seconds: float
    peak_memory_mb: float
    volume_mm3: float
    facet_sag_um: float
    stopped_early: bool = False
    distances: DistanceHistogram | None = None
    remarks: tuple[Remark, ...] = ()

    @property
    def warnings(self) -> tuple[str, ...]:
        """What is remarked, as sentences."""
        return tuple(remark.words() for remark in self.remarks)

    def as_dict(self) -> dict[str, object]:
        """For JSON."""
        return {
            "points": self.points,
            "outliers_rejected": self.outliers_rejected,
            "noise_sigma_um": round(self.noise_sigma_um, 2),
            "vertices": self.vertices,
            "triangles": self.triangles,
            "closed": self.closed,
            "genus": self.genus,
            "self_intersections": self.self_intersections,
            "supported_area_fraction": round(self.supported_area_fraction, 4),
            "residual_rms_um": round(self.residual_rms_um, 2),
            "expected_error_rms_um": round(self.expected_error_rms_um, 2),
            "phases": [{"name": p.name, "seconds": round(p.seconds, 3), "triangles": p.triangles} for p in self.phases],
            "seconds": round(self.seconds, 3),
            "peak_memory_mb": round(self.peak_memory_mb, 1),
            "volume_mm3": round(self.volume_mm3, 3),
            "facet_sag_um": round(self.facet_sag_um, 2),
            "stopped_early": self.stopped_early,
            "distances": None if self.distances is None else self.distances.as_dict(),
            "warnings": list(self.warnings),
            "remarks": [remark.as_dict() for remark in self.remarks],
        }


@dataclass(frozen=True, slots=True, eq=False)
class Reconstruction:
    """A closed mesh with ``standard_uncertainty_um`` (float32) and ``supported`` (uint8) at every vertex, and its report."""

    mesh: TriangleMesh
    report: ReconstructionReport
