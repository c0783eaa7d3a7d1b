"""``impronta reconstruct CASE`` keeps its choice and its mesh only once the file that was asked for is there."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import pytest

from scanner_core.__main__ import main
from scanner_core.case.processing import Processing, chosen_processing
from scanner_core.case.store import CaseStore
from scanner_core.commands import reconstruct
from scanner_core.errors import StorageError
from tests.core.case.lives import mesh
from tests.core.case.test_processing import small_case


@pytest.mark.parametrize("fault", ["rounding", "disk", None])
def test_what_cannot_be_delivered_changes_no_case(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, fault: str | None) -> None:
    path, out = tmp_path / "a.impronta", tmp_path / "a.stl"
    path.write_bytes(small_case())
    surface = mesh(20)
    if fault == "rounding":
        surface = replace(surface, vertices=surface.vertices + 1e9)
    report = SimpleNamespace(as_dict=dict, warnings=())
    monkeypatch.setattr(reconstruct, "run_reconstruction", lambda *_: SimpleNamespace(mesh=surface, report=report))
    monkeypatch.setattr(reconstruct, "reconstruction_summary", lambda _: [])

    def full(place: Path, *_: object, **__: object) -> None:
        raise StorageError("E-DISK-01", path=place)

    if fault == "disk":
        monkeypatch.setattr(reconstruct, "write_mesh", full)
    assert main(["reconstruct", str(path), "--out", str(out), "--without-view", "1"]) == (1 if fault else 0)
    assert out.exists() is (fault is None)
    with CaseStore.open(path, read_only=True) as store:
        assert chosen_processing(store) == (Processing() if fault else Processing(without_views=(1,)))
        assert (store.mesh_count(), store.undoable is None) == ((0, True) if fault else (1, False))
