from __future__ import annotations

from collections import Counter
from importlib import resources

from app.actions import ACTIONS
from app.views.main_window import MainWindow
from app.views.pages import PAGES


def test_every_line_names_a_method_of_the_window_and_a_drawing() -> None:
    icons = resources.files("resources") / "icons"
    for info in ACTIONS:
        assert callable(getattr(MainWindow, info.slot)), info
        assert not info.icon or (icons / f"{info.icon}.svg").is_file(), info


def test_ids_and_shortcuts_are_unique() -> None:
    assert max(Counter(info.id for info in ACTIONS).values()) == 1
    shortcuts = Counter(info.shortcut for info in ACTIONS if info.shortcut) + Counter(["Ctrl+,", *(f"Ctrl+{n}" for n in range(1, len(PAGES) + 1))])
    assert max(shortcuts.values()) == 1


def test_the_pages_stand_in_the_order_of_the_work() -> None:
    assert [page.id for page in PAGES] == ["home", "rig", "aim", "scan", "edit", "reconstruct", "deliver", "compare"]
