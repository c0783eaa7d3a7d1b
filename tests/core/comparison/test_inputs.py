"""A surface is read as it is: its unit found out, what is odd about it named, nothing repaired."""

from __future__ import annotations

import hashlib
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from scanner_core.case.store import CaseStore, Order
from scanner_core.comparison.aligning import align
from scanner_core.comparison.comparison_values import surface_values
from scanner_core.comparison.doubt import Doubt
from scanner_core.comparison.inputs import mesh_hash, read_surface
from scanner_core.comparison.parameters import ComparisonParameters, Frame
from scanner_core.comparison.surface import LEAST_TRIANGLES, ComparedSurface
from scanner_core.comparison.unit_guess import guessed_unit
from scanner_core.comparison.vetting import count_crossing, vet
from scanner_core.errors import ComparisonError, ImprontaError, InputFileError, UsageError
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.self_intersection import self_intersecting_triangles
from scanner_core.mesh_io import write_mesh
from tests.core.case.test_processing import small_case
from tests.core.comparison.compared import named
from tests.core.comparison.shapes import cut, egg, scaled, turned_inside_out
from tests.core.comparison.small_arch import small_arch
from tests.core.geometry.solids import box, joined, moved
from tests.core.mesh_io.test_meshes import ascii_stl, ply_text


def read(folder: Path, mesh: TriangleMesh, suffix: str = ".stl", **options: str) -> ComparedSurface:
    write_mesh(folder / f"a{suffix}", mesh)
    return read_surface(folder / f"a{suffix}", **options)


def codes(surface: ComparedSurface) -> list[str]:
    return [doubt.code for doubt in surface.doubts]


@pytest.mark.parametrize("suffix", [".stl", ".ply", ".obj", ".3mf"])
def test_our_own_files_say_that_they_are_in_millimetres(tmp_path: Path, suffix: str) -> None:
    surface = read(tmp_path, egg(), suffix)
    assert (surface.unit, surface.unit_reason, codes(surface)) == ("mm", "the file says so", [])
    assert np.abs(surface.mesh.corners()[0] - egg().corners()[0]).max() < 1e-5
    assert surface.sha256 == hashlib.sha256((tmp_path / f"a{suffix}").read_bytes()).hexdigest()
    assert surface.supported.all()
    assert surface.name == f"a{suffix}"


@pytest.mark.parametrize(("unit", "per_mm"), [("mm", 1.0), ("cm", 0.1), ("m", 1e-3), ("inch", 1 / 25.4)])
def test_an_arch_is_an_arch_in_every_unit(tmp_path: Path, unit: str, per_mm: float) -> None:
    """Without a word in the file, its size tells; 40 to 90 mm are an arch."""
    for largest in (41.0, 60.0, 89.0):
        (tmp_path / "a.stl").write_bytes(ascii_stl(scaled(egg(largest), per_mm)))
        surface = read_surface(tmp_path / "a.stl")
        assert (surface.unit, np.ptp(surface.mesh.vertices, axis=0).max()) == (unit, pytest.approx(largest, rel=1e-6))
        assert [doubt.serious for doubt in surface.doubts if doubt.code == "unit-guessed"] == ([] if unit == "mm" else [True])
        assert "guessed from the size" in surface.unit_reason


def test_an_ear_in_inches_is_no_splinter() -> None:
    assert [guessed_unit(length / 25.4)[0] for length in (10.0, 30.0, 50.0)] == ["inch"] * 3
    assert [guessed_unit(length)[0] for length in (10.0, 30.0, 50.0)] == ["mm"] * 3


def test_a_person_overrules_guess_and_file(tmp_path: Path) -> None:
    (tmp_path / "b.stl").write_bytes(ascii_stl(scaled(egg(30.0), 0.1)))
    assert read_surface(tmp_path / "b.stl").unit == "inch"
    surface = read_surface(tmp_path / "b.stl", unit="cm")
    assert (surface.unit, np.ptp(surface.mesh.vertices[:, 0])) == ("cm", pytest.approx(30.0))
    assert surface.unit_reason == "as it was asked for"
    for suffix in (".stl", ".3mf"):
        over = read(tmp_path, egg(2.0), suffix, unit="inch")
        assert np.ptp(over.mesh.vertices[:, 0]) == pytest.approx(2 * 25.4)
        assert "the file says millimetres" in over.unit_reason
    with pytest.raises(UsageError, match="no unit 'ell'"):
        read_surface(tmp_path / "b.stl", unit="ell")


