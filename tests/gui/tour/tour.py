"""A tour through the window: named scenes, each brought about by a function and taken in the dark and in the light theme.

A function that brings the program somewhere is a generator: it yields the name of every scene when the window shows it,
and tidies up after the last one.  It begins at Home with no case open and the shipped bench, and may need to leave only that.
"""

from __future__ import annotations

import shutil
import sys
import time
import traceback
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

import numpy as np
from numpy.typing import NDArray
from PIL import Image
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QDialog

from scanner_core.case.store import CaseStore, Order
from tests.gui.tour.prepared import EAR
from tests.gui.waiting import until, wait_ms

if TYPE_CHECKING:
    from app.program import Program
    from app.views.page import Page
    from tests.gui.tour.prepared import Prepared

Bring = Callable[["Tour"], Iterator[str]]
P = TypeVar("P", bound="Page")
THEMES = ("light", "dark")
_LOOKS = 8
_LOST = 14
"""Of 255: a picture in 256 colours is kept when 999 of 1000 pixels lose no more."""


class Tour:
    """Of one program, in one language.

    Parameters
    ----------
    wanted : names of the scenes that are taken
    suffix : between the scene's name and its theme, such as ``-it``
    """

    def __init__(self, program: Program, prepared: Prepared, folder: Path, wanted: Sequence[str], themes: Sequence[str], suffix: str = "") -> None:
        self.program, self.prepared, self.folder = program, prepared, folder
        self.window, self.services = program.window, program.services
        self.cases = Path(self.services.settings.case_folder)
        self.ear = self.cases / EAR
        """An order that is scanned and reconstructed."""
        self.pages: dict[str, NDArray[np.uint8]] = {}
        """Scenes that are no window, (h, w, 3)."""
        self.failed: list[str] = []
        self._wanted, self._themes, self._suffix = wanted, themes, suffix

    def take(self, brings: Sequence[Bring], names: Callable[[Bring], Sequence[str]]) -> None:
        """The wanted scenes of these functions; one that fails is told and the others are taken all the same."""
        for bring in brings:
            missing = [name for name in names(bring) if name in self._wanted]
            if not missing:
                continue
            begun_s = time.monotonic()
            try:
                self._follow(bring(self), missing)
            except Exception:
                traceback.print_exc()
            self.failed += missing
            print(f"{bring.__name__}: {time.monotonic() - begun_s:.0f} s", file=sys.stderr, flush=True)
            self.rest()

    def _follow(self, scenes: Iterator[str], missing: list[str]) -> None:
        """To their end, where they tidy up."""
        for name in scenes:
            if name in missing:
                self.shoot(name)
                missing.remove(name)

    def shoot(self, name: str) -> None:
        """The window as it stands on the screen, the 3D view and what lies over it included, in both themes."""
        twice = "@2x" if self.window.devicePixelRatio() > 1.5 else ""
        if name in self.pages:
            write_picture(self.pages[name], self.folder / f"{name}{self._suffix}{twice}.png")
            return
        for theme in self._themes:
            self.services.settings.theme = theme
            self.services.preferences.changed.emit("theme")  # nothing that could be undone
            wait_ms(900)
            write_picture(self._still(), self.folder / f"{name}{self._suffix}-{theme}{twice}.png")

    def _still(self) -> NDArray[np.uint8]:
        """The window once nothing moves in it any more, or as it is after a while where something always does."""
        before = self._grab()
        for _ in range(_LOOKS):
            wait_ms(250)
            now = self._grab()
            if np.array_equal(now, before):
                break
            before = now
        return before

    def _grab(self) -> NDArray[np.uint8]:
        window = self.window
        grabbed = window.screen().grabWindow(0, window.x(), window.y(), window.width(), window.height()).toImage()
        image = grabbed.convertToFormat(QImage.Format.Format_RGB888)
        width, height = image.width(), image.height()
        return np.frombuffer(image.constBits(), np.uint8).reshape(height, image.bytesPerLine())[:, : 3 * width].reshape(height, width, 3).copy()

    # -------------------------------------------------------------------------------- for the scenes
    def page(self, name: str, kind: type[P]) -> P:
        """The page of that name."""
        found = self.window.pages[name]
        assert isinstance(found, kind)
        return found

    def open(self, path: Path) -> None:
        """A case, with its points, and its surface where it has one."""
        case = self.services.case
        self.window.open_case(path)
        until(lambda: case.path == path and (case.cloud is not None or case.surface is not None), 120, f"the case {self.window.banner.text}")
        wait_ms(400)

    def copied(self, made: Path, name: str) -> Path:
        """A prepared case as the order that its name says, beside the folder of the orders."""
        path = self.cases.parent / name
        shutil.copy(made, path)
        number, side, kind = path.stem.split("_")
        with CaseStore.open(path) as store:
            store.put_order(Order(number, "", side, kind))
        return path

    def rig_ready(self) -> None:
        rig = self.services.rig
        until(lambda: rig.snapshot.connected and rig.snapshot.calibration is not None, 240, "the rig")
        until(lambda: rig.snapshot.calibrating is None and not rig.snapshot.busy, 240, "the rig is free")

    def settled(self) -> None:
        """What was asked of the case is done."""
        done: list[bool] = []
        self.services.case.after(lambda: done.append(True))
        until(lambda: bool(done), 60, "the case")

    def rest(self) -> None:
        """Nothing runs, no case is open, and Home is shown."""
        services, window = self.services, self.window
        for dialog in window.findChildren(QDialog):
            dialog.close()
        if services.acquisition.running:
            services.acquisition.stop()
            until(lambda: not services.acquisition.running, 60, "the end of the scan")
        for waiting in services.reconstruction.queue.waiting:
            services.reconstruction.drop(waiting)
        if services.reconstruction.running:
            services.reconstruction.cancel()
            until(lambda: not services.reconstruction.running, 60, "the end of the reconstruction")
        window.help.dismiss()
        services.case.close()
        until(lambda: services.case.store is None, 30, "the case is closed")
        window.banner.dismiss()
        window.show_page("home")


