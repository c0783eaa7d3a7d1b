"""The case file: what was appended is there, one program at a time, and nothing but a case is taken for one."""

from __future__ import annotations

import json
import sqlite3
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from scanner_core.acquisition.status import FinishReason, ScanCounts
from scanner_core.case.observation import MEASURED, StereoObservation
from scanner_core.case.schema import VERSION
from scanner_core.case.store import CaseStore, Order
from scanner_core.errors import CaseError, CaseFormatError, CaseLockedError, StorageError
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.optics.spot import Spot

PLAN = {"views": [{"table_deg": 0.0, "rows": [{"first_id": 0, "count": 100}]}]}


def _spot(x_px: float) -> Spot:
    return Spot(x_px, 50.123456789, 1.01, 0.82, 201.0, 3000.0, 20, 0.012345)


def _observations(first: int, count: int) -> list[StereoObservation]:
    return [
        StereoObservation(
            i, 0, MEASURED if i % 3 else "no_spot", i / 60, 45.0, _spot(100 + i / 7) if i % 3 else None, _spot(200 + i / 7) if i % 3 else None
        )
        for i in range(first, first + count)
    ]


def _begin(store: CaseStore) -> int:
    return store.begin_scan("scan", "name = 'rig'", "abc", "calibration", PLAN)


def test_observations_come_back_to_the_last_bit(tmp_path: Path) -> None:
    path = tmp_path / "a.impronta"
    with CaseStore.create(path) as store:
        scan = _begin(store)
        store.append(scan, _observations(50, 50))
        store.append(scan, _observations(0, 50))
    with CaseStore.open(path) as store:
        table = store.observations(scan)
        assert store.verdict_counts(scan) == {MEASURED: 66, "no_spot": 34}
    assert table.trigger_id.tolist() == [i for i in range(100) if i % 3]
    assert table.left_px[:, 0].tolist() == [100 + i / 7 for i in range(100) if i % 3]
    assert np.allclose(table.right_uncertainty_px, 0.012345, atol=1e-6)


def test_at_rest_a_point_takes_at_most_150_bytes(tmp_path: Path) -> None:
    """100,000 points with the noise of real ones in every digit, and 10 % of rejected ones on top."""
    path = tmp_path / "a.impronta"
    rng = np.random.default_rng(7)
    count, points = 110_000, 100_000
    good = np.ones(count, np.bool_)
    good[rng.choice(count, count - points, replace=False)] = False
    pixels, sigmas = rng.uniform(0, 1279, (count, 4)), rng.normal(1.2, 0.2, (count, 4))
    peaks, uncertainties, angles = rng.uniform(60, 250, (count, 2)), rng.uniform(0.01, 0.15, (count, 2)), rng.normal(0, 0.01, 8)
    with CaseStore.create(path) as store:
        scan = _begin(store)
        for first in range(0, count, 5000):
            rows = []
            for i in range(first, first + 5000):
                spots = [
                    Spot(*map(float, pixels[i, 2 * k : 2 * k + 2]), *sigmas[i, 2 * k : 2 * k + 2], peaks[i, k], 3000.0, 20, uncertainties[i, k])
                    for k in range(2)
                ]
                view = i * 8 // count
                pair = spots if good[i] else [spots[0] if i % 2 else None, None]
                rows.append(StereoObservation(i, view, MEASURED if good[i] else "no_spot", i / 60 + 0.0123, 45.0 * view + angles[view], *pair))
            store.append(scan, rows)
    assert [file.name for file in tmp_path.iterdir()] == ["a.impronta"]
    bytes_a_point = path.stat().st_size / points
    print(f"{bytes_a_point:.1f} bytes a point")
    assert bytes_a_point < 150
    with CaseStore.open(path, read_only=True) as store:
        table = store.observations(scan)
    assert np.array_equal(np.hstack([table.left_px, table.right_px]), pixels[good])  # to the last bit
    assert np.array_equal(table.table_deg, (45.0 * table.view) + angles[table.view])


def test_a_second_program_is_refused_in_one_sentence(tmp_path: Path) -> None:
    path = tmp_path / "a.impronta"
    with CaseStore.create(path):
        with pytest.raises(CaseLockedError, match="E-CASE-02"):
            CaseStore.open(path)
        code = f"from pathlib import Path; from scanner_core.case.store import CaseStore; CaseStore.open(Path({str(path)!r}))"
        other = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60, check=False)
        assert "E-CASE-02" in other.stderr
    CaseStore.open(path).close()


