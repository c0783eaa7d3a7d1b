"""Meshes written and read again, in every format and dialect."""

from __future__ import annotations

import struct
import zipfile
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkIOGeometry import vtkSTLReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from scanner_core.errors import InputFileError, StorageError
from scanner_core.geometry.checks import check_mesh
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.mesh_io import check_suffix, read_mesh, write_mesh
from scanner_core.mesh_io.polygons import triangulated
from scanner_core.mesh_io.stated_unit import stated_unit
from tests.core.geometry.solids import box, joined, moved, sphere, torus

BODIES = [box(10.0), torus(), joined(sphere(3.0), moved(box(), (9.5, 0, 0)))]


def single(mesh: TriangleMesh) -> TriangleMesh:
    """Coordinates rounded to what a float32 holds."""
    return TriangleMesh(mesh.vertices.astype(np.float32).astype(np.float64), mesh.triangles, mesh.vertex_attributes)


def corners_of(mesh: TriangleMesh) -> np.ndarray:
    return mesh.vertices[mesh.triangles]


@pytest.mark.parametrize("suffix", [".stl", ".ply", ".obj", ".STL"])
@pytest.mark.parametrize("mesh", BODIES, ids=["box", "torus", "two"])
def test_what_is_written_is_read_again(tmp_path: Path, mesh: TriangleMesh, suffix: str) -> None:
    mesh = single(mesh)
    write_mesh(tmp_path / f"mesh{suffix}", mesh)
    found = read_mesh(tmp_path / f"mesh{suffix}")
    assert np.abs(corners_of(found) - corners_of(mesh)).max() <= (1e-8 if suffix == ".obj" else 0)
    assert found.triangles.dtype == np.int64
    assert check_mesh(found) == check_mesh(mesh)
    again = tmp_path / f"again{suffix}"
    write_mesh(again, mesh)
    assert again.read_bytes() == (tmp_path / f"mesh{suffix}").read_bytes()


def test_stl_says_its_unit_and_faces_outwards(tmp_path: Path) -> None:
    mesh = sphere(5.0)
    write_mesh(tmp_path / "mesh.stl", mesh)
    content = (tmp_path / "mesh.stl").read_bytes()
    assert b"UNITS=mm" in content[:80]
    assert not content.startswith(b"solid")
    assert len(content) == 84 + 50 * len(mesh.triangles)
    normal = np.frombuffer(content, np.dtype([("n", "<f4", 3), ("c", "<f4", (3, 3)), ("a", "<u2")]), offset=84)
    assert np.einsum("ij,ij->i", normal["n"], normal["c"].mean(axis=1)).min() > 4
    assert np.linalg.norm(normal["n"], axis=1) == pytest.approx(1)


def test_other_programs_read_our_stl_and_ply(tmp_path: Path) -> None:
    mesh = torus()
    for suffix, reader in ((".stl", vtkSTLReader()), (".ply", vtkPLYReader())):
        write_mesh(tmp_path / f"mesh{suffix}", mesh)
        reader.SetFileName(str(tmp_path / f"mesh{suffix}"))
        reader.Update()
        assert reader.GetOutput().GetNumberOfCells() == len(mesh.triangles)
        assert reader.GetOutput().GetNumberOfPoints() == len(mesh.vertices)


def test_ply_keeps_uncertainty_and_support(tmp_path: Path) -> None:
    mesh = box()
    attributes = {"standard_uncertainty_um": np.linspace(5, 9, 8), "supported": np.arange(8) % 2 == 0, "extra": np.arange(8, dtype=np.int64)}
    write_mesh(tmp_path / "mesh.ply", TriangleMesh(mesh.vertices, mesh.triangles, attributes))
    header = (tmp_path / "mesh.ply").read_bytes().split(b"end_header")[0]
    assert b"format binary_little_endian 1.0" in header
    assert b"property float standard_uncertainty_um" in header
    assert b"property uchar supported" in header
    found = read_mesh(tmp_path / "mesh.ply").vertex_attributes
    assert found["standard_uncertainty_um"] == pytest.approx(np.linspace(5, 9, 8))
    assert found["supported"].dtype == np.uint8
    assert found["supported"].tolist() == [1, 0] * 4


