"""One harness for each reader: bytes in; a value, or a refusal on purpose.  Anything else that comes out is a finding."""

from __future__ import annotations

import io
import sqlite3
import tempfile
import zipfile
import zlib
from collections.abc import Callable
from contextlib import closing, suppress
from functools import cache, partial
from pathlib import Path

import numpy as np

from scanner_core.acquisition.plan import read_plan
from scanner_core.case.processing import case_cloud
from scanner_core.case.store import SUFFIX, CaseStore
from scanner_core.devices.grbl.line_buffer import LONGEST_LINE, LineBuffer
from scanner_core.devices.grbl.lines import Report, Setting, parse_line
from scanner_core.devices.rig import dump_rig, load_rig, parse_rig
from scanner_core.errors import ImprontaError
from scanner_core.mesh_io.malformed import MalformedError
from scanner_core.mesh_io.reader import MESH_PARSERS, POINT_PARSERS
from scanner_core.mesh_io.threemf import RELATIONS
from scanner_core.metrology.history import parse_history

Reader = Callable[[bytes], None]

REFUSALS = (ImprontaError, MalformedError)
"""What a reader may raise."""

_PLACE = tempfile.TemporaryDirectory(prefix="impronta-fuzz-", dir="/dev/shm" if Path("/dev/shm").is_dir() else None)
"""For readers that take a path; in memory where the system has such a folder."""


def _mesh(suffix: str) -> Reader:
    def read(content: bytes) -> None:
        mesh = MESH_PARSERS[suffix](content)
        assert np.isfinite(mesh.vertices).all()
        assert len(mesh.triangles) == 0 or 0 <= mesh.triangles.min() <= mesh.triangles.max() < len(mesh.vertices)
        assert all(len(column) == len(mesh.vertices) for column in mesh.vertex_attributes.values())

    return read


def _model_part(content: bytes) -> None:
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w") as package:
        package.writestr("_rels/.rels", RELATIONS)
        package.writestr("3D/3dmodel.model", content)
    _mesh(".3mf")(file.getvalue())


def _points(suffix: str) -> Reader:
    def read(content: bytes) -> None:
        cloud = POINT_PARSERS[suffix](content)
        assert cloud.points.shape[1:] == (3,)
        assert np.isfinite(cloud.points).all()

    return read


def _written(content: bytes, name: str) -> Path:
    path = Path(_PLACE.name) / name
    path.write_bytes(content)
    return path


def _rig(content: bytes) -> None:
    rig = load_rig(_written(content, "rig.toml"))
    assert dump_rig(parse_rig(dump_rig(rig), "again")) == dump_rig(rig)


def _plan(content: bytes) -> None:
    read_plan(_written(content, "plan.toml"))


def _history(content: bytes) -> None:
    for entry in parse_history(content.splitlines()):
        assert entry.date.isprintable()


def _serial(content: bytes) -> None:
    """The first byte cuts the rest into portions."""
    lines = LineBuffer()
    size = 1 + (content[0] if content else 0)
    for begin in range(1, len(content), size):
        for text in lines.feed(content[begin : begin + size]):
            said = parse_line(text)
            if isinstance(said, Setting):
                assert np.isfinite(said.value)
            if isinstance(said, Report) and said.position is not None:
                assert np.isfinite(said.position).all()
        assert len(lines.unfinished) <= LONGEST_LINE


def _case(content: bytes) -> None:
    path = _written(content, f"a{SUFFIX}")
    try:
        with CaseStore.open(path) as store:
            read_everything(store)
    finally:
        for leftover in path.parent.glob("a.*"):
            leftover.unlink()


def _case_values(content: bytes) -> None:
    """A sound database with hostile values: the input says which cells get which."""
    read_only = len(content) % 4 != 0  # most, because it takes half the time; undo and redo need to write
    connection = sqlite3.connect(":memory:", isolation_level=None)
    try:
        connection.deserialize(_template())
        columns = _columns()
        while len(content) >= 4:
            where, which, kind, length, content = content[0], content[1], content[2], content[3], content[4:]
            table, column = columns[where % len(columns)]
            value, content = _value(kind, content[:length]), content[length:]
            place = f"rowid IN (SELECT rowid FROM {table} LIMIT 1 OFFSET {which % 4})" if table in _WITH_ROWID else "1"
            with suppress(sqlite3.Error):
                connection.execute(f"UPDATE OR IGNORE {table} SET {column} = ? WHERE {place}", (value,))
        path = _written(connection.serialize(), f"b{SUFFIX}")
    finally:
        connection.close()
    try:
        with CaseStore.open(path, read_only=read_only) as store:
            read_everything(store)
    finally:
        for leftover in path.parent.glob("b.*"):
            leftover.unlink()