def test_a_small_crown_is_not_taken_for_a_large_one_in_silence(tmp_path: Path) -> None:
    """9.6 mm without a word of the unit look like 9.6 cm: every number would be ten times as large."""
    (tmp_path / "crown.stl").write_bytes(ascii_stl(egg(9.6)))
    assert any(doubt.serious for doubt in read_surface(tmp_path / "crown.stl").doubts)
    assert not any(doubt.serious for doubt in read_surface(tmp_path / "crown.stl", unit="mm").doubts)


def test_a_file_whose_word_and_size_disagree_is_named(tmp_path: Path) -> None:
    surface = read(tmp_path, egg(2.4))
    assert surface.unit == "mm"
    assert {"unit-odd", "size-odd"} <= set(codes(surface))


def test_what_is_odd_is_named_and_left(tmp_path: Path) -> None:
    whole = egg()
    bodies = {
        "open": (cut(whole, 10.0), False),
        "several-shells": (joined(whole, moved(egg(6.0), (80, 0, 0))), False),
        "normals-inverted": (turned_inside_out(whole), True),
        "normals-seem-inverted": (turned_inside_out(cut(whole, 10.0)), True),
        "winding-inconsistent": (TriangleMesh(whole.vertices, np.concatenate([whole.triangles[:40, ::-1], whole.triangles[40:]])), True),
        "non-manifold": (joined(whole, scaled(box(), 20.0)), False),
        "self-touching": (joined(whole, moved(whole, (20, 0, 0))), False),
    }
    bodies["non-manifold"] = (TriangleMesh(whole.vertices, np.concatenate([whole.triangles, [[0, 5, 100]]])), False)
    bodies["winding-faults"] = (TriangleMesh(whole.vertices, np.concatenate([whole.triangles[:2, ::-1], whole.triangles[2:]])), False)
    for code, (mesh, serious) in bodies.items():
        surface = read(tmp_path, mesh, ".ply")
        (tmp_path / "a.ply").unlink()
        doubt = next((doubt for doubt in surface.doubts if doubt.code == code), None)
        assert doubt is not None, (code, codes(surface))
        assert doubt.serious is serious
        assert (surface.mesh.triangles == mesh.triangles).all()
        assert np.abs(surface.mesh.vertices - mesh.vertices).max() < 1e-5


def test_an_open_arch_that_faces_inwards_is_not_reliable(tmp_path: Path) -> None:
    """All signs and colours would be exchanged."""
    for mesh, pose in ((small_arch(), np.eye(3)), (cut(small_arch(), 4.0), Rotation.from_rotvec([0.4, 2.0, -1.0]).as_matrix())):
        lying = TriangleMesh(mesh.vertices @ pose.T, mesh.triangles)
        assert not any("inverted" in doubt.code for doubt in vet(lying))
        (doubt,) = (doubt for doubt in vet(turned_inside_out(lying)) if "inverted" in doubt.code)
        assert (doubt.code, doubt.serious) == ("normals-inverted", True)


def test_faults_are_counted_in_words() -> None:
    whole = egg()
    triangles = np.concatenate([whole.triangles, [[*whole.triangles[0, :2], len(whole.vertices)]]])
    fin = TriangleMesh(np.concatenate([whole.vertices, [[0.0, 0.0, 70.0]]]), triangles)
    words = next(doubt.words for doubt in vet(fin) if doubt.code == "non-manifold")
    assert words.startswith("Edges that belong to more than two triangles: 1; corners that join separate parts: 0. Inside")


def test_shells_are_counted_and_weighed(tmp_path: Path) -> None:
    surface = read(tmp_path, joined(egg(), moved(egg(30.0), (80, 0, 0))))
    words = next(doubt.words for doubt in surface.doubts if doubt.code == "several-shells")
    assert "2 separate shells; the largest has 80.0 %" in words


