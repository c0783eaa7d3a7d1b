"""Who puts the artefacts onto the table: a person, or the virtual bench in her place."""

from __future__ import annotations

from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.errors import AcquisitionError
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.virtual.bench import VirtualBench
from scanner_core.virtual.specimens import Specimen, load_specimen
from scanner_core.virtual.specimens.artefacts import ball_bar, plate, put_down_anew

Array = NDArray[np.float64]

_REMOUNT_MM = 1.0
"""How far a person misses the middle of the table, at most, in x and y."""


class ArtefactOperator(Protocol):
    """Places the artefacts of the tests; every call returns when the artefact stands.  Frames are the table's, mm."""

    def put_plate(self, centre: Array, normal: Array) -> None:
        """The matt white plate, its middle about `centre` (3,), facing along `normal` (3,)."""
        ...

    def put_sphere(self, index: int) -> None:
        """The reference sphere in the middle of the table, taken away and put down anew for every acquisition."""
        ...

    def put_bar(self, centres: Array, radius_mm: float) -> None:
        """The ball bar, its spheres about `centres` (2, 3)."""
        ...


class BenchArtefacts:
    """The virtual bench's artefacts.

    Parameters
    ----------
    specimen : what :meth:`put_sphere` puts down
    seed : of where exactly a person puts it down
    """

    def __init__(self, bench: VirtualBench, specimen: Specimen | None = None, seed: int = 0) -> None:
        self._bench = bench
        self._specimen = specimen
        self._seed = seed

    def put_plate(self, centre: Array, normal: Array) -> None:
        self._bench.change_specimen(plate(centre, normal))

    def put_sphere(self, index: int) -> None:
        """Turned at random and off the middle by up to a millimetre; the speckle and the surface term change with it."""
        if self._specimen is None:
            self._specimen = load_specimen("sphere")
        rng = np.random.default_rng([self._seed, index, 0xA57])
        turn = RigidTransform.about_z(float(rng.uniform(0, 360)))
        shift = np.array([*rng.uniform(-_REMOUNT_MM, _REMOUNT_MM, 2), 0.0])
        self._bench.change_specimen(put_down_anew(self._specimen, RigidTransform(turn.rotation, shift)))

    def put_bar(self, centres: Array, radius_mm: float) -> None:
        self._bench.change_specimen(ball_bar(centres, radius_mm))


class StandingArtefacts:
    """What is to be measured stands there already: somebody has put it down, or a recording shows it."""

    def put_plate(self, centre: Array, normal: Array) -> None:
        pass

    def put_sphere(self, index: int) -> None:
        pass

    def put_bar(self, centres: Array, radius_mm: float) -> None:
        pass


def operator_for(rig: OpenRig, operator: ArtefactOperator | None, specimen: Specimen | None = None) -> ArtefactOperator:
    """The operator that was given, the virtual bench's, or nobody where everything is replayed.

    Raises
    ------
    AcquisitionError
        E-MET-01 when nobody can place the artefacts.
    """
    if operator is not None:
        return operator
    if rig.replayed:
        return StandingArtefacts()
    if rig.bench is None:
        raise AcquisitionError("E-MET-01")
    return BenchArtefacts(rig.bench, specimen, rig.bench.seed)
