"""The specimen in another mount: turned or tilted by hand, and put onto the table again."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.errors import UsageError
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.virtual.specimens.artefacts import put_down_anew
from scanner_core.virtual.specimens.specimen import Specimen

Array = NDArray[np.float64]

_RANDOM = "random"
_OFF_CENTRE_MM = 1.0
"""A person finds the middle of the table to about so much, per coordinate."""


def remounted(specimen: Specimen, pose: str) -> Specimen:
    """The specimen as a person has put it down anew; its :attr:`~Specimen.pose` tells how.

    Parameters
    ----------
    pose : ``RX,RY,RZ``, turns in degrees about the table's x, then y, then z, after which it stands in the middle of the
        table; or ``random:SEED``, a turn out of all that there are, put down up to 1 mm beside the middle

    Raises
    ------
    UsageError
        E-USE-01 when `pose` is neither.
    """
    turn, beside = _random(pose) if pose.startswith(_RANDOM) else (turns(pose), np.zeros(2))
    vertices = turn.apply(specimen.mesh.vertices)
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    shift = np.array([*beside - 0.5 * (low + high)[:2], -low[2]])
    return put_down_anew(specimen, RigidTransform(turn.rotation, shift))


def turns(pose: str) -> RigidTransform:
    """The turn of a pose ``RX,RY,RZ``; E-USE-01 when it is none."""
    try:
        angles = np.radians([float(part) for part in pose.split(",")])
    except ValueError:
        raise _refused(pose) from None
    if angles.shape != (3,) or not np.isfinite(angles).all():
        raise _refused(pose)
    x, y, z = (RigidTransform.from_vector(angle * axis, np.zeros(3)) for angle, axis in zip(angles, np.eye(3), strict=True))
    return z @ y @ x


def _random(pose: str) -> tuple[RigidTransform, Array]:
    name, _, number = pose.partition(":")
    if name != _RANDOM or not (number.isascii() and number.isdecimal()):
        raise _refused(pose)
    rng = np.random.default_rng([int(number), 0x3E70])
    quaternion = rng.normal(size=4)  # of any length: its direction is uniform over all turns
    sine = float(np.linalg.norm(quaternion[1:]))
    angle = 2 * np.arctan2(sine, quaternion[0])
    turn = RigidTransform.from_vector(angle / sine * quaternion[1:], np.zeros(3))
    return turn, rng.uniform(-_OFF_CENTRE_MM, _OFF_CENTRE_MM, 2)


def _refused(pose: str) -> UsageError:
    return UsageError("E-USE-01", what=f"There is no pose '{pose}'", do="write three angles in degrees, as in 90,0,20, or random:SEED")