def test_crossings_are_counted_until_there_are_too_many(tmp_path: Path) -> None:
    """In a soup of large triangles nearly every pair crosses: counting stops, by the number of triangles it was given."""
    rng = np.random.default_rng(0)
    soup = TriangleMesh(rng.uniform(0, 50, (9000, 3)), np.arange(9000).reshape(-1, 3))
    crossing, counted = count_crossing(soup)
    assert 125 < crossing <= 500
    assert not counted
    assert f"more than {crossing} triangles cut others" in next(doubt.words for doubt in vet(soup) if doubt.code == "self-touching")
    whole = joined(egg(), moved(egg(), (20, 0, 0)))
    assert count_crossing(whole) == (len(self_intersecting_triangles(whole)), True)


def test_what_is_read_is_never_refused_for_too_few_triangles() -> None:
    few = egg(around=10, across=5)  # 80 triangles
    with pytest.raises(ComparisonError, match="E-CMP-04"):
        align(named(few, "a"), named(few, "b"), ComparisonParameters(), progress=lambda _: None, cancelled=lambda: False)
    assert len(few.triangles) < LEAST_TRIANGLES
    more = egg(around=12, across=6)
    assert len(more.triangles) > LEAST_TRIANGLES
    align(named(more, "a"), named(more, "b"), ComparisonParameters(Frame.GIVEN), progress=lambda _: None, cancelled=lambda: False)


def test_a_sheet_is_not_accused_of_facing_inwards(tmp_path: Path) -> None:
    x, y = np.meshgrid(np.arange(20.0), np.arange(20.0), indexing="ij")
    at = np.arange(400).reshape(20, 20)
    p, q, r, s = (part.ravel() for part in (at[:-1, :-1], at[1:, :-1], at[1:, 1:], at[:-1, 1:]))
    sheet = TriangleMesh(
        np.column_stack([x.ravel() * 3, y.ravel() * 3, 0.3 * np.sin(x.ravel())]),
        np.concatenate([np.column_stack([p, q, r]), np.column_stack([p, r, s])]),
    )
    assert codes(read(tmp_path, sheet)) == ["open"]
    (tmp_path / "a.stl").unlink()
    assert codes(read(tmp_path, turned_inside_out(sheet))) == ["open"]


def test_triangles_without_area_and_points_apart_are_named(tmp_path: Path) -> None:
    mesh = egg()
    soup = TriangleMesh(mesh.vertices[mesh.triangles].reshape(-1, 3), np.arange(3 * len(mesh.triangles)).reshape(-1, 3))
    soup = TriangleMesh(np.concatenate([soup.vertices, [[7, 7, 7]]]), soup.triangles)
    (tmp_path / "a.ply").write_bytes(ply_text(soup, "ascii"))
    surface = read_surface(tmp_path / "a.ply")
    assert codes(surface) == ["points-joined", "points-loose"]
    assert len(surface.mesh.vertices) == len(mesh.vertices)
    assert surface.mesh.volume() == pytest.approx(mesh.volume(), rel=1e-6)
    flat = TriangleMesh(np.concatenate([mesh.vertices, mesh.vertices[:2].mean(axis=0, keepdims=True)]), mesh.triangles)
    flat = TriangleMesh(flat.vertices, np.concatenate([flat.triangles, [[0, 1, len(mesh.vertices)]]]))
    (tmp_path / "b.ply").write_bytes(ply_text(flat, "ascii"))
    assert "degenerate-triangles" in codes(read_surface(tmp_path / "b.ply"))


def test_what_was_measured_is_kept_apart(tmp_path: Path) -> None:
    mesh = egg()
    supported = mesh.vertices[:, 2] > 5
    attributes = {"supported": supported.astype(np.uint8), "standard_uncertainty_um": np.full(len(supported), 12.0, np.float32)}
    surface = read(tmp_path, TriangleMesh(mesh.vertices, mesh.triangles, attributes), ".ply")
    assert (surface.supported == supported).all()
    assert surface.mesh.vertex_attributes["standard_uncertainty_um"] == pytest.approx(12.0)
    nothing = TriangleMesh(mesh.vertices, mesh.triangles, {"supported": np.zeros(len(supported), np.uint8)})
    (tmp_path / "a.ply").unlink()
    with pytest.raises(InputFileError, match="No part of the surface"):
        read(tmp_path, nothing, ".ply")


