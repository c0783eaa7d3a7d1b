"""What is written beside the page: table, surface, page for the browser; and all of it or nothing."""

from __future__ import annotations

import csv
import re
from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from pydicom import dcmread

from scanner_core.comparison.report import html, plates, writer
from scanner_core.comparison.report.dicom import write_dicom
from scanner_core.comparison.report.html import report_html
from scanner_core.comparison.report.picture import Painter, fitted_scale
from scanner_core.comparison.report.surface import write_deviation
from scanner_core.comparison.report.table import COLUMNS, write_table
from scanner_core.comparison.report.viewpoint import viewpoints
from scanner_core.comparison.report.writer import NAMES, write_report
from scanner_core.errors import StorageError
from scanner_core.jobs.progress import Cancelled
from scanner_core.mesh_io.dicom import DicomSubject, write_encapsulated_stl
from scanner_core.mesh_io.ply import parse_ply
from scanner_core.mesh_io.stl import parse_stl
from tests.core.comparison.made import POSE, REMARK, SERIOUS, made

MADE = "2026-11-27T06:00:00+00:00"


def test_the_table_reads_back(tmp_path: Path) -> None:
    comparison = made(words='a "quoted", name')
    write_table(comparison, tmp_path / "table.csv")
    content = (tmp_path / "table.csv").read_bytes()
    assert content.startswith(b"\xef\xbb\xbfrank,words,")
    assert content.count(b"\r\n") == content.count(b"\n") == 3
    with (tmp_path / "table.csv").open(encoding="utf-8-sig", newline="") as file:
        rows = list(csv.DictReader(file))
    assert tuple(rows[0]) == COLUMNS
    assert [row["words"] for row in rows] == ['a "quoted", name 1', 'a "quoted", name 2']
    assert [float(row["max_um"]) for row in rows] == [900, -880]
    assert [float(row["p95_um"]) for row in rows] == [900, 880]
    assert (float(rows[0]["motion_mm"]), float(rows[0]["motion_expanded_uncertainty_k2_mm"])) == (0.9, 0.022)
    assert (float(rows[0]["rotation_deg"]), float(rows[0]["rotation_expanded_uncertainty_k2_deg"])) == (2.5, 0.24)
    assert (rows[1]["motion_mm"], rows[1]["above_null_level"]) == ("", "yes")


@pytest.mark.parametrize("first", "=+-@\t\r\n")
def test_no_text_becomes_a_formula(first: str, tmp_path: Path) -> None:
    write_table(made(words=f"{first}cmd|' /C calc'!A0"), tmp_path / "table.csv")
    with (tmp_path / "table.csv").open(encoding="utf-8-sig", newline="") as file:
        rows = list(csv.DictReader(file))
    assert all(row["words"].startswith("'") for row in rows)


def test_the_surface_reads_back_in_the_frame_of_before(tmp_path: Path) -> None:
    comparison = made()
    write_deviation(comparison, tmp_path / "deviation.ply")
    mesh = parse_ply((tmp_path / "deviation.ply").read_bytes())
    assert np.allclose(mesh.vertices, POSE.apply(comparison.after.mesh.vertices), atol=1e-5)
    assert np.array_equal(mesh.triangles, comparison.after.mesh.triangles)
    told = mesh.vertex_attributes
    expected = np.where(comparison.after.supported, comparison.deviation.signed_um, np.nan)
    assert np.allclose(told["deviation_um"].astype(np.float64), expected, equal_nan=True)
    assert np.isnan(expected).any()
    assert (told["detection_level_um"] == 90).all()
    assert np.array_equal(told["stable"].astype(np.bool_), comparison.alignment.stable)
    for area in comparison.areas:
        assert (told["area"][area.vertices] == area.rank).all()
    assert np.count_nonzero(told["area"]) == sum(len(area.vertices) for area in comparison.areas)
    colours = np.column_stack([told[name] for name in ("red", "green", "blue")])
    assert np.array_equal(colours, fitted_scale(comparison).colours(expected, comparison.deviation.level_um))


def test_the_page_for_the_browser_is_well_formed_and_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(html, "_WIDTH", 90)
    text = report_html(made(doubts=(REMARK, SERIOUS), words='<b>&"patch"', name="歯 & <zähne>.stl"), MADE)
    tree = ElementTree.fromstring(re.sub(r"<(style|script)>.*?</\1>", "", text.replace("<!DOCTYPE html>\n", ""), flags=re.DOTALL))
    links = [value for node in tree.iter() for name, value in node.attrib.items() if name in ("src", "href", "action", "data")]
    assert len(links) == 6
    assert all(link.startswith("data:image/png;base64,") for link in links)
    assert "http:" not in text
    assert "https:" not in text
    assert "@import" not in text
    words = " ".join(tree.itertext())
    for told in (
        f"Not reliable: AFTER: {SERIOUS.words}",
        REMARK.words,
        '<b>&"patch" 1',
        "歯 & <zähne>.stl",
        "a3" * 32,
        "AFTER outside of BEFORE",
        "0.90 ± 0.02",
    ):
        assert told in words
    assert "Jane Doe" not in text
    assert text == report_html(made(doubts=(REMARK, SERIOUS), words='<b>&"patch"', name="歯 & <zähne>.stl"), MADE)


