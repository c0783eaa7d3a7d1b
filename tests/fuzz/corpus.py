"""Good small files of every kind, from which the fuzzers start, and words that their damage is made of."""

from __future__ import annotations

import io
import json
import sqlite3
import tempfile
from collections.abc import Callable
from dataclasses import asdict, replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from scanner_core.acquisition.plan import Row, ScanPlan, ViewPlan
from scanner_core.acquisition.status import FinishReason, ScanCounts
from scanner_core.case.observation import MEASURED, StereoObservation
from scanner_core.case.store import SUFFIX, CaseStore, Order
from scanner_core.devices.null_level import NullLevel
from scanner_core.devices.rig import dump_rig, load_preset
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.mesh_io.obj import write_obj
from scanner_core.mesh_io.ply import write_ply
from scanner_core.mesh_io.points import write_ply_points, write_xyz_points
from scanner_core.mesh_io.stl import write_stl
from scanner_core.mesh_io.threemf import write_3mf
from scanner_core.optics.spot import Spot
from tests.core.geometry.solids import box
from tests.core.mesh_io.test_hostile_files import POINT_SAMPLES
from tests.core.mesh_io.test_meshes import OBJ, ascii_stl, ply_text, vtp
from tests.core.mesh_io.test_threemf import ASSEMBLY, package
from tests.core.metrology.test_history import ENTRY
from tests.core.optics.rigs import known_rig

WORDS: tuple[bytes, ...] = (
    *(b"\xff" * 4, b"\xff\xff\xff\x7f", b"\0" * 4, b"\0\0\0\x80", b"\xff" * 8, b"\0\0\xc0\x7f", b"\xf0\x7f"),
    *(b"9" * 12, b"-1", b"nan", b"inf", b"1e999", b"-0", b"0x7fffffff", b"\n", b" ", b",", b";", b"\0", b"\xef\xbb\xbf", b"\xff\xfe"),
    *(b"[", b"]", b"{", b"}", b"=", b'"', b"'", b'"""', b"<", b">", b"|", b":", b"<!DOCTYPE a [", b"&#0;", b"../../a", b"%s", b"\x1b[2J"),
)

_DICTIONARIES: dict[str, tuple[bytes, ...]] = {
    "stl": (b"solid", b"facet normal", b"outer loop", b"vertex", b"endloop", b"endfacet", b"endsolid"),
    "ply": (b"element vertex 3\n", b"property list uchar int vertex_indices\n", b"property double x\n", b"format ascii 1.0\n", b"end_header\n"),
    "obj": (b"v 0 0 0\n", b"f 1 2 3 4 5\n", b"f -1/2/3 -2//3 -3\n", b"\\\n", b"#"),
    "vtp": (b'format="appended" offset="0"', b'format="binary"', b'compressor="vtkLZ4DataCompressor"', b'NumberOfPoints="3"', b"<Strips>", b"<Piece"),
    "3mf": (
        b'unit="inch"',
        b'transform="1 0 0 0 1 0 0 0 1 0 0 0"',
        b'<component objectid="1"/>',
        b'<item objectid="1"/>',
        b'<object id="2">',
        b"PK\x03\x04",
    ),
    "npy": (b"'descr': '<f8'", b"'|O'", b"'fortran_order': True", b"'shape': (2, 3)", b"\x93NUMPY\x02\x00"),
    "rig": (b"[calibration.left]\n", b"matrix = ", b"[[spot]]\n", b"inf", b"1979-05-27", b"true", b"a.b.c = 1\n"),
    "plan": (b"views = 3\n", b"points = 100\n", b"object_radius_mm = 1.0\n", b"inf", b"1979-05-27T07:32:00Z"),
    "history": (b'{"date": "', b"Infinity", b'"figures": {', b"null", b"-0001-01-01"),
    "serial": (b"ok\r\n", b"<Idle|MPos:0,0,0|FS:0,0>\r\n", b"ALARM:1\r\n", b"error:9\r\n", b"$130=360.000\r\n", b"Grbl 1.1h\r\n", b"[MSG:]\r\n"),
    "case": (b"SQLite format 3\0", b"CREATE TABLE ", b"measured", b"null", b"IMPR"),
}


def dictionary(reader: str) -> tuple[bytes, ...]:
    """Pieces that mean something to a reader."""
    return WORDS + _DICTIONARIES.get(reader.split("-")[0], ())


@cache
def samples(reader: str) -> list[bytes]:
    """Good files of a reader."""
    return _SAMPLES[reader]()


def _bytes(writer: Callable[[io.BytesIO, Any], object], value: object) -> bytes:
    file = io.BytesIO()
    writer(file, value)
    return file.getvalue()


def _ply() -> list[bytes]:
    mesh = box()
    attributes = {"supported": np.ones(len(mesh.vertices)), "standard_uncertainty_um": np.zeros(len(mesh.vertices))}
    mesh = TriangleMesh(mesh.vertices, mesh.triangles, attributes)
    return [_bytes(write_ply, mesh), *(ply_text(box(), order) for order in ("ascii", "binary_little_endian", "binary_big_endian"))]


def _cloud() -> PointCloud:
    rng = np.random.default_rng(0)
    return PointCloud(rng.normal(size=(8, 3)), np.tile(np.eye(3), (8, 1, 1)), np.arange(8, dtype=np.int32), np.arange(8))


