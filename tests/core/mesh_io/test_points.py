"""Point clouds in the dialects that other programs write."""

from __future__ import annotations

import io
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from scanner_core.errors import InputFileError
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.mesh_io import check_suffix, read_points, write_points
from scanner_core.mesh_io.points import parse_text_points

POINTS = [[1.5, -2.0, 3.25], [4.0, 5.0, 6.0]]


@pytest.mark.parametrize(
    "text",
    [
        "1.5 -2 3.25\n4 5 6\n",
        "1.5,-2,3.25\n4,5,6",
        "1.5, -2, 3.25\r\n4, 5, 6\r\n",
        "1.5;-2;3.25\n4;5;6\n",
        "1,5;-2,0;3,25\n4,0;5,0;6,0\n",
        "1.5\t-2\t3.25\n\n4\t5\t6\n\n",
        "# a comment\n1.5 -2 3.25 # here too\n// and here\n% and here\n4 5 6\n",
        "2\n1.5 -2 3.25\n4 5 6\n",
        "x y z\n1.5 -2 3.25\n4 5 6\n",
        "X,Y,Z,Intensity\n1.5,-2,3.25,7\n4,5,6,8\n",
        '"x_mm","y_mm","z_mm"\n1.5,-2,3.25\n4,5,6\n',
        "x [mm];y [mm];z [mm]\n1,5;-2;3,25\n4;5;6\n",
        "id,time,z,y,x\n1,0.1,3.25,-2,1.5\n2,0.2,6,5,4\n",
        "quality,Points:0,Points:1,Points:2\n9,1.5,-2,3.25\n9,4,5,6\n",
        "//X Y Z R G B\n1.5 -2 3.25 255 0 0\n4 5 6 0 255 0\n",
        "1.5e0 -2E+0 +3.25\n4. 5 6\n",
        "\ufeff1.5 -2 3.25\n4 5 6\n",
        "Punkt;Wert;Höhe\n1.5;-2;3.25\n4;5;6\n",
        "\n\n  1.5   -2   3.25  \n   4 5 6",
    ],
)
@pytest.mark.parametrize("suffix", [".xyz", ".TXT", ".csv", ".asc"])
def test_dialects_of_text(tmp_path: Path, text: str, suffix: str) -> None:
    (tmp_path / f"points{suffix}").write_bytes(text.encode("utf-8"))
    assert read_points(tmp_path / f"points{suffix}").points.tolist() == POINTS


def test_utf_16_text() -> None:
    assert parse_text_points("x y z\n1.5 -2 3.25\n4 5 6\n".encode("utf-16")).points.tolist() == POINTS


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("1 2 3\n4 5\n", "line 2 has 2 columns where the first row has 3"),
        ("# c\n1 2 3\n\n4 5 6 7\n", "line 4 has 4 columns"),
        ("1 2 3\n4 five 6\n", "line 2 holds 'five', which is no number"),
        ("1 2\n3 4\n", "it has 2 columns, but x, y and z are needed"),
        ("x y z\n", "holds no points"),
        ("# nothing\n", "holds no points"),
        ("", "it is empty"),
        ("1 2 3\nnan 5 6\n", "not finite"),
        ("1 2 3\n4 5 1e300\n", "impossibly far"),
        ("x,y,w,z\n1,2,3\n4,5,6\n", "its first line names 4"),
        ("names\n\x1c \n", "it holds no numbers"),
        ("[" * 100_000, "holds no points"),
        ("1 2 3\n\x00\x00\x00", "it is no text"),
    ],
)
def test_what_is_wrong_in_a_text_is_said_with_its_line(tmp_path: Path, text: str, reason: str) -> None:
    (tmp_path / "points.csv").write_text(text, encoding="utf-8")
    with pytest.raises(InputFileError) as caught:
        read_points(tmp_path / "points.csv")
    assert caught.value.code == "E-FILE-04"
    assert reason in str(caught.value)


@settings(max_examples=30)
@given(st.lists(st.tuples(*[st.floats(-1e4, 1e4)] * 3), min_size=1, max_size=30), st.sampled_from([" ", ",", ";", "\t", ", "]))
def test_numbers_with_all_their_digits_come_back(rows: list[tuple[float, float, float]], delimiter: str) -> None:
    text = "\n".join(delimiter.join(map(repr, row)) for row in rows)
    assert parse_text_points(text.encode()).points.tolist() == [list(row) for row in rows]


