"""3MF is read as it is meant (units, motions, assemblies) and refused where it lies."""

from __future__ import annotations

import io
import tracemalloc
import zipfile
from pathlib import Path

import numpy as np
import pytest

from scanner_core.geometry.checks import check_mesh
from scanner_core.mesh_io import read_mesh, write_mesh
from scanner_core.mesh_io.malformed import MalformedError
from scanner_core.mesh_io.threemf import RELATIONS
from scanner_core.mesh_io.threemf_package import parse_3mf, unit_of_3mf
from tests.core.geometry.solids import box, torus

NAMESPACE = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"


def mesh_xml(size: float = 1.0) -> str:
    mesh = box(size)
    vertices = "".join(f'<vertex x="{x:g}" y="{y:g}" z="{z:g}"/>' for x, y, z in mesh.vertices)
    triangles = "".join(f'<triangle v1="{a}" v2="{b}" v3="{c}"/>' for a, b, c in mesh.triangles)
    return f"<mesh><vertices>{vertices}</vertices><triangles>{triangles}</triangles></mesh>"


def model(resources: str, build: str, unit: str = "millimeter", before: str = "", more: str = "") -> bytes:
    return f'{before}<model unit="{unit}" xmlns="{NAMESPACE}" {more}><resources>{resources}</resources><build>{build}</build></model>'.encode()


def package(content: bytes, others: dict[str, bytes] | None = None) -> bytes:
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as parts:
        parts.writestr("_rels/.rels", RELATIONS)
        parts.writestr("3D/3dmodel.model", content)
        for name, part in (others or {}).items():
            parts.writestr(name, part)
    return file.getvalue()


BOX = f'<object id="1">{mesh_xml()}</object>'
PAIR = '<object id="2"><components><component objectid="1"/><component objectid="1" transform="1 0 0 0 1 0 0 0 1 5 0 0"/></components></object>'
ASSEMBLY = model(BOX + PAIR, '<item objectid="2" transform="0 1 0 -1 0 0 0 0 1 0 0 10"/><item objectid="1"/>', "centimeter")


def test_what_is_written_is_read_again(tmp_path: Path) -> None:
    mesh = torus()
    write_mesh(tmp_path / "a.3mf", mesh)
    found = read_mesh(tmp_path / "a.3mf")
    assert np.abs(found.vertices - mesh.vertices).max() < 1e-8
    assert (found.triangles == mesh.triangles).all()
    assert unit_of_3mf((tmp_path / "a.3mf").read_bytes()) == "millimeter"


def test_objects_stand_where_their_motions_put_them() -> None:
    found = parse_3mf(package(ASSEMBLY))
    assert check_mesh(found).components == 3
    assert found.volume() == pytest.approx(3 * 10.0**3)
    corners = box().vertices
    rows = np.concatenate([corners, corners + np.array([5, 0, 0])])
    turned = np.column_stack([-rows[:, 1], rows[:, 0], rows[:, 2] + 10])  # a row vector times the matrix: x goes to y
    assert np.abs(found.vertices - 10 * np.concatenate([turned, corners])).max() < 1e-12


@pytest.mark.parametrize(("unit", "size_mm"), [("micron", 1e-3), ("inch", 25.4), ("meter", 1000.0), ("foot", 304.8)])
def test_its_unit_counts(unit: str, size_mm: float) -> None:
    found = parse_3mf(package(model(BOX, '<item objectid="1"/>', unit)))
    assert np.ptp(found.vertices, axis=0) == pytest.approx(size_mm)


def test_a_motion_that_mirrors_leaves_the_outside_outside() -> None:
    found = parse_3mf(package(model(BOX, '<item objectid="1" transform="-1 0 0 0 1 0 0 0 1 0 0 0"/>')))
    assert found.volume() == pytest.approx(1.0)


def test_parts_in_several_files_and_support_are_told_apart() -> None:
    production = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06"
    split = model(
        f'<object id="9"><components><component p:path="/3D/Objects/a.model" objectid="1"/></components></object>'
        f'<object id="3" type="support">{mesh_xml(9)}</object>',
        '<item objectid="9"/><item objectid="3"/>',
        more=f'xmlns:p="{production}"',
    )
    found = parse_3mf(package(split, {"3D/Objects/a.model": model(BOX, "")}))
    assert found.volume() == pytest.approx(1.0)


def _nested(levels: int) -> bytes:
    objects = BOX + "".join(
        f'<object id="{n}"><components><component objectid="{n - 1}"/><component objectid="{n - 1}"/></components></object>' for n in range(2, levels)
    )
    return model(objects, f'<item objectid="{levels - 1}"/>')


CIRCLE = '<object id="1"><components><component objectid="1"/></components></object>'
LIES = {
    "nothing": (b"PK\x03\x04" + bytes(60), "no 3MF package"),
    "no part": (b"PK\x05\x06" + bytes(18), "lacks the part '_rels/.rels'"),
    "entities": (package(model(BOX, "", before='<!DOCTYPE a [<!ENTITY b "c">]>')), "declares entities"),
    "unit": (package(model(BOX, '<item objectid="1"/>', "cubit")), "its unit 'cubit' is none of"),
    "missing object": (package(model(BOX, '<item objectid="7"/>')), "the object '7', which is not there"),
    "circle": (package(model(CIRCLE, '<item objectid="1"/>')), "in a circle, or too often"),
    "avalanche": (package(_nested(30)), "too often|used so often"),
    "no number": (package(model(BOX.replace('x="1"', 'x="one"', 1), '<item objectid="1"/>')), "vertex 5 of its object '1' has the x 'one'"),
    "no vertex": (package(model(BOX.replace('v1="0"', 'v1="8"', 1), '<item objectid="1"/>')), "names the vertex 8, but there are 8"),
    "lacks z": (package(model(BOX.replace('z="0"', "", 1), '<item objectid="1"/>')), "vertex 1 of its object '1' lacks 'z'"),
    "nan": (package(model(BOX.replace('x="1"', 'x="nan"', 1), '<item objectid="1"/>')), "not finite"),
    "motion": (package(model(BOX, '<item objectid="1" transform="1 0 0"/>')), "not made of 12 numbers"),
    "another XML": (package(b"<svg/>"), "no 3MF model"),
    "bomb": (package(model(BOX + " " * 40_000_000, '<item objectid="1"/>')), "too many for a file of this size"),
}


@pytest.mark.parametrize("name", LIES)
def test_lies_are_named_and_cost_nothing(name: str) -> None:
    content, reason = LIES[name]
    tracemalloc.start()
    try:
        with pytest.raises(MalformedError, match=reason):
            parse_3mf(content)
        assert tracemalloc.get_traced_memory()[1] < 60_000_000
    finally:
        tracemalloc.stop()


def test_a_size_that_lies_is_found_out() -> None:
    """The entry says that it unpacks to little; no more than that is unpacked."""
    whole = package(model(BOX + " " * 40_000_000, '<item objectid="1"/>'))
    size = len(model(BOX + " " * 40_000_000, '<item objectid="1"/>')).to_bytes(4, "little")
    assert whole.count(size) == 2
    with pytest.raises(MalformedError, match="damaged"):
        parse_3mf(whole.replace(size, (1000).to_bytes(4, "little")))
