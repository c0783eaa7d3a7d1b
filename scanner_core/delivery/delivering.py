"""Writes a delivery: mesh, points, certificate and its JSON; all of them, or none."""

from __future__ import annotations

import json
import os
import secrets
import shutil
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path

from scanner_core.case.glance import DELIVERY
from scanner_core.case.store import CaseStore
from scanner_core.delivery.base import without_base
from scanner_core.delivery.certificate import Certificate, DeliveredFile
from scanner_core.delivery.certificate_page import write_page
from scanner_core.delivery.check import CheckVerdict, Readiness
from scanner_core.delivery.examining import Examination
from scanner_core.delivery.pose import lay
from scanner_core.delivery.profile import Profile
from scanner_core.errors import DeliveryError
from scanner_core.files import check_free, replaced_when_whole, storage_error
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.jobs.progress import Cancelled, IsCancelled, OnProgress, Progress
from scanner_core.mesh_io import write_mesh, write_points
from scanner_core.mesh_io.stated_unit import MM


@dataclass(frozen=True, slots=True)
class Delivery:
    """What was delivered.

    Attributes
    ----------
    time : ISO 8601
    folder : where the files are
    files : their names, the mesh first
    sha256 : of the mesh's file
    verdict : ready, ready with remarks, not ready
    anyway : a person delivered it although it was not ready
    profile : its name
    mesh_id : of the surface, in the case
    """

    time: str
    folder: str
    files: tuple[str, ...]
    sha256: str
    verdict: str
    anyway: bool
    profile: str
    mesh_id: int

    def as_dict(self) -> dict[str, object]:
        """For the case and JSON."""
        return {
            "time": self.time,
            "folder": self.folder,
            "files": list(self.files),
            "sha256": self.sha256,
            "verdict": self.verdict,
            "anyway": self.anyway,
            "profile": self.profile,
            "mesh_id": self.mesh_id,
        }


def keep_delivery(store: CaseStore, delivery: Delivery) -> None:
    """Let the case remember it, an edit that can be undone; the files stay."""
    store.edit(DELIVERY, delivery.as_dict(), "Delivered")


def deliver(
    examination: Examination,
    profile: Profile,
    folder: Path,
    stem: str,
    *,
    made: str,
    cloud: PointCloud | None = None,
    replace: bool = False,
    anyway: bool = False,
    progress: OnProgress = lambda _: None,
    cancelled: IsCancelled = lambda: False,
) -> Delivery:
    """Write the files of a profile into a folder, which is made when it is not there.

    Parameters
    ----------
    stem : of the files' names
    made : the time that the certificate tells
    cloud : registered points in the frame of the surface, mm; for a profile that asks for them, and written in its unit
    replace : files of these names may be replaced
    anyway : also when it is not ready; the certificate says so

    Raises
    ------
    DeliveryError
        E-DLV-01 when it is not ready and not `anyway`.
    StorageError
        E-DISK-01 no space, E-DISK-02 not allowed, E-DISK-03 a file exists; the folder is then as it was.
    Cancelled
        Before a file; the folder is then as it was.
    """
    ready = examination.verdict is not Readiness.NOT_READY
    if not ready and not anyway:
        failed = ", ".join(check.name for check in examination.of(CheckVerdict.FAIL))
        raise DeliveryError("E-DLV-01", checks=failed)
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as fault:
        raise storage_error(folder, fault) from fault
    suffixes = [suffix for suffix in profile.suffixes if suffix != ".xyz" or cloud is not None]
    names = {suffix: stem + suffix for suffix in suffixes}
    for name in names.values():
        check_free(folder / name, replace)
    mesh, certificate = _prepared(examination, profile, made, anyway=not ready)
    marks = examination.facts.marks
    with all_or_none(folder, list(names.values()), replace) as beside:
        for number, suffix in enumerate(suffixes):
            if cancelled():
                raise Cancelled
            progress(Progress("writing", number / len(suffixes)))
            path = beside[names[suffix]]
            if suffix == profile.format:
                write_mesh(path, mesh, force=True, remark="" if marks is None else marks.brief(), unit=profile.unit)
                certificate = _with(certificate, DeliveredFile.of(path, names[suffix], "mesh"))
            elif suffix == ".xyz" and cloud is not None:
                write_points(path, PointCloud(certificate.laid.transform.apply(cloud.points) / MM[profile.unit]), force=True)
                certificate = _with(certificate, DeliveredFile.of(path, names[suffix], "points"))
            elif suffix == ".pdf":
                write_page(certificate, path)
        if profile.certificate:
            told = _with(certificate, DeliveredFile.of(beside[names[".pdf"]], names[".pdf"], "certificate")).as_dict()
            beside[names[".json"]].write_text(json.dumps(told, indent=1, ensure_ascii=False, allow_nan=False) + "\n", encoding="utf-8")
    return Delivery(
        time=made,
        folder=str(folder),
        files=tuple(names.values()),
        sha256=certificate.mesh_file.sha256,
        verdict=examination.verdict.value,
        anyway=not ready,
        profile=profile.name,
        mesh_id=examination.facts.mesh_id,
    )


@contextmanager
def all_or_none(folder: Path, names: list[str], replace: bool) -> Iterator[dict[str, Path]]:
    """Files to write beside their places, by their names; they appear when all are whole.

    When one of them cannot be put into its place (a page that another program has open, say), those that were put there before it
    are taken away again, and what they had replaced is brought back.
    """
    beside: dict[str, Path] = {}
    waiting: list[tuple[Path, bool, ExitStack]] = []
    put: list[tuple[Path, Path | None]] = []
    with ExitStack() as unfinished:  # what is still in it at an error goes
        for name in names:
            own = unfinished.enter_context(ExitStack())
            waiting.append((folder / name, (folder / name).exists(), own))
            beside[name] = own.enter_context(replaced_when_whole(folder / name, replace))
        yield beside
        try:
            for place, was_there, own in waiting:
                before = _kept(place, unfinished) if was_there else None
                own.close()
                put.append((place, before))
        except BaseException:
            for place, before in put:
                with suppress(OSError):
                    place.unlink(missing_ok=True) if before is None else os.replace(before, os.path.realpath(place))
            raise


def _kept(place: Path, until: ExitStack) -> Path:
    """A copy beside a file that is to be replaced; it goes with `until`."""
    place = Path(os.path.realpath(place))
    copy = place.with_name(f".{place.stem[:100]}.{secrets.token_hex(4)}.before{place.suffix}")
    until.callback(copy.unlink, missing_ok=True)
    try:
        shutil.copy2(place, copy)
    except OSError as fault:
        raise storage_error(place, fault) from fault
    return copy


def _prepared(examination: Examination, profile: Profile, made: str, *, anyway: bool) -> tuple[TriangleMesh, Certificate]:
    """The mesh as it goes into the file, and its certificate without files."""
    measured = examination.facts.mesh
    laid = lay(measured, profile.pose)
    opened = without_base(measured) if profile.open_base else measured
    mesh = TriangleMesh(laid.transform.apply(opened.vertices), opened.triangles, opened.vertex_attributes)
    return mesh, Certificate(examination, profile, mesh, laid, made, anyway, ())


def _with(certificate: Certificate, file: DeliveredFile) -> Certificate:
    c = certificate
    return Certificate(c.examination, c.profile, c.mesh, c.laid, c.made, c.anyway, (*c.files, file))