def test_3mf_is_a_package_in_millimetres(tmp_path: Path) -> None:
    mesh = torus()
    write_mesh(tmp_path / "mesh.3mf", mesh)
    with zipfile.ZipFile(tmp_path / "mesh.3mf") as package:
        assert package.testzip() is None
        assert set(package.namelist()) == {"[Content_Types].xml", "_rels/.rels", "3D/3dmodel.model"}
        for name in package.namelist():
            ElementTree.fromstring(package.read(name))
        model = ElementTree.fromstring(package.read("3D/3dmodel.model"))
    space = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"
    assert model.get("unit") == "millimeter"
    vertices = np.array([[float(v.get(axis, "")) for axis in "xyz"] for v in model.iter(space + "vertex")])
    triangles = np.array([[int(t.get(name, "")) for name in ("v1", "v2", "v3")] for t in model.iter(space + "triangle")])
    assert np.abs(vertices - mesh.vertices).max() < 1e-8
    assert (triangles == mesh.triangles).all()
    assert [item.get("objectid") for item in model.iter(space + "item")] == [model.find(f"{space}resources/{space}object").get("id")]


def ascii_stl(mesh: TriangleMesh, newline: str = "\n", name: str = "part") -> bytes:
    lines = [f"solid {name}"]
    for corners in corners_of(mesh):
        lines += ["facet normal 0 0 0", "  outer loop", *(f"    vertex {x:.9g} {y:.9g} {z:.9g}" for x, y, z in corners), "  endloop", "endfacet"]
    return newline.join([*lines, f"endsolid {name}", ""]).encode()


@pytest.mark.parametrize("newline", ["\n", "\r\n"])
def test_ascii_stl(tmp_path: Path, newline: str) -> None:
    mesh = single(torus())
    (tmp_path / "a.stl").write_bytes(ascii_stl(mesh, newline) + ascii_stl(moved(single(box()), (9, 0, 0)), newline, "").upper())
    found = read_mesh(tmp_path / "a.stl")
    assert len(found.triangles) == len(mesh.triangles) + 12
    assert check_mesh(found).closed
    assert np.abs(corners_of(found)[: len(mesh.triangles)] - corners_of(mesh)).max() < 1e-7


def test_a_binary_stl_may_begin_with_solid(tmp_path: Path) -> None:
    write_mesh(tmp_path / "a.stl", box())
    content = (tmp_path / "a.stl").read_bytes()
    (tmp_path / "b.stl").write_bytes(b"solid made by another program".ljust(80) + content[80:] + b"\0\0")
    assert len(read_mesh(tmp_path / "b.stl").triangles) == 12
    (tmp_path / "b.stl").write_bytes(b"solid".ljust(80) + content[80:])
    assert len(read_mesh(tmp_path / "b.stl").triangles) == 12


def ply_text(mesh: TriangleMesh, order: str, face_type: str = "uchar int") -> bytes:
    """A PLY in any byte order, with an element and list that nobody expects before the faces."""
    header = (
        f"ply\nformat {order} 1.0\ncomment x\nelement vertex {len(mesh.vertices)}\nproperty double x\nproperty double y\nproperty double z\n"
        "property uchar quality\nelement camera 2\nproperty list uchar float values\nproperty short id\n"
        f"element face {len(mesh.triangles)}\nproperty uchar flag\nproperty list {face_type} vertex_index\nend_header\n"
    ).encode()
    if order == "ascii":
        rows = [f"{x!r} {y!r} {z!r} {i % 200}" for i, (x, y, z) in enumerate(mesh.vertices.tolist())]
        rows += ["2 1.5 2.5 7", "0 8"] + ["1 3 " + " ".join(map(str, face)) for face in mesh.triangles.tolist()]
        return header + "\n".join(rows).encode() + b"\n"
    sign = "<" if "little" in order else ">"
    body = b"".join(struct.pack(sign + "dddB", *p, i % 200) for i, p in enumerate(mesh.vertices.tolist()))
    body += struct.pack(sign + "Bffh", 2, 1.5, 2.5, 7) + struct.pack(sign + "Bh", 0, 8)
    length, index = ({"uchar": "B", "int": "i"}[name] for name in face_type.split())
    return header + body + b"".join(struct.pack(sign + "B" + length + 3 * index, 1, 3, *face) for face in mesh.triangles.tolist())