def write_picture(pixels: NDArray[np.uint8], path: Path) -> None:
    """(h, w, 3) as PNG: in 256 colours where the eye does not see it, else in steps of four."""
    image = Image.fromarray(pixels)
    for method in (Image.Quantize.MAXCOVERAGE, Image.Quantize.MEDIANCUT):
        few = _commonest(image.quantize(256, method, dither=Image.Dither.NONE), pixels)
        lost = np.abs(np.asarray(few.convert("RGB")).astype(np.int16) - pixels).max(axis=2)
        if np.quantile(lost, 0.999) <= _LOST:
            few.save(path, optimize=True)
            break
    else:
        coarse = np.minimum((pixels.astype(np.int16) + 2) // 4 * 4, 255).astype(np.uint8)
        Image.fromarray(coarse).save(path, optimize=True)
    print(f"{path} {path.stat().st_size // 1024} kB", flush=True)


def _commonest(few: Image.Image, pixels: NDArray[np.uint8]) -> Image.Image:
    """Every colour of the palette is the one that most of its pixels have: what is flat keeps its colour exactly."""
    index = np.asarray(few).astype(np.int64).ravel()
    packed = pixels.reshape(-1, 3).astype(np.int64) @ (65536, 256, 1)
    found, counts = np.unique(index << 24 | packed, return_counts=True)
    order = np.argsort(counts, kind="stable")  # the last one of each number stays
    palette = np.zeros((256, 3), np.uint8)
    colours = found[order] & 0xFFFFFF
    palette[found[order] >> 24] = np.stack([colours >> 16, colours >> 8 & 255, colours & 255], axis=1)
    few.putpalette(palette.tobytes())
    return few