@pytest.mark.parametrize("kind", ["<f8", "<f4", ">f8", "<i4"])
@pytest.mark.parametrize("order", ["C", "F"])
def test_npy(tmp_path: Path, kind: str, order: str) -> None:
    values = np.array([[1, -2, 3, 99], [4, 5, 6, 99]])
    np.save(tmp_path / "points.npy", np.asarray(values, kind, order=order))
    assert read_points(tmp_path / "points.npy").points.tolist() == [[1, -2, 3], [4, 5, 6]]


def npy(values: np.ndarray) -> bytes:
    file = io.BytesIO()
    np.save(file, values, allow_pickle=True)
    return file.getvalue()


@pytest.mark.parametrize(
    ("content", "reason"),
    [
        (npy(np.array([{"a": 1}], object)), "instead of numbers"),
        (npy(np.zeros(3, [("x", "f8")])), "instead of numbers"),
        (npy(np.zeros((4, 2))), "shape (4, 2)"),
        (npy(np.zeros((2, 3, 4))), "shape (2, 3, 4)"),
        (npy(np.zeros((0, 3))), "holds no points"),
        (npy(np.full((2, 3), np.nan)), "not finite"),
        (npy(np.zeros((4, 3)))[:-1], "too short"),
        (npy(np.zeros((4, 3))).replace(b"(4, 3), ", b"(9**9,3)"), "damaged"),
        (npy(np.zeros((4, 3))).replace(b"(4, 3), }", b"(99999999999999, 3), }"), "too short"),
        (b"\x93NUMPY", "damaged"),
        (b"PK\x03\x04 a zip", "damaged"),
    ],
)
def test_npy_that_cannot_be_read(tmp_path: Path, content: bytes, reason: str) -> None:
    (tmp_path / "points.npy").write_bytes(content)
    with pytest.raises(InputFileError) as caught:
        read_points(tmp_path / "points.npy")
    assert caught.value.code == "E-FILE-04"
    assert reason in str(caught.value)


def test_a_header_that_promises_too_much_costs_nothing(tmp_path: Path) -> None:
    header = b"{'descr': '<f8', 'fortran_order': False, 'shape': (99999999999999, 3), }".ljust(117) + b"\n"
    (tmp_path / "points.npy").write_bytes(b"\x93NUMPY\x01\x00" + len(header).to_bytes(2, "little") + header + bytes(24))
    with pytest.raises(InputFileError, match="announces 99999999999999 points"):
        read_points(tmp_path / "points.npy")


def cloud(count: int = 50, seed: int = 3) -> PointCloud:
    rng = np.random.default_rng(seed)
    root = rng.normal(size=(count, 3, 3)) * 0.01
    return PointCloud(rng.normal(0, 30, (count, 3)), root @ root.transpose(0, 2, 1), rng.integers(0, 8, count).astype(np.int32), np.arange(count) * 7)


def test_ply_keeps_all_that_is_known_of_a_point(tmp_path: Path) -> None:
    some = cloud()
    write_points(tmp_path / "points.ply", some)
    found = read_points(tmp_path / "points.ply")
    assert (found.points == some.points).all()
    assert found.covariances is not None
    assert found.covariances == pytest.approx(some.covariances, rel=1e-12)
    assert found.views is not None
    assert (found.views == some.views).all()
    assert found.trigger_ids is not None
    assert (found.trigger_ids == some.trigger_ids).all()
    write_points(tmp_path / "bare.ply", PointCloud(some.points))
    bare = read_points(tmp_path / "bare.ply")
    assert bare.covariances is None
    assert bare.views is None
    assert bare.trigger_ids is None


def test_xyz_keeps_nanometres(tmp_path: Path) -> None:
    some = cloud(70_000 // 30)
    write_points(tmp_path / "points.xyz", some)
    assert np.abs(read_points(tmp_path / "points.xyz").points - some.points).max() <= 0.51e-6
    with pytest.raises(InputFileError, match=r"\.xyz, \.ply.*E-FILE-06"):
        write_points(tmp_path / "points.las", some)
    with pytest.raises(InputFileError, match="E-FILE-06"):
        check_suffix(tmp_path / "points.stl", points=True)


def test_missing_unknown_and_unreadable_files(tmp_path: Path) -> None:
    for path, code in ((tmp_path / "no.xyz", "E-FILE-01"), (tmp_path, "E-FILE-05")):
        with pytest.raises(InputFileError, match=code):
            read_points(path)
    (tmp_path / "points.las").write_bytes(b"LASF")
    with pytest.raises(InputFileError, match=r"E-FILE-04"):
        read_points(tmp_path / "points.las")
