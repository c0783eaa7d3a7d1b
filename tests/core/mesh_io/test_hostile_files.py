"""Files that lie, are cut off or damaged end in one sentence: no crash, no noise, no memory that the file does not pay for."""

from __future__ import annotations

import os
import tracemalloc
import zlib
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from scanner_core.errors import InputFileError
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.mesh_io import read_mesh, write_mesh
from scanner_core.mesh_io.malformed import MalformedError
from scanner_core.mesh_io.reader import MESH_PARSERS, POINT_PARSERS
from tests.core.geometry.solids import box, sphere
from tests.core.mesh_io.test_meshes import OBJ, ascii_stl, ply_text, vtp
from tests.core.mesh_io.test_points import npy

MOST_MEMORY = 20_000_000
"""Far more than any honest file of these sizes needs, far less than what the damaged numbers announce."""


def _written(suffix: str, folder: Path) -> bytes:
    write_mesh(folder / f"a{suffix}", sphere(around=8, across=5))
    return (folder / f"a{suffix}").read_bytes()


@pytest.fixture(scope="module")
def samples(tmp_path_factory: pytest.TempPathFactory) -> dict[str, tuple[str, bytes]]:
    """Name -> suffix and the bytes of a good small file."""
    folder = tmp_path_factory.mktemp("samples")
    mesh = sphere(around=8, across=5)
    files = {"stl": (".stl", _written(".stl", folder)), "ascii stl": (".stl", ascii_stl(box())), "obj": (".obj", OBJ + _written(".obj", folder))}
    files |= {f"ply {order}": (".ply", ply_text(box(), order)) for order in ("ascii", "binary_little_endian", "binary_big_endian")}
    for mode in ("Ascii", "Binary", "Appended", "Encoded"):
        for compressor in ("None", "ZLib", "LZ4", "LZMA"):
            vtp(folder / "a.vtp", mesh, "Appended" if mode == "Encoded" else mode, compressor, "UInt32", "little", mode == "Encoded")
            files[f"vtp {mode} {compressor}"] = (".vtp", (folder / "a.vtp").read_bytes())
    return files


POINT_SAMPLES = {
    "npy": (".npy", npy(np.arange(60.0).reshape(20, 3))),
    "csv": (".csv", b"# c\nx,y,z\n" + b"1.5,2.5,-3.5\n" * 20),
    "xyz": (".xyz", b"1.5 2.5 -3.5\n" * 20),
    "decimal comma": (".txt", b"x;y;z\n" + b"1,5;2,5;-3,5\n" * 20),
    "ply": (".ply", ply_text(box(), "binary_little_endian")),
}

MESHES = ["stl", "ascii stl", "obj", "ply ascii", "ply binary_little_endian", "ply binary_big_endian"]
MESHES += [f"vtp {mode} {compressor}" for mode in ("Ascii", "Binary", "Appended", "Encoded") for compressor in ("None", "ZLib", "LZ4", "LZMA")]

damage = st.one_of(
    st.tuples(st.just("cut"), st.floats(0, 1), st.just(b"")),
    st.tuples(st.just("flip"), st.floats(0, 1), st.binary(min_size=1, max_size=4)),
    st.tuples(st.just("insert"), st.floats(0, 1), st.sampled_from([b"\xff" * 8, b"9" * 12, b"-1", b"nan", b"\n", b"1e999", b"<", b"\0", b" "])),
    st.tuples(st.just("remove"), st.floats(0, 1), st.binary(min_size=1, max_size=30)),
)


def damaged(content: bytes, faults: list[tuple[str, float, bytes]]) -> bytes:
    for kind, place, what in faults:
        at = int(place * max(len(content) - 1, 0))
        if kind == "cut":
            content = content[:at]
        elif kind == "flip":
            content = content[:at] + bytes(a ^ b for a, b in zip(content[at : at + len(what)], what, strict=False)) + content[at + len(what) :]
        elif kind == "insert":
            content = content[:at] + what + content[at:]
        else:
            content = content[:at] + content[at + len(what) :]
    return content


