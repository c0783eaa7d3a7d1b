"""One harness for each reader: bytes in; a value, or a refusal on purpose.  Anything else that comes out is a finding."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from pathlib import Path

import numpy as np

from scanner_core.acquisition.plan import read_plan
from scanner_core.case.points import case_cloud
from scanner_core.case.store import SUFFIX, CaseStore
from scanner_core.devices.grbl.line_buffer import LONGEST_LINE, LineBuffer
from scanner_core.devices.grbl.lines import Report, Setting, parse_line
from scanner_core.devices.rig import dump_rig, load_rig, parse_rig
from scanner_core.errors import ImprontaError
from scanner_core.mesh_io.malformed import MalformedError
from scanner_core.mesh_io.reader import MESH_PARSERS, POINT_PARSERS
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


def read_everything(store: CaseStore) -> None:
    """All that the program ever reads out of a case; parts that are refused do not keep the others from being read."""
    refused: ImprontaError | None = None
    steps: list[Callable[[], object]] = [store.order, store.next_trigger_id, store.mesh, store.mesh_count, lambda: case_cloud(store)]
    try:
        for scan in store.scans():
            steps += [
                lambda scan=scan: store.observations(scan.id),  # type: ignore[misc]
                lambda scan=scan: store.verdict_counts(scan.id),  # type: ignore[misc]
                lambda scan=scan: store.corrections(scan.id),  # type: ignore[misc]
            ]
    except ImprontaError as error:
        refused = error
    for step in steps:
        try:
            step()
        except ImprontaError as error:
            refused = error
    if refused is not None:
        raise refused


READERS: dict[str, Reader] = {
    **{suffix[1:]: _mesh(suffix) for suffix in MESH_PARSERS},
    "ply-points": _points(".ply"),
    "text": _points(".xyz"),
    "npy": _points(".npy"),
    "rig": _rig,
    "plan": _plan,
    "case": _case,
    "history": _history,
    "serial": _serial,
}
"""XYZ, TXT, CSV and ASC share one reader, ``text``.  3MF is written only."""