@pytest.mark.parametrize("order", ["ascii", "binary_little_endian", "binary_big_endian"])
@pytest.mark.parametrize("face_type", ["uchar int", "int int"])
def test_every_kind_of_ply(tmp_path: Path, order: str, face_type: str) -> None:
    mesh = torus()
    (tmp_path / "a.ply").write_bytes(ply_text(mesh, order, face_type))
    found = read_mesh(tmp_path / "a.ply")
    assert (found.vertices == mesh.vertices).all()
    assert (found.triangles == mesh.triangles).all()
    assert found.vertex_attributes["quality"].tolist() == [i % 200 for i in range(len(mesh.vertices))]
    assert found.vertex_attributes["quality"].dtype == np.uint8


OBJ = b"""# a square, a triangle and what we pass over
mtllib x.mtl
o thing
v 0 0 0
v 1 0 0 0.5 0.5 0.5
v 1 1 0
v 0 1 0
vn 0 0 1
vt 0 0
usemtl gold
f 1/1/1 2/1/1 3/1/1 4/1/1
v 0 0 1
f -1 -5//1 \\
 -4//1
l 1 2
"""


def test_obj_with_slashes_polygons_and_negative_indices(tmp_path: Path) -> None:
    (tmp_path / "a.obj").write_bytes(OBJ)
    found = read_mesh(tmp_path / "a.obj")
    assert found.vertices.tolist() == [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1]]
    assert found.triangles.tolist() == [[0, 1, 2], [0, 2, 3], [4, 0, 1]]


def vtk_surface(mesh: TriangleMesh) -> vtkPolyData:
    surface, points, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    points.SetData(numpy_to_vtk(mesh.vertices, deep=True))
    cells.SetData(3, numpy_to_vtkIdTypeArray(mesh.triangles.ravel(), deep=True))
    surface.SetPoints(points)
    surface.SetPolys(cells)
    for name, column in (("quality", np.arange(len(mesh.vertices), dtype=np.float32)), ("direction", mesh.vertices)):
        array = numpy_to_vtk(column, deep=True)
        array.SetName(name)
        surface.GetPointData().AddArray(array)
    return surface


def vtp(path: Path, mesh: TriangleMesh, mode: str, compressor: str, header: str, order: str = "little", encoded: bool = False) -> None:
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(vtk_surface(mesh))
    getattr(writer, f"SetDataModeTo{mode}")()
    getattr(writer, f"SetCompressorTypeTo{compressor}")()
    getattr(writer, f"SetHeaderTypeTo{header}")()
    getattr(writer, f"SetByteOrderTo{order.capitalize()}Endian")()
    writer.SetEncodeAppendedData(encoded)
    writer.SetBlockSize(32 * 64)
    assert writer.Write() == 1


@pytest.mark.parametrize("mode", ["Ascii", "Binary", "Appended", "Encoded"])
@pytest.mark.parametrize("compressor", ["None", "ZLib", "LZ4", "LZMA"])
@pytest.mark.parametrize("header", ["UInt32", "UInt64"])
def test_every_kind_of_vtp(tmp_path: Path, mode: str, compressor: str, header: str) -> None:
    mesh = torus(around=40, across=20)
    vtp(
        tmp_path / "a.vtp",
        mesh,
        "Appended" if mode == "Encoded" else mode,
        compressor,
        header,
        "big" if header == "UInt64" else "little",
        mode == "Encoded",
    )
    found = read_mesh(tmp_path / "a.vtp")
    assert np.abs(found.vertices - mesh.vertices).max() < (1e-9 if mode == "Ascii" else 1e-15)
    assert (found.triangles == mesh.triangles).all()
    assert list(found.vertex_attributes) == ["quality"]
    assert found.vertex_attributes["quality"].tolist() == list(range(len(mesh.vertices)))


def test_vtp_pieces_polygons_and_strips(tmp_path: Path) -> None:
    piece = """<Piece NumberOfPoints="5" NumberOfPolys="1" NumberOfStrips="1">
    <Points><DataArray type="Float64" NumberOfComponents="3">0 0 0 1 0 0 1 1 0 0 1 0 2 0 0</DataArray></Points>
    <Polys><DataArray type="Int64" Name="connectivity">0 1 2 3</DataArray><DataArray type="Int64" Name="offsets">4</DataArray></Polys>
    <Strips><DataArray type="Int64" Name="connectivity">3 0 2 1 4</DataArray><DataArray type="Int64" Name="offsets">5</DataArray></Strips></Piece>"""
    (tmp_path / "a.vtp").write_text(f'<VTKFile type="PolyData"><PolyData>{piece}{piece}</PolyData></VTKFile>', encoding="ascii")
    found = read_mesh(tmp_path / "a.vtp")
    assert len(found.vertices) == 10
    one = [(0, 1, 2), (0, 2, 3), (3, 0, 2), (2, 0, 1), (2, 1, 4)]
    assert found.triangles.tolist() == [[a + first, b + first, c + first] for first in (0, 5) for a, b, c in one]