def check_sentence(reason: str) -> None:
    assert 0 < len(reason) < 400
    assert reason.isprintable()


@pytest.mark.parametrize("name", MESHES)
@settings(max_examples=40)
@given(faults=st.lists(damage, min_size=1, max_size=3))
def test_damaged_meshes_are_read_or_refused(samples: dict[str, tuple[str, bytes]], name: str, faults: list[tuple[str, float, bytes]]) -> None:
    suffix, content = samples[name]
    try:
        mesh = MESH_PARSERS[suffix](damaged(content, faults))
    except MalformedError as refusal:
        check_sentence(str(refusal))
        return
    assert isinstance(mesh, TriangleMesh)
    assert np.isfinite(mesh.vertices).all()
    assert mesh.triangles.shape[1:] == (3,)
    assert len(mesh.triangles) == 0 or (mesh.triangles.min() >= 0 and mesh.triangles.max() < len(mesh.vertices))
    assert all(len(column) == len(mesh.vertices) for column in mesh.vertex_attributes.values())


@pytest.mark.parametrize("name", list(POINT_SAMPLES))
@settings(max_examples=60)
@given(faults=st.lists(damage, min_size=1, max_size=3))
def test_damaged_points_are_read_or_refused(name: str, faults: list[tuple[str, float, bytes]]) -> None:
    suffix, content = POINT_SAMPLES[name]
    try:
        cloud = POINT_PARSERS[suffix](damaged(content, faults))
    except MalformedError as refusal:
        check_sentence(str(refusal))
        return
    assert isinstance(cloud, PointCloud)
    assert cloud.points.shape[1:] == (3,)
    assert np.isfinite(cloud.points).all()


@settings(max_examples=60)
@given(content=st.binary(max_size=300))
def test_noise_is_refused_by_every_parser(content: bytes) -> None:
    for parser in (*MESH_PARSERS.values(), *POINT_PARSERS.values()):
        try:
            parser(content)
        except MalformedError:
            continue


@pytest.mark.parametrize("name", [name for name in MESHES if name not in ("obj", "vtp Ascii None")])
def test_a_file_that_is_cut_off_is_refused(samples: dict[str, tuple[str, bytes]], name: str) -> None:
    suffix, content = samples[name]
    for part in (0.3, 0.6, 0.9):
        with pytest.raises(MalformedError):
            MESH_PARSERS[suffix](content[: int(len(content) * part)])


def _stl(count: int) -> bytes:
    return bytes(80) + count.to_bytes(4, "little") + bytes(50)


def _ply(vertices: int, faces: int, body: bytes, length_type: str = "uchar", order: str = "binary_little_endian") -> bytes:
    return (
        f"ply\nformat {order} 1.0\nelement vertex {vertices}\nproperty float x\nproperty float y\nproperty float z\n"
        f"element face {faces}\nproperty list {length_type} int vertex_indices\nend_header\n"
    ).encode() + body


def _vtp(points: int, polys: int, connectivity: str = "0 1 2", offsets: str = "3", extra: str = "") -> bytes:
    return (
        f'<VTKFile type="PolyData" {extra}><PolyData><Piece NumberOfPoints="{points}" NumberOfPolys="{polys}"><Points>'
        '<DataArray type="Float32" NumberOfComponents="3">0 0 0 1 0 0 0 1 0</DataArray></Points>'
        f'<Polys><DataArray type="Int64" Name="connectivity">{connectivity}</DataArray>'
        f'<DataArray type="Int64" Name="offsets">{offsets}</DataArray></Polys></Piece></PolyData></VTKFile>'
    ).encode()