_WITH_ROWID = ("order_entry", "scan", "verdict", "observation", "mesh", "audit", "edit", "registration", "mask", "comparison")


@cache
def _template() -> bytes:
    from tests.fuzz.corpus import samples

    return samples("case")[1]  # the one of small pages


@cache
def _columns() -> list[tuple[str, str]]:
    with closing(sqlite3.connect(":memory:")) as connection:
        connection.deserialize(_template())
        tables = [name for (name,) in connection.execute("SELECT name FROM sqlite_schema WHERE type = 'table' ORDER BY name")]
        return [(table, row[1]) for table in tables for row in connection.execute(f"PRAGMA table_info({table})")]


def _value(kind: int, content: bytes) -> object:
    """A cell's new value: one of :func:`_hostile_values`, or one made of the input."""
    known = _hostile_values()
    kind %= len(known) + 4
    if kind < len(known):
        return known[kind]
    made = (content, content.decode("latin-1"), zlib.compress(content, 1), int.from_bytes(content[:8], "little", signed=True))
    return made[kind - len(known)]


@cache
def _hostile_values() -> tuple[object, ...]:
    """Numbers at limits, texts, blobs, JSON that is deep or large, arrays that are bombs, nothing."""
    return (
        *(None, -1, 0, 2, 2**31, 2**63 - 1, -(2**63), 0.5, 1e308, float("inf"), float("-inf")),
        *("", "measured", b"", b"\xff\xfe", "\x1b[31m\n", "null", "x" * 100_000),
        *("[]", "{}", "[" * 2000, "NaN", "1e999", "9" * 5000, "[[1,0],[0,1]]", '[["a", "O8"]]', '[["a", "<f8"], ["b", "<i4"]]'),
        *('{"views": []}', '{"views": [{"rows": [{"first_id": 9e99, "count": 1}]}]}'),
        *(zlib.compress(bytes(50_000_000), 9), zlib.compress(b"\xff" * 24)),
    )


def read_everything(store: CaseStore, told: Callable[[ImprontaError], None] | None = None) -> None:
    """All that the program ever reads out of a case; parts that are refused do not keep the others from being read.

    `told` is called with every refusal; at the end the last one is raised.
    """
    refused: ImprontaError | None = None
    steps: list[Callable[[], object]] = [store.order, store.next_trigger_id, store.mesh, store.mesh_count, lambda: case_cloud(store)]
    steps += [store.audit_trail, store.mask_names, lambda: store.mask("stable"), store.comparisons, lambda: store.deviation_um(1)]
    steps += [partial(store.value, key) for key in ("order", "processing", "mesh", "discarded_scans")]
    try:
        for scan in store.scans():
            reads = (store.rig_toml, store.observations, store.exposed_ids, store.verdict_counts, store.corrections, store.registrations)
            steps += [partial(read, scan.id) for read in reads]
    except ImprontaError as error:
        refused = error
        if told is not None:
            told(error)
    steps += [lambda: (store.undoable, store.redoable)]
    if not store.read_only:
        steps += [store.undo, store.redo]
    for step in steps:
        try:
            step()
        except ImprontaError as error:
            refused = error
            if told is not None:
                told(error)
    if refused is not None:
        raise refused


READERS: dict[str, Reader] = {
    **{suffix[1:]: _mesh(suffix) for suffix in MESH_PARSERS},
    "3mf-model": _model_part,
    "ply-points": _points(".ply"),
    "text": _points(".xyz"),
    "npy": _points(".npy"),
    "rig": _rig,
    "plan": _plan,
    "case": _case,
    "case-values": _case_values,
    "history": _history,
    "serial": _serial,
}
"""XYZ, TXT, CSV and ASC share one reader, ``text``; ``3mf-model`` damages the XML within a sound package."""