def test_the_map_shows_both_signs_the_hatch_and_the_threshold() -> None:
    comparison = made()
    comparison = replace(comparison, alignment=replace(comparison.alignment, stable=np.arange(len(comparison.alignment.stable)) < 300))
    painter = Painter(comparison, fitted_scale(comparison))
    picture = painter.deviation(viewpoints(comparison)[0], 0.1, 320, 260)
    assert [rank for rank, _, _ in picture.numbers] == [1, 2]
    opaque = picture.pixels[..., 3] > 250
    assert 0.85 < opaque.mean() < 0.99
    red, blue = picture.pixels[..., 0].astype(int), picture.pixels[..., 2].astype(int)

    def shown(right: float, down: float) -> tuple[int, int]:
        row, column = int(down * 260), int(right * 320)
        return int(red[row, column]), int(blue[row, column])

    (first, second) = picture.numbers
    assert shown(*first[1:])[0] > shown(*first[1:])[1] + 60  # outward: orange
    assert shown(*second[1:])[1] > shown(*second[1:])[0] + 60  # inward: blue
    assert abs(first[1] - 0.5 - (-9.0 / 32)) < 0.02  # where the patch is
    assert abs(0.5 - first[2] - (-6.0 / 26)) < 0.02
    scale = fitted_scale(comparison)
    without = Painter(comparison, replace(scale, threshold_um=5000.0)).deviation(viewpoints(comparison)[0], 0.1, 320, 260)
    line = (picture.pixels != without.pixels).any(axis=2)
    assert 200 < line.sum() < 1000  # around two patches of 4 mm
    assert (picture.pixels[line].sum(axis=1) < without.pixels[line].sum(axis=1)).all()  # darker
    stable = painter.stable(viewpoints(comparison)[0], 0.1, 320, 260).pixels.astype(int)
    green = (stable[..., 1] > stable[..., 0] + 40) & (stable[..., 3] > 250)
    assert 0.25 < green.sum() / opaque.sum() < 0.5


def test_all_files_or_none(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(writer, "write_pdf", lambda comparison, path, made, cancelled: path.write_text(made))
    monkeypatch.setattr(writer, "write_html", lambda comparison, path, made, cancelled: path.write_text(comparison.areas[0].words))
    comparison = made()
    assert [path.name for path in write_report(comparison, tmp_path, made=MADE)] == list(NAMES)
    before = {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    assert sorted(before) == sorted(NAMES)
    with pytest.raises(StorageError, match="E-DISK-03"):
        write_report(comparison, tmp_path, made=MADE)
    write_report(comparison, tmp_path, force=True, made=MADE)
    assert {path.name: path.read_bytes() for path in tmp_path.iterdir()} == before

    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(writer, "write_table", full)
    with pytest.raises(StorageError, match="E-DISK-01"):
        write_report(made(words="another"), tmp_path, force=True, made=MADE)
    assert {path.name: path.read_bytes() for path in tmp_path.iterdir()} == before


def test_the_archive_gets_page_and_surface_in_the_frame_of_before(tmp_path: Path) -> None:
    page_file, folder = tmp_path / "report.pdf", tmp_path / "archive"
    page_file.write_bytes(b"%PDF-1.4 page")
    folder.mkdir()
    comparison = made()
    assert [path.name for path in write_dicom(comparison, page_file, folder, made=MADE)] == ["report.dcm", "after.dcm"]
    assert len(list(folder.iterdir())) == 2
    page, surface = (dcmread(folder / name) for name in ("report.dcm", "after.dcm"))
    assert page.EncapsulatedDocument[: page.EncapsulatedDocumentLength] == page_file.read_bytes()
    mesh = parse_stl(surface.EncapsulatedDocument[: surface.EncapsulatedDocumentLength])
    after = comparison.after.mesh
    assert np.allclose(mesh.vertices[mesh.triangles], POSE.apply(after.vertices)[after.triangles], atol=1e-4)
    assert page.PatientID == surface.PatientID == "2026-0417"
    assert page.StudyInstanceUID == surface.StudyInstanceUID
    exported = DicomSubject.of("P-1", "2026-0417", "", MADE)  # as the case's own mesh
    write_encapsulated_stl(tmp_path / "mesh.dcm", after, exported, "Surface")
    of_case = replace(comparison, after=replace(comparison.after, origin={**comparison.after.origin, "patient_code": "P-1"}))
    write_dicom(of_case, page_file, folder, made=MADE, force=True)
    mesh_file, page = dcmread(tmp_path / "mesh.dcm"), dcmread(folder / "report.dcm")
    assert (page.PatientID, page.StudyInstanceUID) == (mesh_file.PatientID, mesh_file.StudyInstanceUID) == ("P-1", mesh_file.StudyInstanceUID)
    with pytest.raises(StorageError, match="E-DISK-03"):
        write_dicom(comparison, page_file, folder, made=MADE)


@pytest.mark.parametrize("after", [0, 1, 5])
def test_a_cancelled_report_leaves_nothing(after: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(plates, "_PER_MM", 1.0)
    monkeypatch.setattr(html, "_WIDTH", 90)
    asked: list[int] = []

    def cancelled() -> bool:
        asked.append(0)
        return len(asked) > after

    with pytest.raises(Cancelled):
        write_report(made(), tmp_path, made=MADE, cancelled=cancelled)
    assert list(tmp_path.iterdir()) == []
    assert len(asked) == after + 1


def test_a_report_cancelled_after_its_first_file_leaves_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(writer, "write_pdf", lambda comparison, path, made, cancelled: path.write_text(made))  # letters on paper take seconds
    monkeypatch.setattr(html, "_WIDTH", 90)
    answers = iter([False, False, False, True])  # before both files and in the second picture of the page for the browser
    with pytest.raises(Cancelled):
        write_report(made(), tmp_path, made=MADE, cancelled=lambda: next(answers))
    assert list(tmp_path.iterdir()) == []
    assert next(answers, None) is None