def test_an_append_that_returned_survives_a_kill(tmp_path: Path) -> None:
    path = tmp_path / "a.impronta"
    code = f"""
import os, signal, sys
from pathlib import Path
from tests.core.case.test_store import _begin, _observations
from scanner_core.case.store import CaseStore
store = CaseStore.create(Path({str(path)!r}))
scan = _begin(store)
for first in range(0, 1000, 10):
    store.append(scan, _observations(first, 10))
    print(first + 10, flush=True)
    if first == 500:
        os.kill(os.getpid(), signal.SIGKILL)
"""
    killed = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60, check=False)
    acknowledged = int(killed.stdout.split()[-1])
    assert acknowledged == 510
    with CaseStore.open(path) as store:
        assert sum(store.verdict_counts(1).values()) == acknowledged
        assert store.scans()[0].finish_reason is None
    with sqlite3.connect(path) as connection:
        assert connection.execute("PRAGMA integrity_check").fetchone() == ("ok",)
    connection.close()


@pytest.mark.parametrize("content", [b"", b"not a case", b"SQLite format 3\x00" + b"\x00" * 200, b"SQLite format 3\x00" + b"\xff" * 4096])
def test_what_is_no_case_is_refused(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "a.impronta"
    path.write_bytes(content)
    with pytest.raises(CaseFormatError, match="E-CASE-01"):
        CaseStore.open(path)
    assert path.read_bytes() == content


def test_a_foreign_database_and_a_newer_case_are_refused(tmp_path: Path) -> None:
    path = tmp_path / "foreign.impronta"
    connection = sqlite3.connect(path)
    connection.execute("CREATE TABLE t (a)")
    connection.close()
    with pytest.raises(CaseFormatError, match="another program"):
        CaseStore.open(path)
    newer = tmp_path / "newer.impronta"
    CaseStore.create(newer).close()
    connection = sqlite3.connect(newer)
    connection.execute(f"PRAGMA user_version = {VERSION + 1}")
    connection.close()
    with pytest.raises(CaseFormatError, match="E-CASE-03"):
        CaseStore.open(newer)


def test_missing_and_existing_files(tmp_path: Path) -> None:
    with pytest.raises(CaseError, match="E-CASE-04"):
        CaseStore.open(tmp_path / "none.impronta")
    CaseStore.create(tmp_path / "a.impronta").close()
    with pytest.raises(StorageError, match="E-DISK-03"):
        CaseStore.create(tmp_path / "a.impronta")
    with pytest.raises(StorageError, match="E-DISK-02"):
        CaseStore.create(tmp_path / "no folder" / "a.impronta")


def test_used_after_close(tmp_path: Path) -> None:
    store = CaseStore.create(tmp_path / "a.impronta")
    store.close()
    store.close()
    with pytest.raises(CaseError, match="E-CASE-06"):
        store.scans()


def test_mesh_order_corrections_and_counts_come_back(tmp_path: Path) -> None:
    mesh = TriangleMesh(
        np.random.default_rng(1).normal(size=(4, 3)),
        np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]),
        {"standard_uncertainty_um": np.arange(4, dtype=np.float32), "supported": np.array([1, 1, 0, 1], np.uint8)},
    )
    correction = RigidTransform.from_vector([0.001, 0, 0.002], [0.01, 0.02, 0.03])
    with CaseStore.create(tmp_path / "a.impronta") as store:
        store.put_order(Order("17", "P-0142", "left", "ear impression", ""))
        scan = _begin(store)
        store.put_view(scan, 0, 0.0)
        store.put_corrections(scan, [correction])
        store.end_scan(scan, FinishReason.CANCELLED, ScanCounts(100, 60, {"no_spot": 10}))
        with pytest.raises(CaseError, match="E-CASE-05"):
            store.mesh()
        store.put_mesh(mesh, {"seed": 3})
    with CaseStore.open(tmp_path / "a.impronta") as store:
        back, provenance = store.mesh()
        record = store.scans()[0]
        assert store.order().patient_code == "P-0142"
        assert np.array_equal(store.corrections(scan)[0].matrix(), correction.matrix())
        assert store.next_trigger_id() == 100
    assert np.array_equal(back.vertices, mesh.vertices)
    assert np.array_equal(back.triangles, mesh.triangles)
    assert np.array_equal(back.vertex_attributes["supported"], mesh.vertex_attributes["supported"])
    assert provenance["seed"] == 3
    assert record.finish_reason == "cancelled"
    assert json.dumps(record.counts) == json.dumps({"planned": 100, "measured": 60, "rejected": {"no_spot": 10}, "skipped": 30})