TRIANGLE = np.array([0, 0, 0, 1, 0, 0, 0, 1, 0], "<f4").tobytes()
LIES = [
    ("a.stl", _stl(0xFFFFFFFF), "announces 4294967295 triangles, but the file ends after 1"),
    ("a.stl", bytes(40), "ends after 40 bytes"),
    ("a.stl", _stl(0) + b"\1", "announces 0 triangles, but 51 bytes follow"),
    ("a.stl", b"solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0\n", "line 2 is no facet"),
    ("a.stl", ascii_stl(box())[:-14], "without 'endsolid'"),
    ("a.stl", ascii_stl(box()).replace(b"vertex 0 0 0", b"vertex 0 0 zero", 1), "'zero', which is no number"),
    ("a.ply", b"not a ply", "does not begin with the line 'ply'"),
    ("a.ply", b"ply\nformat ascii 1.0\n", "no line 'end_header'"),
    ("a.ply", b"ply\nformat spiral 1.0\nend_header\n", "line 2 of its header is not understood: 'format spiral 1.0'"),
    ("a.ply", b"ply\nformat ascii 1.0\nelement vertex -5\nend_header\n", "line 3 of its header"),
    ("a.ply", _ply(999_999_999_999, 1, TRIANGLE), "announces 999999999999 of 'vertex', but the file ends after 3"),
    ("a.ply", _ply(3, 999_999_999_999, TRIANGLE + b"\3" + bytes(12)), "announces 999999999999 of 'face', but the file ends after 1"),
    ("a.ply", _ply(3, 1, TRIANGLE + b"\xff\xff\xff\x7f", "int"), "but the file ends after 0"),
    ("a.ply", _ply(3, 1, TRIANGLE + b"\xff\xff\xff\xff", "int"), "face 1 has a list of -1 values"),
    ("a.ply", _ply(3, 1, TRIANGLE + b"\3" + np.array([0, 1, 7], "<i4").tobytes()), "names the vertex 7, but there are 3"),
    ("a.ply", _ply(3, 1, TRIANGLE + b"\2" + bytes(8)), "face 1 of 1 has fewer than 3 corners"),
    ("a.ply", _ply(3, 1, TRIANGLE.replace(b"\x80?", b"\xc0\x7f") + b"\3" + bytes(12)), "not finite"),
    ("a.ply", _ply(3, 1, b"0 0 0 1 0 0 0 1 zero 3 0 1 2", order="ascii"), "line 10 holds 'zero', which is no number"),
    ("a.ply", _ply(3, 1, b"0 0 0 1 0 0 0 1 0 3 0 1", order="ascii"), "announces 1 of 'face', but the file ends after 0"),
    ("a.obj", b"v 0 0 0\nv 1 0 0\nv 0 1\nf 1 2 3\n", "line 3 cannot be right: 'v 0 1'"),
    ("a.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9999999999999999999999\n", "a face names the vertex 9999999999999999999999"),
    ("a.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -7\n", "line 4 names the vertex -7"),
    ("a.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 x\n", "line 4 cannot be right"),
    ("a.obj", b"v 0 0 0\nv 1 0 nan\nv 0 1 0\nf 1 2 3\n", "first point 2 of 3 (1, 0, nan)"),
    ("a.vtp", b"<VTKFile><oops>", "XML is damaged"),
    ("a.vtp", b"<AppendedData" * 50_000, "XML is damaged"),
    ("a.vtp", b'<!DOCTYPE a [<!ENTITY b "c">]><VTKFile/>', "declares entities"),
    ("a.vtp", b'<VTKFile type="ImageData"/>', "no VTKFile of the type PolyData"),
    ("a.vtp", _vtp(999_999_999_999, 1), "holds 9 values where 2999999999997 are announced"),
    ("a.vtp", _vtp(3, 999_999_999_999), "'offsets' holds 1 values where 999999999999 are announced"),
    ("a.vtp", _vtp(3, 1, offsets="4000000000"), "have 3 corners, but their offsets end at 4000000000"),
    ("a.vtp", _vtp(3, 2, offsets="3 1"), "do not rise"),
    ("a.vtp", _vtp(3, 1, connectivity="0 1 3"), "names the vertex 3, but there are 3"),
    ("a.vtp", _vtp(3, 1, connectivity="0 1 -1"), "names the vertex -1"),
    ("a.vtp", _vtp(3, 1, extra='compressor="vtkOddCompressor"'), "compressor 'vtkOddCompressor' is not known"),
    ("a.step", b"ISO-10303-21;", "files that end in '.step' are not known"),
    ("a.stl", b"", "it is empty"),
]