LINE = b"".join(b"v %d 0 0\n" % i for i in range(199)) + b"".join(b"f %d %d %d\n" % (i, i + 1, i + 2) for i in range(1, 198))


@pytest.mark.parametrize(
    ("name", "content", "code", "words"),
    [
        ("one.stl", ascii_stl(TriangleMesh(np.eye(3) * 50, np.array([[0, 1, 2]]))), "E-CMP-20", "holds too few triangles for a comparison: 1, but"),
        ("few.stl", ascii_stl(box(50.0)), "E-CMP-20", "holds too few triangles for a comparison: 12, but"),
        (
            "line.obj",
            LINE,
            "E-CMP-21",
            "all lie in one",
        ),
        ("nan.obj", b"v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "E-FILE-02", "not finite"),
        ("empty.stl", b"", "E-FILE-02", "it is empty"),
        ("none.obj", b"v 0 0 0\n", "E-FILE-03", "holds no triangles"),
        ("a.step", b"ISO-10303-21;", "E-FILE-02", "'.step' are not known"),
    ],
)
def test_what_cannot_be_compared_is_refused(tmp_path: Path, name: str, content: bytes, code: str, words: str) -> None:
    (tmp_path / name).write_bytes(content)
    with pytest.raises(ImprontaError, match=words) as refusal:
        read_surface(tmp_path / name)
    assert refusal.value.code == code


@pytest.fixture
def case(tmp_path: Path) -> Path:
    path = tmp_path / "a.impronta"
    path.write_bytes(small_case())
    mesh = egg()
    attributes = {"supported": (mesh.vertices[:, 2] > 5).astype(np.uint8)}
    with CaseStore.open(path) as store:
        store.put_order(Order("4711", "Jane Doe", "left", "arch", "Jane's lower jaw"))
        store.put_mesh(TriangleMesh(mesh.vertices, mesh.triangles, attributes), {"seed": 0})
    return path


def test_a_case_gives_its_mesh_and_where_it_comes_from(case: Path) -> None:
    before = case.read_bytes()
    surface = read_surface(case)
    assert (surface.unit, surface.sha256) == ("mm", mesh_hash(egg()))
    assert (surface.supported == (egg().vertices[:, 2] > 5)).all()
    told = surface.origin
    assert (told["order"], told["side"], told["type"], told["rig"]) == ("4711", "left", "arch", "bench")
    assert {"date", "calibration_id", "calibration_date", "mesh_id"} <= told.keys()
    assert "Jane" not in str(surface_values(surface))
    assert case.read_bytes() == before
    with pytest.raises(UsageError, match="in millimetres"):
        read_surface(case, unit="inch")


def test_a_case_without_a_surface_is_refused(tmp_path: Path) -> None:
    (tmp_path / "b.impronta").write_bytes(small_case())
    with pytest.raises(ImprontaError, match="holds no mesh yet"):
        read_surface(tmp_path / "b.impronta")


def test_the_hash_is_of_places_and_triangles() -> None:
    mesh = egg()
    nudged = mesh.vertices.copy()
    nudged[0, 0] += 1e-12
    assert mesh_hash(mesh) == mesh_hash(replace(mesh, vertex_attributes={"a": np.zeros(len(mesh.vertices))}))
    assert mesh_hash(mesh) != mesh_hash(TriangleMesh(nudged, mesh.triangles))


def test_a_doubt_keeps_what_a_window_translates_it_by() -> None:
    doubt = Doubt.told("open/one", False, mm="12")
    assert (doubt.code, doubt.serious) == ("open", False)
    assert doubt.words == doubt.template.format(**dict(doubt.fields))
    assert "12 mm in one line" in doubt.words
