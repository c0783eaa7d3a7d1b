"""Both palettes: readable, read when painting, and changed while the program runs."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from dataclasses import fields
from pathlib import Path

import pytest
from PySide6.QtCore import QSize
from PySide6.QtGui import QColor, QIcon
from PySide6.QtWidgets import QApplication

from app.palettes import DARK, LIGHT, PAIRS, SIGNS, Palette, contrast
from app.program import Program
from app.theme import Sign, icon, look, set_theme
from tests.gui.pictures import near, pixels_of
from tests.gui.waiting import wait_ms

APP = Path(__file__).parents[2] / "app"
NAMES = {field.name for field in fields(Palette)}


@pytest.mark.parametrize("palette", [DARK, LIGHT], ids=["dark", "light"])
def test_every_text_is_readable_on_every_ground_it_stands_upon(palette: Palette) -> None:
    for pairs, least in ((PAIRS, 4.5), (SIGNS, 3.0)):
        found = {pair: round(contrast(*(getattr(palette, name) for name in pair)), 2) for pair in pairs}
        assert not {pair: ratio for pair, ratio in found.items() if ratio < least}


def test_the_contrast_is_that_of_the_recommendation() -> None:
    """Its own examples: black on white, and the greys that just meet and just miss 4.5:1."""
    assert contrast("#000000", "#ffffff") == pytest.approx(21.0)
    assert contrast("#767676", "#ffffff") == pytest.approx(4.54, abs=0.005)
    assert contrast("#777777", "#ffffff") == pytest.approx(4.48, abs=0.005)


@pytest.fixture(scope="module")
def trees() -> list[tuple[Path, ast.Module]]:
    texts = ((path, path.read_text(encoding="utf-8")) for path in sorted(APP.rglob("*.py")))
    return [(path, ast.parse(text)) for path, text in texts if "look" in text or "icon" in text or "setStyleSheet" in text]


def _read_early(node: ast.AST) -> Iterator[int]:
    """Lines where a colour is read when the module is imported: outside of functions, and in default arguments."""
    for child in ast.iter_child_nodes(node):
        if isinstance(child, ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda):
            for default in (*child.args.defaults, *child.args.kw_defaults):
                if default is not None:
                    yield from _read_early(ast.Expr(default))
        else:
            if isinstance(child, ast.Attribute) and isinstance(child.value, ast.Name) and child.value.id == "look":
                yield child.lineno
            yield from _read_early(child)


def test_no_colour_of_the_palette_is_bound_at_import(trees: list[tuple[Path, ast.Module]]) -> None:
    assert not [f"{path.name}:{line}" for path, tree in trees for line in _read_early(tree)]


def test_every_icon_names_a_colour_and_no_inline_style_holds_one(trees: list[tuple[Path, ast.Module]]) -> None:
    wrong = []
    for path, tree in trees:
        for call in (node for node in ast.walk(tree) if isinstance(node, ast.Call)):
            name = call.func.id if isinstance(call.func, ast.Name) else call.func.attr if isinstance(call.func, ast.Attribute) else ""
            texts = [part.value for part in call.args if isinstance(part, ast.Constant) and isinstance(part.value, str)]
            if name == "icon" and any(text not in NAMES for text in texts[1:]):
                wrong.append(f"{path.name}:{call.lineno} {texts}")
            if name == "setStyleSheet" and any("#" in text or "look" in text for text in texts):
                wrong.append(f"{path.name}:{call.lineno} {texts}")
    assert not wrong


def _colour(drawn: QIcon, mode: QIcon.Mode = QIcon.Mode.Normal, state: QIcon.State = QIcon.State.Off) -> QColor:
    """The colour of the icon's densest pixel."""
    image = drawn.pixmap(QSize(32, 32), 1.0, mode, state).toImage()
    densest = max((image.pixelColor(x, y).alpha(), x, y) for x in range(image.width()) for y in range(image.height()))
    return image.pixelColor(*densest[1:])


@pytest.fixture
def dark_again(application: QApplication) -> Iterator[None]:
    set_theme(application, "dark")
    yield
    set_theme(application, "dark")


@pytest.mark.usefixtures("dark_again")
def test_an_icon_that_is_there_already_takes_the_other_palettes_colour(application: QApplication) -> None:
    drawn, sign = icon("play", "accent", "text"), Sign(16, "warning", "warning")
    for theme, palette in (("dark", DARK), ("light", LIGHT)):
        set_theme(application, theme)
        assert look.accent == palette.accent
        assert _colour(drawn).name() == palette.accent
        assert _colour(drawn, state=QIcon.State.On).name() == palette.text
        assert _colour(drawn, QIcon.Mode.Disabled).name() == palette.faint
        assert near(pixels_of(sign), palette.warning, 40).sum() > 8


@pytest.mark.usefixtures("dark_again")
def test_window_and_3d_view_change_while_the_program_runs(application: QApplication, shared_program: Program) -> None:
    window = shared_program.window
    assert window.scene is not None
    for theme, palette in (("light", LIGHT), ("dark", DARK)):
        set_theme(application, theme)
        wait_ms(50)
        rail = pixels_of(window.rail)
        assert near(rail, palette.panel, 3).mean() > 0.5
        assert near(rail, palette.text, 30).sum() > 20
        picture = window.scene.grab_picture()
        assert near(picture[-3:], palette.scene_low, 8).mean() > 0.9
        assert near(picture[:3], palette.scene_high, 8).mean() > 0.9
