"""What is asked of a driver, in its own units, and what it refused."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from scanner_core.devices.luminance import luminance
from scanner_core.devices.opencv_settings import Wanted, fourcc_name, fourcc_number, set_exposure, set_gain, set_up
from tests.core.devices.captures import DriverModel


class DirectShow(DriverModel):
    """Exposure in powers of two of a second, the automatic as 0 and 1."""

    backend = "DSHOW"

    def __init__(self) -> None:
        super().__init__()
        self.values[cv2.CAP_PROP_EXPOSURE] = -5.0

    def set(self, prop: int, value: float) -> bool:
        if prop == cv2.CAP_PROP_EXPOSURE:
            self.values[prop] = float(np.clip(value, -13, -1))
            return True
        return super().set(prop, value)


class Stubborn(DriverModel):
    """The automatic exposure stays on, whatever it is told."""

    def set(self, prop: int, value: float) -> bool:
        return prop != cv2.CAP_PROP_AUTO_EXPOSURE and super().set(prop, value)


class Bare(DriverModel):
    """Neither exposure nor gain."""

    def __init__(self) -> None:
        super().__init__()
        for prop in (cv2.CAP_PROP_EXPOSURE, cv2.CAP_PROP_AUTO_EXPOSURE, cv2.CAP_PROP_GAIN, cv2.CAP_PROP_AUTOFOCUS):
            del self.values[prop]


class Stream(Bare):
    backend = "FFMPEG"


def test_what_is_taken_is_no_refusal() -> None:
    camera = DriverModel()
    taken = set_up(camera, Wanted((320, 240), 30.0, "mjpg", 3.0, 8.0))
    assert taken.size_px == (320, 240)
    assert (taken.rate_hz, taken.pixel_format, taken.exposure_ms, taken.gain_db, taken.refused) == (30.0, "MJPG", 3.0, 8.0, ())
    assert camera.values[cv2.CAP_PROP_EXPOSURE] == 30  # 100 us
    assert camera.values[cv2.CAP_PROP_AUTO_EXPOSURE] == 1
    assert camera.values[cv2.CAP_PROP_AUTOFOCUS] == 0


def test_every_refusal_is_a_sentence_of_its_own() -> None:
    taken = set_up(DriverModel(), Wanted((1000, 700), 60.0, "GREY", 0.1, 120.0))
    assert dict(taken.refused) == {
        "pixel_format": "The format 'GREY' was refused; the camera gives 'YUYV'.",
        "size_px": "The size 1000 x 700 was refused; the camera gives 640 x 480.",
        "rate_hz": "The rate of 60 frames/s was refused; the driver says 30.",
        "exposure_ms": "The exposure of 0.1 ms was refused; the camera has 0.3 ms.",
        "gain_db": "The gain 120 was refused; the camera has 100 (in steps of its own).",
    }


def test_nothing_wanted_leaves_the_camera_to_its_automatic() -> None:
    camera = DriverModel()
    camera.values[cv2.CAP_PROP_AUTO_EXPOSURE] = 1
    assert set_up(camera, Wanted()).refused == ()
    assert camera.values[cv2.CAP_PROP_AUTO_EXPOSURE] == 3
    assert camera.values[cv2.CAP_PROP_GAIN] == 20


@pytest.mark.parametrize(("asked_ms", "value", "has_ms"), [(4.0, -8, 3.90625), (31.25, -5, 31.25), (0.05, -13, 0.1220703125)])
def test_direct_show_has_powers_of_two(asked_ms: float, value: float, has_ms: float) -> None:
    camera = DirectShow()
    exposure_ms, refused = set_exposure(camera, asked_ms)
    assert camera.values[cv2.CAP_PROP_EXPOSURE] == value
    assert camera.values[cv2.CAP_PROP_AUTO_EXPOSURE] == 0
    assert exposure_ms == has_ms
    assert len(refused) == (asked_ms == 0.05)


def test_no_exposure_is_the_shortest() -> None:
    assert set_exposure(DirectShow(), 0.0)[0] == 1e3 * 2.0**-13
    assert set_exposure(DriverModel(), 0.0)[0] == set_exposure(DriverModel(), 0.01)[0]


def test_an_automatic_that_stays_on_is_told() -> None:
    assert set_exposure(Stubborn(), 5.0) == (5.0, ["The automatic exposure cannot be switched off; the spot's brightness will wander."])


def test_what_is_not_there_cannot_be_set() -> None:
    assert set_exposure(Bare(), 5.0) == (0.0, ["The exposure cannot be set; the camera keeps its own."])
    assert set_gain(Bare(), 6.0) == (0.0, ["The gain cannot be set; the camera keeps its own."])
    assert set_gain(Bare(), 0.0) == (0.0, [])
    assert set_exposure(Stream(), 5.0)[0] == 0.0


def test_a_streams_word_on_its_rate_is_not_believed() -> None:
    taken = set_up(Stream(), Wanted(rate_hz=60.0, exposure_ms=1.0))
    assert taken.rate_hz == 0.0
    assert [setting for setting, _ in taken.refused] == ["exposure_ms"]


def test_four_letters_there_and_back() -> None:
    for name in ("MJPG", "YUYV", "Y16 ", "GREY"):
        assert fourcc_name(fourcc_number(name.strip())) == name
    assert fourcc_number("MJPG") == cv2.VideoWriter.fourcc(*"MJPG")
    assert fourcc_name(-1.0) == fourcc_name(0.0) == ""


def test_luminance_is_measured() -> None:
    colour = np.dstack([np.full((16, 16), value, np.uint8) for value in (10, 20, 200)])
    expected = round(0.114 * 10 + 0.587 * 20 + 0.299 * 200)
    for frame in (colour, np.dstack([colour, colour[..., :1]]), cv2.imencode(".jpg", colour)[1].reshape(1, -1)):
        image = luminance(frame)
        assert image is not None
        assert image.shape == (16, 16)
        assert np.abs(image.astype(int) - expected).max() <= 1
    grey = colour[..., 2]
    assert luminance(grey) is grey
    assert np.array_equal(luminance(grey[..., None]), grey)
    assert luminance(np.zeros((1, 900), np.uint8)) is None  # a broken JPEG


@pytest.mark.parametrize(("shape", "kind"), [((4, 6), np.uint16), ((4, 6, 2), np.uint8), ((4, 6), np.float32)])
def test_other_frames_are_refused_by_name(shape: tuple[int, ...], kind: type[np.generic]) -> None:
    with pytest.raises(ValueError, match=r"bits a pixel|no image"):
        luminance(np.zeros(shape, kind))
