"""Edit, measure, reconstruct, deliver."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from io import BytesIO
from pathlib import Path
from unittest import mock

import numpy as np
from PIL import Image
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest

from app.controllers.measurements import Measurements
from app.views.deliver_page import DeliverPage
from app.views.edit_page import EditPage
from app.views.edit_shapes import BaseShape, CropShape
from app.views.reconstruct_page import ReconstructPage
from scanner_core.delivery import certificate_page
from scanner_core.metrology.certificate_page import Page
from tests.gui.pointer import move
from tests.gui.tour.registry import scenes
from tests.gui.tour.tour import Tour
from tests.gui.waiting import until, wait_ms

_LEFT = Qt.MouseButton.LeftButton
_PLAIN = Qt.KeyboardModifier.NoModifier
_LASSO = ((0.30, 0.66), (0.34, 0.58), (0.42, 0.55), (0.48, 0.60), (0.50, 0.68), (0.46, 0.75), (0.38, 0.77), (0.32, 0.73))


def _stroke(tour: Tour, *way: tuple[float, float], end: bool = True) -> None:
    """With the left button along places of the 3D view, as shares of its width and height; not let go unless at its `end`."""
    scene = tour.window.scene
    assert scene is not None
    engine = scene._engine
    places = [QPoint(round(x * scene.width()), round(y * scene.height())) for x, y in way]
    QTest.mousePress(engine, _LEFT, _PLAIN, places[0])
    for place in places[1:]:
        move(engine, place, _LEFT)
    if end:
        QTest.mouseRelease(engine, _LEFT, _PLAIN, places[-1])
    wait_ms(100)


@scenes("edit", "edit-lasso", "edit-crop", "edit-base")
def edit(tour: Tour) -> Iterator[str]:
    editing, page = tour.services.editing, tour.page("edit", EditPage)
    tour.open(tour.ear)
    tour.window.show_page("edit")
    until(lambda: editing.points is not None, 60, "the points to edit")
    wait_ms(2000)  # they are drawn
    page.points.out_too.setChecked(True)
    page.points.tools["brush"].click()
    _stroke(tour, *((0.40 + 0.01 * step, 0.62 + 0.002 * step) for step in range(13)))
    until(lambda: editing.out.any(), 30, "brushed points")
    tour.settled()
    yield "edit"
    page.points.all_back.click()
    tour.settled()
    page.points.tools["lasso"].click()
    _stroke(tour, *_LASSO, end=False)
    yield "edit-lasso"
    scene = tour.window.scene
    assert scene is not None
    QTest.mouseRelease(scene._engine, _LEFT, _PLAIN, QPoint(round(_LASSO[-1][0] * scene.width()), round(_LASSO[-1][1] * scene.height())))
    tour.settled()
    tour.window.undo()
    tour.settled()
    page.points.choices["crop"].click()
    crop = page.points.shapes["crop"]
    assert isinstance(crop, CropShape)
    crop.fields[1].number.setValue(5.0)
    until(lambda: editing.gain > 0, 60, "the points outside of the box")
    yield "edit-crop"
    page.points.choices["base"].click()
    base = page.points.shapes["base"]
    assert isinstance(base, BaseShape)
    base.height_mm.number.setValue(2.5)
    until(lambda: editing.gain > 0, 60, "the base")
    yield "edit-base"
    page.drop.click()
    page.points.out_too.setChecked(False)


def _more(measurements: Measurements, count: int) -> bool:
    return len(measurements.items) > count and not measurements.busy


@scenes("measure")
def measure(tour: Tour) -> Iterator[str]:
    measurements, page = tour.services.measurements, tour.page("edit", EditPage)
    tour.open(tour.ear)
    tour.window.show_page("edit")
    page.measure_tab.click()
    until(lambda: page._drawn is not None and page._drawn[0] is tour.services.case.surface, 60, "the surface to point at")
    wait_ms(800)
    for place in ((0.36, 0.68), (0.60, 0.66)):
        _stroke(tour, place)
    until(lambda: len(measurements.items) == 1, 30, "the distance")
    for way in ("volume", "canal"):
        page.measure.ways[way].click()
        count = len(measurements.items)
        page.measure.do.click()
        until(partial(_more, measurements, count), 60, way)
    page.measure.ways["section"].click()
    until(lambda: page.measure.do.isEnabled(), 60, "the section")
    page.measure.place.number.setValue(13.0)
    wait_ms(800)
    page.measure.do.click()
    until(lambda: len(measurements.items) == 4, 30, "the section in the list")
    wait_ms(300)
    yield "measure"
    page.points_tab.click()


@scenes("reconstruct-before", "inflating", "queue")
def reconstruct(tour: Tour) -> Iterator[str]:
    job, window = tour.services.reconstruction, tour.window
    page = tour.page("reconstruct", ReconstructPage)
    tour.open(tour.copied(tour.prepared.scanned, "2026-0136_right_ear.impronta"))
    window.show_page("reconstruct")
    yield "reconstruct-before"
    window.start_reconstruction()
    until(lambda: (job.shown_triangles or 0) > 300 or not job.running, 200, "a preview")
    yield "inflating"
    if not job.running:
        window.start_reconstruction()
    tour.open(tour.copied(tour.prepared.scanned, "2026-0135_left_ear.impronta"))
    window.start_reconstruction()
    if page.services.reconstruction.waits:
        wait_ms(300)
    yield "queue"


@scenes("reconstruct", "uncertainty", "expert")
def surface(tour: Tour) -> Iterator[str]:
    page, window = tour.page("reconstruct", ReconstructPage), tour.window
    tour.open(tour.ear)
    wait_ms(800)
    yield "reconstruct"
    window.actions_by_id["show_uncertainty"].setChecked(True)
    yield "uncertainty"
    window.actions_by_id["show_uncertainty"].setChecked(False)
    page.again.click()
    page.wishes.unfold.click()
    yield "expert"
    page.wishes.unfold.click()
    page.again.click()


@scenes("deliver", "delivered", "delivery-certificate")
def deliver(tour: Tour) -> Iterator[str]:
    delivery, page = tour.services.delivery, tour.page("deliver", DeliverPage)
    tour.open(tour.ear)
    tour.window.show_page("deliver")
    until(lambda: delivery.examination is not None, 120, "the checks")
    wait_ms(500)
    yield "deliver"
    dpi = 110 * tour.window.devicePixelRatio()

    def keep(page: Page, path: Path) -> None:
        picture = BytesIO()
        page.figure.savefig(picture, format="png", dpi=dpi)
        tour.pages["delivery-certificate"] = np.asarray(Image.open(picture).convert("RGB"))
        save_page(page, path)

    save_page = certificate_page.save_page
    with mock.patch.object(certificate_page, "save_page", keep):
        if page.anyway.isVisible():
            page.anyway.click()
        page.primary.click()
        until(lambda: delivery.last is not None, 120, f"the files {tour.window.banner.text}")
    wait_ms(500)
    yield "delivered"
    yield "delivery-certificate"


@scenes("deliver-remarks")
def remarks(tour: Tour) -> Iterator[str]:
    """A surface of which nothing is known but its shape."""
    delivery, page = tour.services.delivery, tour.page("deliver", DeliverPage)
    cases = Path(tour.services.settings.case_folder)
    tour.services.case.open(cases / "2026-0143_upper_arch-before.impronta")
    until(lambda: tour.services.case.surface is not None, 60, "the surface")
    tour.window.show_page("deliver")
    until(lambda: delivery.examination is not None, 120, "the checks")
    page.checks.setFocus()
    wait_ms(500)
    yield "deliver-remarks"
