"""The specimen of the virtual rig is tipped as a person is told to tip a real one."""

from __future__ import annotations

from scipy.spatial.transform import Rotation

from scanner_core.geometry.rigid import RigidTransform
from scanner_core.virtual.specimens.remounting import turns


def tipped_pose(turn: RigidTransform, pose: str | None = None) -> str:
    """The pose, as :func:`~scanner_core.virtual.specimens.remounting.remounted` takes it, after a further turn.

    Parameters
    ----------
    turn : from how the specimen stands to how it shall, table frame
    pose : how it stands; None as it came
    """
    before = RigidTransform.identity() if pose is None else turns(pose)
    angles = Rotation.from_matrix((turn @ before).rotation).as_euler("xyz", degrees=True)
    return ",".join(f"{angle:.3f}" for angle in angles)