@pytest.mark.parametrize(("name", "content", "reason"), LIES, ids=[f"{n}-{r[:30]}" for n, _, r in LIES])
def test_lies_are_named_and_cost_nothing(tmp_path: Path, capfd: pytest.CaptureFixture[str], name: str, content: bytes, reason: str) -> None:
    (tmp_path / name).write_bytes(content)
    tracemalloc.start()
    try:
        with pytest.raises(InputFileError) as caught:
            read_mesh(tmp_path / name)
        assert tracemalloc.get_traced_memory()[1] < MOST_MEMORY
    finally:
        tracemalloc.stop()
    assert caught.value.code == "E-FILE-02"
    assert reason in str(caught.value)
    assert name in str(caught.value)
    assert capfd.readouterr() == ("", "")


def test_compressed_blocks_that_promise_gigabytes(tmp_path: Path) -> None:
    """A bomb: a small block that says it becomes four gigabytes."""
    for compressor in ("vtkZLibDataCompressor", "vtkLZ4DataCompressor", "vtkLZMADataCompressor"):
        head = np.array([1, 0xFFFFFFF0, 0, 8], "<u4").tobytes()
        content = (
            (
                f'<VTKFile type="PolyData" compressor="{compressor}"><PolyData><Piece NumberOfPoints="357913940" NumberOfPolys="0"><Points>'
                '<DataArray type="Float32" NumberOfComponents="3" format="appended" offset="0"/></Points></Piece></PolyData>'
                '<AppendedData encoding="raw">_'
            ).encode()
            + head
            + b"12345678</AppendedData></VTKFile>"
        )
        tracemalloc.start()
        try:
            with pytest.raises(MalformedError):
                MESH_PARSERS[".vtp"](content)
            assert tracemalloc.get_traced_memory()[1] < MOST_MEMORY
        finally:
            tracemalloc.stop()


def test_many_arrays_that_name_the_same_bytes() -> None:
    """Another bomb: what is small once is large a thousand times."""
    values = 1_000_000
    packed = zlib.compress(bytes(4 * values), 9)
    block = np.array([1, 4 * values, 0, len(packed)], "<u4").tobytes() + packed
    arrays = "".join(f'<DataArray type="Float32" Name="a{i}" format="appended" offset="{len(block) * 3}"/>' for i in range(1000))
    head = np.array([3, 4 * values, 0, *[len(packed)] * 3], "<u4").tobytes() + packed * 3
    content = (
        f'<VTKFile type="PolyData" compressor="vtkZLibDataCompressor"><PolyData><Piece NumberOfPoints="{values}" NumberOfPolys="0"><Points>'
        '<DataArray type="Float32" NumberOfComponents="3" format="appended" offset="0"/></Points>'
        f'<PointData>{arrays.replace(str(len(block) * 3), str(len(head)))}</PointData></Piece></PolyData><AppendedData encoding="raw">_'
    ).encode() + head + block + b"</AppendedData></VTKFile>"  # fmt: skip
    tracemalloc.start()
    try:
        with pytest.raises(MalformedError, match="too large for the file"):
            MESH_PARSERS[".vtp"](content)
        assert tracemalloc.get_traced_memory()[1] < 300_000_000
    finally:
        tracemalloc.stop()


