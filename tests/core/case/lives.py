"""Whole lives of a case, and what of them has to be there after a crash."""

from __future__ import annotations

import sqlite3
from collections.abc import Callable, Iterator
from contextlib import closing
from dataclasses import dataclass, field
from hashlib import sha256
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.status import FinishReason, ScanCounts
from scanner_core.case.observation import MEASURED, StereoObservation
from scanner_core.case.store import CaseStore, Order
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.optics.spot import Spot
from tests.core.case.recorded_disk import Disk, Files, Recording, recorded

CASE = "life.impronta"
PLAN = {"views": [{"table_deg": 0.0, "rows": [{"first_id": 0, "count": 1000}]}]}

State = dict[str, object]


def state(store: CaseStore) -> State:
    """Everything of a case that a crash could damage, in a form that compares."""

    def digest(array: NDArray[np.generic]) -> str:
        return sha256(array.tobytes()).hexdigest()

    values: State = {
        "order": store.order(),
        "scans": [(scan.id, scan.finish_reason, digest(store.exposed_ids(scan.id)), store.verdict_counts(scan.id)) for scan in store.scans()],
        "centroids": [digest(store.observations(scan.id).left_px) for scan in store.scans()],
        "corrections": [len(store.corrections(scan.id)) for scan in store.scans()],
        "registrations": [len(store.registrations(scan.id)) for scan in store.scans()],
        "mounts": [(scan.id, scan.mount) for scan in store.scans()],
        "poses": [(mount, pose.transform is None, pose.report) for mount, pose in store.mount_poses().items()],
        "meshes": (store.mesh_count(), store.mesh_id()),
        "journal": (store.undoable, store.redoable, store.value("processing")),
        "audit": len(store.audit_trail()),
    }
    if store.mesh_id() is not None:
        values["mesh"] = digest(store.mesh()[0].vertices)
    return values


def observations(first: int, count: int) -> list[StereoObservation]:
    rng = np.random.default_rng(first)
    seen = []
    for i in range(first, first + count):
        spots = [Spot(*rng.uniform(0, 640, 2), 1.01, 0.82, 201.0, 3000.0, 20, 0.012345) for _ in range(2)]
        good = bool(rng.uniform() < 0.8)
        seen.append(StereoObservation(i, i // 500 % 16, MEASURED if good else "no_spot", i / 60, 45.0, *(spots if good else (None, None))))
    return seen


def mesh(size: int) -> TriangleMesh:
    rng = np.random.default_rng(size)
    return TriangleMesh(rng.normal(size=(size, 3)), rng.integers(0, size, (2 * size, 3)), {"supported": np.ones(size, np.uint8)})


def live(path: Path, kept: Callable[[CaseStore], None], batches: int = 3, batch: int = 30, vertices: int = 200) -> None:
    """From creation over two sessions to the last closing; `kept` is called after everything that was acknowledged."""
    with CaseStore.create(path) as store:
        kept(store)
        store.put_order(Order("17", "P-0142", "left", "ear", ""))
        kept(store)
        scan = store.begin_scan("scan", "name = 'rig'", "abc", "calibration", PLAN)
        kept(store)
        store.put_view(scan, 0, 45.0)
        for number in range(batches):
            kept(store)
            store.append(scan, observations(number * batch, batch))
        kept(store)
        for act in (
            lambda: store.put_corrections(scan, [RigidTransform.from_vector([0, 0, 0.001], [0.1, 0, 0])]),
            lambda: store.put_registration(scan, "abc", {"residual_after_um": 7.0}),
            lambda: store.end_scan(scan, FinishReason.CANCELLED, ScanCounts(1000, 5, {"no_spot": 5})),
            lambda: store.put_mesh(mesh(vertices), {"seed": 1}),
            lambda: store.put_order(Order("18", "P-0142", "right", "ear", "")),
            store.undo,
            lambda: store.put_mesh(mesh(vertices + 1), {"seed": 2}),
            store.undo,
        ):
            act()
            kept(store)
    with CaseStore.open(path) as store:
        kept(store)
        store.redo()
        kept(store)
        store.edit("processing", {"calibration": None, "gates": {"epipolar_sigmas": 2.5}}, "Gate changed")
        kept(store)
        again = store.begin_scan("scan", "name = 'rig'", "def", "another", PLAN, 1)
        kept(store)
        store.append(again, observations(1_000_000, batch))
        kept(store)
        store.put_mount_poses([(1, RigidTransform.about_z(30.0), {"first_mount": 0}), (2, None, {})], {again: {0: RigidTransform.about_z(0.01)}})
        kept(store)


@dataclass(slots=True)
class RecordedLife:
    """The operations of a life, and the state that was acknowledged after so many of them.

    Attributes
    ----------
    before : what the disk held when it began
    first : the state of the case then, None for none
    """

    recording: Recording
    before: Files
    first: State | None
    kept: list[tuple[int, State]] = field(default_factory=list)

    def allowed(self, operations: int) -> list[State | None]:
        """What may be found after so many operations: what was acknowledged last, or what was under way; None: no case."""
        old: list[State | None] = [self.first, *(found for count, found in self.kept if count <= operations)]
        return [old[-1], *(found for _, found in self.kept[len(old) - 1 :][:1])]

    def disks(self) -> Iterator[tuple[int, Disk]]:
        """The disk after every operation; it is the same object, which goes on."""
        disk = Disk(self.before)
        for count, operation in enumerate(self.recording.operations, 1):
            disk.apply(operation)
            yield count, disk


def record(folder: Path, act: Callable[[Path, Callable[[CaseStore], None]], None], first: State | None = None) -> RecordedLife:
    """Note what `act` does to the case of a folder; `first` is the state of the case that lies there already."""
    before = {file.name: bytearray(file.read_bytes()) for file in folder.iterdir()}
    with recorded(folder) as recording:
        life = RecordedLife(recording, before, first)
        act(folder / CASE, lambda store: life.kept.append((len(recording.operations), state(store))))
    *_, (_, disk) = life.disks()
    assert disk.after_kill() == {file.name: file.read_bytes() for file in folder.iterdir()}, "the recording misses something"
    return life


def verify(folder: Path, files: Files, allowed: list[State | None]) -> None:
    """Put the files down, open the case as ever, and compare; the folder is empty again afterwards."""
    for name, content in files.items():
        (folder / name).write_bytes(content)
    path = folder / CASE
    if CASE in files:
        with CaseStore.open(path) as store:
            assert state(store) in allowed
        assert not (folder / f"{CASE}-wal").exists()
        with closing(sqlite3.connect(path)) as connection:
            assert connection.execute("PRAGMA integrity_check").fetchall() == [("ok",)]
    else:
        assert None in allowed, "the case is gone"
    for file in folder.iterdir():
        file.unlink()
