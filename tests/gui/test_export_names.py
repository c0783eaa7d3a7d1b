from __future__ import annotations

from dataclasses import replace
from datetime import date
from pathlib import Path

import pytest

from app.controllers.case_files import CaseName, free_case_path, free_number, read_case_name
from app.draft import DraftValues, orders_of
from app.file_names import file_name, free_name, names_the_patient, safe_stem, unknown_fields

VALUES = DraftValues(order="2026-0142", patient_code="P-0142", side="right", kind="ear")
DAY = date(2026, 11, 23)
TEMPLATE = "{order}_{side}_{type}_{date}-{rev}"


def test_the_template_is_filled_in() -> None:
    assert file_name(TEMPLATE, VALUES, 1, ".stl", DAY) == "2026-0142_right_ear_2026-11-23-1.stl"


@pytest.mark.parametrize("order", ["a/b", "..", "C:\\x", "ä ö", "", "x" * 400])
def test_whatever_the_order_is_called_the_name_is_one_file_in_the_folder(order: str, tmp_path: Path) -> None:
    path = free_name(tmp_path, TEMPLATE, DraftValues(order=order), ".stl", DAY)
    assert path.parent == tmp_path
    path.write_text("")


def test_a_revision_that_is_taken_is_never_given_again(tmp_path: Path) -> None:
    for revision in (1, 2, 3):
        path = free_name(tmp_path, TEMPLATE, VALUES, ".stl", DAY)
        assert path.name.endswith(f"-{revision}.stl")
        path.write_text("")
    assert free_name(tmp_path, "fixed", VALUES, ".stl", DAY).name == "fixed.stl"


def test_a_new_case_never_takes_the_name_of_another(tmp_path: Path) -> None:
    first = free_case_path(tmp_path, VALUES, DAY)
    first.write_text("")
    assert free_case_path(tmp_path, VALUES, DAY).name == "2026-0142_right_ear_2026-11-23-2.impronta"
    (tmp_path / "2026-0142_right_ear_2026-11-23-2.impronta-wal").write_bytes(b"of a case that was moved away")
    assert free_case_path(tmp_path, VALUES, DAY).name == "2026-0142_right_ear_2026-11-23-3.impronta"


def test_an_order_without_a_side_has_none_in_its_names() -> None:
    values = replace(VALUES, side="")
    assert file_name(TEMPLATE, values, 1, ".stl", DAY) == "2026-0142_ear_2026-11-23-1.stl"
    name = read_case_name(free_case_path(Path("/nowhere"), values, DAY).stem)
    assert name == CaseName("2026-0142", "", "ear")


def test_unknown_braces_do_no_harm() -> None:
    assert file_name("{order}{what}", VALUES, 1, ".ply", DAY) == "2026-0142-what.ply"
    assert safe_stem("...") == "case"


def test_the_patient_stays_out_of_names_unless_that_is_wanted() -> None:
    template = "{code}_{order}_{code}_{side}-{rev}_{code}"
    assert names_the_patient(template)
    assert not names_the_patient(TEMPLATE)
    assert file_name(template, VALUES, 1, ".stl", DAY) == "2026-0142_right-1.stl"
    assert file_name(template, VALUES, 1, ".stl", DAY, with_code=True) == "P-0142_2026-0142_P-0142_right-1_P-0142.stl"


def test_unknown_fields_are_named() -> None:
    assert unknown_fields("{order}_{name}_{}_{rev}_{name}") == ["name", ""]
    assert unknown_fields(TEMPLATE) == []


def test_a_pair_has_two_files_with_one_number() -> None:
    names = [file_name(TEMPLATE, order, 1, ".stl", DAY) for order in orders_of(replace(VALUES, side="both"))]
    assert names == ["2026-0142_left_ear_2026-11-23-1.stl", "2026-0142_right_ear_2026-11-23-1.stl"]
    jaws = orders_of(replace(VALUES, side="both", kind="arch-before"))
    assert [read_case_name(free_case_path(Path("/nowhere"), jaw, DAY).stem) for jaw in jaws] == [
        CaseName("2026-0142", "upper", "arch-before"),
        CaseName("2026-0142", "lower", "arch-before"),
    ]
    assert orders_of(VALUES) == (VALUES,)


def test_numbers_are_counted_on_until_one_is_free() -> None:
    assert free_number("A-098", ["A-098", "A-099"]) == "A-100"
    assert free_number("A-098", []) == "A-098"
    assert free_number("wax", ["wax"]) == "wax"
