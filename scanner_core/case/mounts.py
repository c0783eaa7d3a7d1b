"""How the object stood: the mounts of a case, and where the object frame of each lies in that of the first.

A person has turned or tilted the object between two mounts, so each has an object frame of its own.  A mount's points join
those of the others once its pose was accepted; until then they are kept, and take no part.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence

from scanner_core.case import decoding
from scanner_core.case.database import CaseDatabase, note
from scanner_core.case.decoding import damaged, text
from scanner_core.case.observation import MEASURED
from scanner_core.case.records import MountPose
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.wall_clock import stamp


class MountTables(CaseDatabase):
    """Mounts and their poses; those that were found before stay."""

    def next_mount(self) -> int:
        """The number of the mount after all that have a measured point."""
        mounts = [mount for _, mount in self._measured_scans()]
        return max(mounts) + 1 if mounts else 0

    def first_mount(self) -> int:
        """The first mount that has a measured point: its object frame is that of the case."""
        return min((mount for _, mount in self._measured_scans()), default=0)

    def put_mount_poses(
        self,
        poses: Sequence[tuple[int, RigidTransform | None, dict[str, object]]],
        corrections: Mapping[int, Mapping[int, RigidTransform]] | None = None,
    ) -> None:
        """Keep how mounts lie, with the corrections of the views that were found together with it, all of it or nothing.

        Parameters
        ----------
        poses : mount; its object frame to that of mount 0, mm, None when it was not accepted; the report
        corrections : by scan id and view, object frame to object frame of the scan's own mount
        """
        with self._transaction() as connection:
            for mount, pose, report in poses:
                connection.execute(
                    "INSERT INTO mount_pose (mount, created, transform_json, report_json) VALUES (?, ?, ?, ?)",
                    (mount, stamp(), None if pose is None else _matrix(pose), json.dumps(report)),
                )
                note(connection, "mount registered", f"mount {mount}, {'not accepted' if pose is None else 'accepted'}")
            rows = [(_matrix(motion), scan, view) for scan, motions in (corrections or {}).items() for view, motion in motions.items()]
            connection.executemany("UPDATE view SET correction_json = ? WHERE scan_id = ? AND view = ?", rows)

    def mount_poses(self) -> dict[int, MountPose]:
        """The newest pose of every mount that was registered."""
        rows = self._rows("SELECT mount, created, transform_json, report_json FROM mount_pose ORDER BY id")
        with damaged(self.path, "pose of a mount"):
            return {
                decoding.mount(mount): MountPose(
                    decoding.mount(mount), text(created), None if matrix is None else decoding.correction(matrix), decoding.table(report)
                )
                for mount, created, matrix, report in rows
            }

    def counting_scans(self, without: Iterable[int] = ()) -> list[int]:
        """Ids of the scans whose points are the object's as long as nobody chose others, ascending.

        Of every mount the newest scan that has points; of the mounts the first, and those whose pose relative to it was accepted.

        Parameters
        ----------
        without : ids of scans that were discarded
        """
        left_out = set(without)
        newest = {mount: number for number, mount in self._measured_scans() if number not in left_out}
        if not newest:
            return []
        first, poses = self.first_mount(), self.mount_poses()
        if first not in newest:  # all of its scans were discarded: another one alone
            first = min(newest)
        joined = {mount for mount, pose in poses.items() if pose.in_frame_of(first) is not None} | {first}
        return sorted(number for mount, number in newest.items() if mount in joined)

    def _measured_scans(self) -> list[tuple[int, int]]:
        """Ids and mounts of the scans that have points, in the order of the ids."""
        rows = self._rows(
            "SELECT id, mount FROM scan WHERE kind = 'scan' AND (EXISTS (SELECT 1 FROM observation "
            "JOIN verdict ON verdict.id = verdict WHERE scan_id = scan.id AND name = ?1) OR EXISTS (SELECT 1 FROM stripe_point "
            "JOIN verdict ON verdict.id = verdict WHERE scan_id = scan.id AND name = ?1)) ORDER BY id",
            (MEASURED,),
        )
        with damaged(self.path, "list of scans"):
            return [(int(number), decoding.mount(mount)) for number, mount in rows]


def _matrix(motion: RigidTransform) -> str:
    return json.dumps(motion.matrix().tolist())
