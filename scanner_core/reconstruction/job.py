"""The reconstruction as a job of the worker process."""

from __future__ import annotations

from dataclasses import dataclass

from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.jobs.progress import IsCancelled, IsEnough, OnProgress, never
from scanner_core.reconstruction.parameters import ReconstructionParameters
from scanner_core.reconstruction.pipeline import Reconstruction, reconstruct


@dataclass(frozen=True, slots=True, eq=False)
class ReconstructionRequest:
    """What the worker is asked for."""

    cloud: PointCloud
    parameters: ReconstructionParameters


def run(request: ReconstructionRequest, *, progress: OnProgress, cancelled: IsCancelled, enough: IsEnough = never) -> Reconstruction:
    """See :func:`scanner_core.reconstruction.pipeline.reconstruct`."""
    return reconstruct(request.cloud, request.parameters, progress=progress, cancelled=cancelled, enough=enough)