@settings(max_examples=40)
@given(st.integers(0, 2**32 - 1), st.integers(4, 12))
def test_polygons_keep_their_area_and_orientation(seed: int, corners: int) -> None:
    """Star-shaped polygons, concave too, somewhere in space."""
    rng = np.random.default_rng(seed)
    angle = np.sort(rng.uniform(0, 2 * np.pi, corners))
    if np.diff(np.append(angle, angle[0] + 2 * np.pi)).max() > 3:
        angle = 2 * np.pi * np.arange(corners) / corners
    radius = rng.uniform(0.2, 1, corners)
    flat = np.column_stack([radius * np.cos(angle), radius * np.sin(angle), np.zeros(corners)])
    mesh = moved(TriangleMesh(flat, np.empty((0, 3), np.int64)), (3, 4, 5), seed)
    triangles = triangulated(mesh.vertices, np.arange(corners), np.array([corners]))
    part = TriangleMesh(mesh.vertices, triangles).area_vectors()
    following = np.roll(mesh.vertices, -1, axis=0)
    whole = 0.5 * np.cross(mesh.vertices, following).sum(axis=0)
    assert len(triangles) == corners - 2
    assert part.sum(axis=0) == pytest.approx(whole, abs=1e-9)
    assert np.linalg.norm(part, axis=1).sum() == pytest.approx(np.linalg.norm(whole), abs=1e-9)


def test_a_large_polygon_that_crosses_itself_ends() -> None:
    rng = np.random.default_rng(9)
    points = np.column_stack([rng.normal(size=(400, 2)), np.zeros(400)])
    assert triangulated(points, np.arange(400), np.array([400])).shape == (398, 3)


def test_triangles_quads_and_polygons_come_in_their_order() -> None:
    ring = np.array([[np.cos(a), np.sin(a), 0.0] for a in 2 * np.pi * np.arange(6) / 6])
    triangles = triangulated(ring, np.array([0, 1, 2, 3, 4, 0, 1, 2, 3, 4, 5, 3, 4, 5]), np.array([5, 6, 3]))
    assert len(triangles) == 3 + 4 + 1
    assert triangles[-1].tolist() == [3, 4, 5]


def test_collapsed_triangles_are_left_out(tmp_path: Path) -> None:
    (tmp_path / "a.obj").write_bytes(b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 2\n")
    assert read_mesh(tmp_path / "a.obj").triangles.tolist() == [[0, 1, 2]]


def test_an_existing_file_and_an_unknown_suffix(tmp_path: Path) -> None:
    write_mesh(tmp_path / "a.stl", box())
    with pytest.raises(StorageError, match="E-DISK-03"):
        write_mesh(tmp_path / "a.stl", torus())
    write_mesh(tmp_path / "a.stl", torus(), force=True)
    assert len(read_mesh(tmp_path / "a.stl").triangles) == 576
    for call in (lambda: write_mesh(tmp_path / "a.step", box()), lambda: check_suffix("a.step")):
        with pytest.raises(InputFileError, match=r"'\.step'.*\.stl, \.ply, \.obj, \.3mf.*E-FILE-06"):
            call()
    assert [path.name for path in tmp_path.iterdir()] == ["a.stl"]


@pytest.mark.parametrize(
    ("suffix", "head"), [(".stl", b"Impronta binary STL UNITS=mm marks_um=12.3 visits=17"), (".ply", b"comment marks_um=12.3 visits=17\n")]
)
def test_a_remark_stands_in_the_header_and_changes_nothing_else(suffix: str, head: bytes, tmp_path: Path) -> None:
    mesh = sphere()
    bare, remarked = tmp_path / f"bare{suffix}", tmp_path / f"remarked{suffix}"
    write_mesh(bare, mesh)
    write_mesh(remarked, mesh, remark="marks_um=12.3 visits=17")
    assert head in remarked.read_bytes()[:200]
    assert b"marks" not in bare.read_bytes()
    a, b = read_mesh(bare), read_mesh(remarked)
    np.testing.assert_array_equal(a.vertices, b.vertices)
    np.testing.assert_array_equal(a.triangles, b.triangles)
    assert stated_unit(suffix, remarked.read_bytes()) == "mm"
