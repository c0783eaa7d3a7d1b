"""Undo and redo against a list and an index, over closing and opening again."""

from __future__ import annotations

import tempfile
from dataclasses import asdict
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, initialize, invariant, precondition, rule

from scanner_core.case.store import CaseStore, Order
from scanner_core.errors import CaseError
from tests.core.case.lives import mesh
from tests.core.case.old_case import MESHES, write_old_case

ABSENT = object()
IN_MEMORY = Path("/dev/shm")

values = st.one_of(st.none(), st.booleans(), st.integers(-(10**12), 10**12), st.text(max_size=3), st.lists(st.integers(0, 9), max_size=3))


class UndoMachine(RuleBasedStateMachine):
    """The model: `now` by key, and a list of (key, before, after, words) of which the first `done` stand."""

    def __init__(self) -> None:
        super().__init__()
        self.folder = tempfile.TemporaryDirectory(dir=IN_MEMORY if IN_MEMORY.is_dir() else None)
        self.path = Path(self.folder.name) / "a.impronta"
        self.now: dict[str, Any] = {}
        self.edits: list[tuple[str, Any, Any, str]] = []
        self.done = 0
        self.meshes: list[int] = []
        self.lines = 1

    @initialize(old=st.booleans())
    def begin(self, old: bool) -> None:
        if old:
            write_old_case(self.path)
            self.store = CaseStore.open(self.path)
            self.now["order"] = asdict(self.store.order())
            self.meshes = list(MESHES)
            self.lines += 1  # migrated
        else:
            self.store = CaseStore.create(self.path)

    def change(self, key: str, before: Any, after: Any, words: str) -> None:
        if before is not ABSENT and (type(before), before) == (type(after), after):
            return
        self.edits[self.done :] = [(key, before, after, words)]
        self.done += 1
        self.now[key] = after
        self.lines += 1

    @rule(key=st.sampled_from(["processing", "discarded_scans"]), value=values, words=st.text(max_size=5))
    def edit(self, key: str, value: object, words: str) -> None:
        lines = self.lines
        self.change(key, self.now.get(key, ABSENT), value, words)
        assert (self.store.edit(key, value, words) is None) == (lines == self.lines)

    @rule(number=st.sampled_from("123"))
    def put_order(self, number: str) -> None:
        order = Order(number, "P-1", "left", "ear", "")
        self.store.put_order(order)
        if "order" in self.now:
            self.change("order", self.now["order"], asdict(order), "Order changed")
        else:
            self.now["order"] = asdict(order)

    @rule()
    def put_mesh(self) -> None:
        shown = self.shown()
        self.meshes.append(3 + len(self.meshes))
        number = self.store.put_mesh(mesh(self.meshes[-1]), {})
        assert number == len(self.meshes)
        self.change("mesh", shown, number, "Surface reconstructed")

    @precondition(lambda self: self.meshes)
    @rule(data=st.data())
    def choose_mesh(self, data: st.DataObject) -> None:
        number = data.draw(st.one_of(st.none(), st.integers(1, len(self.meshes))))
        self.change("mesh", self.now.get("mesh", ABSENT), number, "Mesh chosen")
        self.store.edit("mesh", number, "Mesh chosen")

    @rule()
    def undo(self) -> None:
        edit = self.store.undo()
        if not self.done:
            assert edit is None
            return
        self.done -= 1
        key, before, _, words = self.edits[self.done]
        self.arrive(key, before)
        assert edit is not None
        assert (edit.key, edit.words, edit.value) == (key, words, None if before is ABSENT else before)

    @rule()
    def redo(self) -> None:
        edit = self.store.redo()
        if self.done == len(self.edits):
            assert edit is None
            return
        key, _, after, words = self.edits[self.done]
        self.done += 1
        self.arrive(key, after)
        assert edit is not None
        assert (edit.key, edit.words, edit.value) == (key, words, after)

    def arrive(self, key: str, value: Any) -> None:
        self.lines += 1
        if value is ABSENT:
            del self.now[key]
        else:
            self.now[key] = value

    @rule()
    def reopen(self) -> None:
        self.store.close()
        self.store = CaseStore.open(self.path)

    def shown(self) -> int:
        """The mesh that the case has to show, 0 for none."""
        chosen = self.now.get("mesh")
        return len(self.meshes) if chosen is None else int(chosen)

    @invariant()
    def it_is_as_the_model_says(self) -> None:
        if not hasattr(self, "store"):
            return
        for key in ("order", "processing", "discarded_scans", "mesh"):
            assert self.store.value(key, "absent") == self.now.get(key, "absent")
        assert asdict(self.store.order()) == self.now.get("order", asdict(Order()))
        assert self.store.undoable == (self.edits[self.done - 1][3] if self.done else None)
        assert self.store.redoable == (self.edits[self.done][3] if self.done < len(self.edits) else None)
        assert len(self.store.audit_trail()) == self.lines
        assert self.store.mesh_count() == len(self.meshes)
        if self.shown():
            assert len(self.store.mesh()[0].vertices) == self.meshes[self.shown() - 1]
        else:
            with pytest.raises(CaseError, match="E-CASE-05"):
                self.store.mesh()

    def teardown(self) -> None:
        if hasattr(self, "store"):
            self.store.close()
        self.folder.cleanup()


TestUndo = UndoMachine.TestCase
TestUndo.settings = settings(max_examples=20, stateful_step_count=25, deadline=None, suppress_health_check=[HealthCheck.too_slow])


def test_what_a_person_did_is_undone_after_closing(tmp_path: Path) -> None:
    with CaseStore.create(tmp_path / "a.impronta") as store:
        store.put_order(Order("1"))
        store.put_order(Order("2"))
        store.put_mesh(mesh(5), {})
        store.put_mesh(mesh(6), {})
    with CaseStore.open(tmp_path / "a.impronta") as store:
        assert store.undoable == "Surface reconstructed"
        store.undo()
        assert len(store.mesh()[0].vertices) == 5
        store.undo()
        assert store.mesh_id() is None
        store.undo()
        assert store.order() == Order("1")
        assert store.undo() is None
        assert store.redoable == "Order changed"
    with CaseStore.open(tmp_path / "a.impronta") as store:
        store.redo()
        assert store.order() == Order("2")
        store.edit("discarded_scans", [3], "Scan discarded")
        assert store.redoable is None
        assert store.mesh_count() == 2  # nothing is deleted
        assert [line.event for line in store.audit_trail()] == ["created", *["edited"] * 3, *["undone"] * 3, "redone", "edited"]
