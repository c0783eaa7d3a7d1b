"""Nothing is told by colour alone, and the maps are read by eyes that tell fewer colours apart.

What signals by colour, and what else says it: lamps (a word), the side (a word), the laser's button (a word, and filled or not),
reasons of missing places (a sign), phases (three drawings), supported and unsupported surface (a legend with words, and lightness).
"""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from app.palettes import DARK, LIGHT, Palette
from app.program import Program
from app.views.colour_maps import MAPS
from app.views.coverage_words import REASON_SIGNS
from app.views.parts import Lamp, SideBadge
from app.views.surface_colours import SUPPORTED, UNCERTAINTY, UNSUPPORTED
from scanner_core.coverage.reason import Reason
from tests.gui.waiting import until

_SEEN = {
    "all": np.eye(3),
    # Machado, Oliveira and Fernandes (2009), A physiologically-based model for simulation of color vision deficiency, severity 1.0
    "no red": np.array([[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]]),
    "no green": np.array([[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]]),
    "no blue": np.array([[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]]),
}


def _lab(colours: tuple[str, ...], eye: str) -> NDArray[np.float64]:
    """(n, 3) CIE L*a*b* of colours as an eye sees them; the matrices act on linear RGB, D65."""
    rgb = np.array([[int(colour[at : at + 2], 16) / 255 for at in (1, 3, 5)] for colour in colours])
    linear = np.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4) @ _SEEN[eye].T
    xyz = np.clip(linear, 0, 1) @ np.array([[0.4124564, 0.2126729, 0.0193339], [0.3575761, 0.7151522, 0.1191920], [0.1804375, 0.0721750, 0.9503041]])
    share = xyz / np.array([0.95047, 1.0, 1.08883])
    root = np.where(share > 216 / 24389, np.cbrt(share), (24389 / 27 * share + 16) / 116)
    return np.stack([116 * root[:, 1] - 16, 500 * (root[:, 0] - root[:, 1]), 200 * (root[:, 1] - root[:, 2])], axis=1)


@pytest.mark.parametrize("eye", _SEEN)
def test_the_maps_go_from_dark_to_light_or_back_for_every_eye(eye: str) -> None:
    of_points = [stops for colours in MAPS.values() if not colours.cycle for stops in (colours.on_dark, colours.on_light)]
    for stops in (*of_points, UNCERTAINTY):
        lightness = _lab(tuple(stops), eye)[:, 0]
        steps = np.diff(lightness)
        assert (steps > 1).all() or (steps < -1).all(), (eye, lightness.round(1))  # 1 is the least that is seen


@pytest.mark.parametrize("eye", _SEEN)
def test_what_has_to_be_told_apart_is_apart_for_every_eye(eye: str) -> None:
    supported, unsupported = _lab((SUPPORTED, UNSUPPORTED), eye)
    assert np.linalg.norm(supported - unsupported) > 20


@pytest.mark.parametrize("palette", [DARK, LIGHT], ids=["dark", "light"])
@pytest.mark.parametrize("eye", _SEEN)
def test_left_and_right_are_apart_for_every_eye(palette: Palette, eye: str) -> None:
    left, right = _lab((palette.left_ear, palette.right_ear), eye)
    assert np.linalg.norm(left - right) > 15


def test_every_lamp_and_every_badge_has_a_word(shared_program: Program) -> None:
    window = shared_program.window
    for name, page in window.pages.items():
        window.show_page(name)
        lamps = (*page.findChildren(Lamp), *window.status_line.findChildren(Lamp))
        until(lambda lamps=lamps: all(lamp.text for lamp in lamps if lamp.isVisible()), 20, f"a word at every lamp of {name}")
    badge = SideBadge()
    for side in ("left", "right"):
        badge.show_side(side)
        assert badge.text()
        badge.hide()
    window.show_page("home")


def test_every_reason_has_a_sign_of_its_own() -> None:
    missing = [sign for reason, sign in REASON_SIGNS.items() if reason is not Reason.WITHIN]
    assert all(sign.strip() for sign in missing)
    assert len(set(missing)) == len(missing)