@pytest.mark.parametrize(
    ("suffix", "content"),
    [
        (".xyz", b"1" * 60_000 + b"x"),
        (".csv", b"a," * 30_000),
        (".xyz", b"(" * 60_000),
        (".xyz", b" " * 60_000 + b"x"),
        (".vtp", b"<AppendedData" + b" " * 60_000),
        (".stl", b"solid" + b"\n" * 60_000 + b"facet normal" + b" " * 1000),
    ],
    ids=range(6),
)
def test_searches_that_fail_stay_quick(suffix: str, content: bytes) -> None:
    """Each took minutes, or would with a careless pattern."""
    if suffix in MESH_PARSERS:
        with pytest.raises(MalformedError):
            MESH_PARSERS[suffix](content)
    else:  # a line of names without rows
        assert len(POINT_PARSERS[suffix](content)) == 0


def test_a_document_type_is_refused_wherever_and_in_whatever_encoding() -> None:
    text = '<?xml version="1.0"?>' + "<!--" + "x" * 5000 + '--><!DOCTYPE a [<!ENTITY b "cccccccccc">]><VTKFile>&b;</VTKFile>'
    for content in (text.encode(), text.encode("utf-16")):
        with pytest.raises(MalformedError, match="declares entities"):
            MESH_PARSERS[".vtp"](content)


def test_a_file_of_python_2_is_read_without_a_word(capfd: pytest.CaptureFixture[str]) -> None:
    content = npy(np.arange(60.0).reshape(20, 3)).replace(b"(20, 3), ", b"(20L, 3),")
    assert len(POINT_PARSERS[".npy"](content)) == 20
    assert capfd.readouterr() == ("", "")


def test_files_beyond_the_limit_are_not_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("scanner_core.mesh_io.reader.MOST_BYTES", 100)
    (tmp_path / "a.stl").write_bytes(bytes(101))
    with pytest.raises(InputFileError, match=r"101 bytes, and 100 are the limit.*E-FILE-05"):
        read_mesh(tmp_path / "a.stl")


def test_polygons_that_cross_themselves_do_not_cost_without_end(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("scanner_core.mesh_io.polygons._VAIN_TESTS", 1000)
    rng = np.random.default_rng(0)
    faces = b"".join(b"f " + b" ".join(b"%d" % i for i in rng.permutation(200) + 1) + b"\n" for _ in range(20))
    mesh = MESH_PARSERS[".obj"](b"".join(b"v %f %f %f\n" % tuple(v) for v in rng.normal(size=(200, 3))) + faces)
    assert len(mesh.triangles) == 20 * 198


@pytest.mark.parametrize("suffix", [".stl", ".ply", ".obj", ".vtp"])
def test_meshes_without_triangles(tmp_path: Path, suffix: str) -> None:
    empty = {
        ".stl": bytes(84),
        ".ply": _ply(3, 0, TRIANGLE),
        ".obj": b"v 0 0 0\n",
        ".vtp": _vtp(3, 0),
    }[suffix]
    (tmp_path / f"a{suffix}").write_bytes(empty)
    with pytest.raises(InputFileError, match=r"holds no triangles.*E-FILE-03"):
        read_mesh(tmp_path / f"a{suffix}")


def test_missing_files_folders_and_forbidden_files(tmp_path: Path) -> None:
    with pytest.raises(InputFileError, match="E-FILE-01"):
        read_mesh(tmp_path / "no.stl")
    (tmp_path / "folder.stl").mkdir()
    with pytest.raises(InputFileError, match="E-FILE-05"):
        read_mesh(tmp_path / "folder.stl")
    with pytest.raises(InputFileError, match="E-FILE-05"):
        read_mesh(tmp_path / "nul\0.stl")
    if hasattr(os, "mkfifo"):
        os.mkfifo(tmp_path / "pipe.stl")
        with pytest.raises(InputFileError, match="E-FILE-05"):
            read_mesh(tmp_path / "pipe.stl")  # and does not wait for a writer
