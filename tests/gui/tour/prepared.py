"""What the scenes begin with: cases that were scanned once, by the command line, and the orders of a day."""

from __future__ import annotations

import shutil
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from scanner_core import wall_clock
from scanner_core.case.glance import DELIVERY
from scanner_core.case.store import CaseStore, Order
from scanner_core.devices.rig import load_preset
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.mesh_io import read_mesh, write_mesh
from scanner_core.metrology.history import HistoryEntry, append_history, history_path
from scanner_core.virtual.specimens import load_specimen

POINTS = 8000
_POSE = "--pose=0,75,0"
EAR = "2026-0142_left_ear.impronta"
SCANNED = "2026-0144_right_ear.impronta"
PAIR = ("2026-0147_left_ear.impronta", "2026-0147_right_ear.impronta")


class Prepared:
    """The folder is kept: a second run finds there what the first one made."""

    def __init__(self, folder: Path) -> None:
        folder.mkdir(parents=True, exist_ok=True)
        self._folder = folder
        self.ear, self.mounts, self.scanned, self.interrupted = (folder / f"{name}.impronta" for name in ("ear", "mounts", "scanned", "interrupted"))
        if not self.ear.exists():
            self._impronta("demo", "--specimen", "ear", "--points", str(POINTS), "--seed", "1", "--out", str(folder / "demo"), "--force")
            shutil.copy(folder / "demo" / "case.impronta", self.ear)
        plan = folder / "plan.toml"
        plan.write_text("views = 12\npoints = 3000\nobject_radius_mm = 13.0\nobject_height_mm = 24.0\n", encoding="utf-8")
        scan = ("scan", "--rig", "bench", "--plan", str(plan), "--specimen", "ear", "--seed", "2")
        if not self.scanned.exists():
            self._impronta(*scan, "--out", str(self.scanned))
        if not self.mounts.exists():
            shutil.copy(self.scanned, self.mounts)
            self._impronta(*scan, "--add-mount", _POSE, "--out", str(self.mounts))
        if not self.interrupted.exists():
            self._impronta(*scan, "--fault", "lid_opened@75", "--out", str(self.interrupted))

    def _impronta(self, *words: str) -> None:
        """What fails shows itself by its missing file."""
        subprocess.run([sys.executable, "-m", "scanner_core", *words], check=False, stdout=subprocess.DEVNULL)

    def measure_spheres(self) -> None:
        """The shipped rig's last tests with the reference sphere, into its history."""
        calibration = load_preset("bench").calibration
        assert calibration is not None
        for days, size_um, d95_um in ((22, 1.9, 49.0), (17, 2.4, 52.0), (12, 1.7, 48.0), (8, 2.2, 51.0), (4, 2.6, 50.0), (1, 2.1, 49.0)):
            with _ago(24.0 * days):
                at = wall_clock.stamp()
            figures, uncertainties = {"size": size_um, "dispersion": d95_um}, {"size": 3.2}
            entry = HistoryEntry(at, "sphere", figures, uncertainties, {}, "", calibration.identity(), at, "", 1)
            append_history(history_path("bench"), entry)

    def lay_out(self, cases: Path) -> None:
        """The orders of some days, in every state but interrupted."""
        cases.mkdir(parents=True, exist_ok=True)
        arch, ear, treated = self._mesh("arch"), self._mesh("ear"), self._mesh("arch-after")
        mirrored = TriangleMesh(ear.vertices * (-1.0, 1.0, 1.0), ear.triangles[:, ::-1])
        for hours, order, mesh in (
            (75.0, Order("2026-0138", "", "right", "ear"), mirrored),
            (51.0, Order("2026-0139", "", "upper", "arch-after"), treated),
            (27.0, Order("2026-0140", "", "left", "ear"), ear),
            (26.0, Order("2026-0141", "", "lower", "arch"), arch),
        ):
            with _ago(hours), _order(cases, order) as store:
                store.put_mesh(mesh, {})
                store.edit(DELIVERY, {"files": [f"{order.number}.stl"]}, "Delivered")
        with _ago(4.0):
            self._copy(self.ear, cases / EAR, Order("2026-0142", "", "left", "ear"))
        with _ago(3.2), _order(cases, Order("2026-0143", "", "upper", "arch-before")) as store:
            store.put_mesh(arch, {})
        with _ago(1.6):
            self._copy(self.scanned, cases / SCANNED, Order("2026-0144", "", "right", "ear"))
        with _ago(0.6), _order(cases, Order("2026-0146", "", "lower", "arch-after")):
            pass
        for minutes, name, side in ((14, PAIR[0], "left"), (13, PAIR[1], "right")):
            with _ago(minutes / 60), CaseStore.create(cases / name) as store:
                store.put_order(Order("2026-0147", "", side, "ear"))

    def _mesh(self, name: str) -> TriangleMesh:
        path = self._folder / f"{name}.ply"
        if not path.exists():
            specimen, _, after = name.partition("-")
            write_mesh(path, load_specimen(specimen, treated=bool(after)).mesh)
        return read_mesh(path)

    def interrupt(self, cases: Path) -> Path:
        """One more order, whose scan did not come to its end."""
        path = cases / "2026-0145_left_ear.impronta"
        self._copy(self.interrupted, path, Order("2026-0145", "", "left", "ear"))
        return path

    def _copy(self, made: Path, path: Path, order: Order) -> None:
        shutil.copy(made, path)
        with CaseStore.open(path) as store:
            store.put_order(order)

    def arches(self, folder: Path) -> tuple[Path, Path]:
        """Two files of a dental model, before and after."""
        from tests.gui.compare_pair import write_pair

        made = self._folder / "arches"
        if not (made / "after.stl").exists():
            made.mkdir(exist_ok=True)
            write_pair(made, spacing=0.42)
        files = folder / "2026-0132_lower_before.stl", folder / "2026-0132_lower_after.stl"
        for source, path in zip(("before.stl", "after.stl"), files, strict=True):
            shutil.copy(made / source, path)
        return files


@contextmanager
def _ago(hours: float) -> Iterator[None]:
    wall_clock.jump(-3600 * hours)
    try:
        yield
    finally:
        wall_clock.jump(0.0)


def _order(cases: Path, order: Order) -> CaseStore:
    store = CaseStore.create(cases / f"{order.number}_{order.side}_{order.type}.impronta")
    store.put_order(order)
    return store
