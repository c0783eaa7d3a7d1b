"""What ``demo`` and ``reconstruct`` share: the job in the worker process with its progress, and the words for it."""

from __future__ import annotations

from scanner_core.commands.console import Console
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.jobs.blocking import run_in_worker
from scanner_core.jobs.progress import Progress
from scanner_core.reconstruction.job import ReconstructionRequest
from scanner_core.reconstruction.parameters import ReconstructionParameters
from scanner_core.reconstruction.pipeline import Reconstruction


def run_reconstruction(console: Console, cloud: PointCloud, parameters: ReconstructionParameters) -> Reconstruction:
    """Reconstruct in the worker process; Ctrl-C ends it within a second."""

    def show(progress: Progress) -> None:
        console.progress(progress.phase, progress.fraction, progress.seconds_left)

    result = run_in_worker("reconstruct", ReconstructionRequest(cloud, parameters), progress=show, cancelled=lambda: False)
    console.clear()
    if not isinstance(result, Reconstruction):
        raise TypeError(f"the worker answered with {type(result).__name__}")
    return result


def reconstruction_summary(values: dict[str, object]) -> list[str]:
    """The report in words; `values` is the JSON of ``reconstruct``."""
    phases = ", ".join(f"{phase['name']} {phase['seconds']:.1f} s" for phase in values["phases"])  # type: ignore[attr-defined]
    return [
        f"Surface: {values['triangles']} triangles, {'closed' if values['closed'] else 'open'}, "
        f"{100 * float(str(values['supported_area_fraction'])):.1f} % supported by data, "
        f"residual {float(str(values['residual_rms_um'])):.1f} um, expected error {float(str(values['expected_error_rms_um'])):.1f} um rms.",
        f"Phases: {phases}.",
    ] + [f"Note: {warning}" for warning in values["warnings"]]  # type: ignore[attr-defined]
