"""Compare: two dental arches, what moved, side by side, behind the curtain, and a result that is not reliable."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from app.views.compare_page import ComparePage
from scanner_core.comparison.parameters import Frame, Jaw
from tests.gui.tour.registry import scenes
from tests.gui.tour.tour import Tour
from tests.gui.waiting import until, wait_ms


@scenes("compare", "compare-side-by-side", "compare-curtain", "compare-unreliable")
def compare(tour: Tour) -> Iterator[str]:
    window, comparing, page = tour.window, tour.services.comparing, tour.page("compare", ComparePage)
    window.show_page("compare")
    page.take_files(list(tour.prepared.arches(Path(tour.services.settings.export_folder))), None)
    until(lambda: page.scene is not None and comparing.answers.current, 240, "the comparison")
    comparing.draft.edit("jaw", jaw=Jaw.LOWER)
    wait_ms(800)
    until(lambda: comparing.answers.current, 240, "the comparison with its jaw")
    yield "compare"
    for mode in ("side_by_side", "curtain"):
        page.look("top")
        page.stage.choose_mode(mode)
        yield f"compare-{mode.replace('_', '-')}"
    page.stage.choose_mode("map")
    page.look("top")
    comparing.draft.edit("frame", frame=Frame.WHOLE)
    wait_ms(800)
    until(lambda: comparing.answers.current, 240, "the comparison of the whole")
    yield "compare-unreliable"