def _vtp() -> list[bytes]:
    found = []
    with tempfile.TemporaryDirectory() as folder:
        for mode in ("Ascii", "Binary", "Appended", "Encoded"):
            for compressor in ("None", "ZLib", "LZ4", "LZMA"):
                path = Path(folder) / "a.vtp"
                vtp(path, box(), "Appended" if mode == "Encoded" else mode, compressor, "UInt32", "little", mode == "Encoded")
                found.append(path.read_bytes())
    return found


def _rig() -> list[bytes]:
    bare = load_preset("bench").with_calibration(None)
    changed = replace(bare, image_model={"f_number": 2.8, "without": ["speckle"]})
    levelled = replace(bare, null_levels=(NullLevel("wax", "2026-05-01", ("abc",), 9, 4.0, 2.0, -1.0, 6.0, 9.0, 1.5, 0.0, "0", "1"),))
    return [dump_rig(rig).encode() for rig in (bare, changed, levelled, bare.with_calibration(known_rig()))]


def _plan() -> list[bytes]:
    return [b"views = 8\npoints = 2000\n", b"object_radius_mm = 20.5\nobject_height_mm = 40\nsmallest_part_mm = 3.0 # a tooth\n"]


def _history() -> list[bytes]:
    return [(json.dumps(asdict(ENTRY)) + "\n").encode() * 2, (json.dumps(asdict(replace(ENTRY, seed=None, figures={}))) + "\n").encode()]


def _serial() -> list[bytes]:
    talk = b"\r\nGrbl 1.1h ['$' for help]\r\n[MSG:'$H'|'$X' to unlock]\r\nok\r\n$32=1\r\n$130=360.000\r\n"
    talk += b"<Idle|MPos:0.000,1.5,-2|FS:0,0|WCO:0,0,0>\r\n"
    return [b"\x03" + talk, b"\xff" + talk + b"<Door:1|WPos:1,2,3|F:500|Pn:D>\r\nerror:9\r\nALARM:2\r\n"]


def _case() -> list[bytes]:
    found = []
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"a{SUFFIX}"
        _make_case(path)
        found.append(path.read_bytes())
        connection = sqlite3.connect(path)
        connection.execute("PRAGMA page_size = 512")
        connection.execute("VACUUM")
        connection.close()
        found.append(path.read_bytes())
    return found


def _make_case(path: Path) -> None:
    calibration = known_rig()
    rig = load_preset("bench").with_calibration(calibration)
    plan = ScanPlan((ViewPlan(0.0, (Row(0, 0, 12, 1.0, -2.0, 2.0),), 8), ViewPlan(90.0, (Row(1, 12, 12, 1.0, -2.0, 2.0),))), 3.0)
    points = np.random.default_rng(1).uniform((-15, -15, 5), (15, 15, 30), (24, 3))
    with CaseStore.create(path) as store:
        store.put_order(Order("4711", "P-12", "left", "ear", "for the mould"))
        scan = store.begin_scan("scan", dump_rig(rig.with_calibration(None)), calibration.identity(), dump_rig(rig), plan.as_dict())
        observations = []
        for i, point in enumerate(points):
            in_rig = calibration.rig_to_object(90.0 * (i // 12)).inverse().apply(point[None])
            pixels = [camera.project(in_rig)[0].tolist() for camera in (calibration.left, calibration.right)]
            left, right = (Spot(x, y, 1.0, 0.8, 200.0, 3000.0, 20, 0.012) for x, y in pixels)
            verdict = MEASURED if i % 5 else "hidden_left"
            observations.append(StereoObservation(i, i // 12, verdict, i / 60, 90.0 * (i // 12), left if i % 5 else None, right))
        store.append(scan, observations)
        for view in (0, 1):
            store.put_view(scan, view, 90.0 * view)
        store.put_corrections(scan, [RigidTransform.identity(), RigidTransform.about_z(0.01)])
        store.end_scan(scan, FinishReason.COMPLETED, ScanCounts(24, 19, {"hidden_left": 5}))
        mesh = box()
        store.put_registration(scan, calibration.identity(), {"views": 2, "applied": True})
        store.put_mesh(TriangleMesh(mesh.vertices, mesh.triangles, {"supported": np.ones(len(mesh.vertices), np.uint8)}), {"seed": 0})
        store.put_mask("stable", {"mesh": 1}, np.arange(8) < 5)
        store.put_comparison({"mesh": 1}, {"file": "b.stl"}, {"tolerance_um": 250}, {"rms_um": 12.5}, np.linspace(-1, 1, 8))
        store.edit("processing", {"gates": {"epipolar_sigmas": 4.0}}, "Gates changed")
        store.put_order(Order("4711", "P-12", "right", "ear", "for the mould"))
        store.undo()


_SAMPLES = {
    "stl": lambda: [_bytes(write_stl, box()), ascii_stl(box())],
    "ply": _ply,
    "obj": lambda: [OBJ, _bytes(write_obj, box())],
    "vtp": _vtp,
    "3mf": lambda: [_bytes(write_3mf, box()), package(ASSEMBLY)],
    "3mf-model": lambda: [ASSEMBLY],
    "ply-points": lambda: [_bytes(write_ply_points, _cloud()), *_ply()],
    "text": lambda: [_bytes(write_xyz_points, _cloud()), *(content for suffix, content in POINT_SAMPLES.values() if suffix not in (".npy", ".ply"))],
    "npy": lambda: [content for suffix, content in POINT_SAMPLES.values() if suffix == ".npy"],
    "rig": _rig,
    "plan": _plan,
    "case": _case,
    "case-values": lambda: [bytes([cell, cell % 4, 3 * cell % 256, 4]) + b"1234" for cell in range(81)],
    "history": _history,
    "serial": _serial,
}
