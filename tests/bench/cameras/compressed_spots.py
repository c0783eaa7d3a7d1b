"""What colour filters, chroma subsampling and JPEG cost in the place of a red spot.

Per row: rms error of the centroid in x and y, px, over spots at random places, and the share that the detector accepted.  The light
of a red laser passes a colour camera's red filter whole, its green one to 8 % and its blue one to 3 %; colour sensors are RGGB and
interpolated linearly.  ``red`` and ``Y`` are the two images that could be measured; the exposure leaves the red filter unclipped but
for the last row, where it aims at the brightness of Y.  The detector and the noise are those of the preset ``bench``.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from scanner_core.devices.luminance import luminance
from scanner_core.optics.spot import Spot
from scanner_core.optics.spot_detection import SpotDetector, SpotDetectorParameters
from tests.bench.optics.spot_images import BENCH, SpotShape, expose, signals

SIZE = 128
MIDDLE = (52.0, 76.0)
"""Places are uniform in this square, so every phase to the 16-pixel blocks of a compressed frame occurs."""
GREEN, BLUE = 0.08, 0.03

Image = NDArray[np.uint8]
Codec = Callable[[Image], Image]


def raw(image: Image) -> Image:
    return image


def jpeg(quality: int, subsampling: int = cv2.IMWRITE_JPEG_SAMPLING_FACTOR_422) -> Codec:
    """Through a JPEG and back, colours and size kept."""

    def through(image: Image) -> Image:
        settings = [cv2.IMWRITE_JPEG_QUALITY, quality]
        if image.ndim == 3:
            settings += [cv2.IMWRITE_JPEG_SAMPLING_FACTOR, subsampling]
        coded = cv2.imencode(".jpg", image, settings)[1]
        return np.asarray(cv2.imdecode(coded, cv2.IMREAD_UNCHANGED), np.uint8)

    return through


def yuyv(image: Image) -> Image:
    """Through 4:2:2 without compression and back, as OpenCV decodes it."""
    yuv = cv2.cvtColor(image, cv2.COLOR_BGR2YUV_YUY2)
    return np.asarray(cv2.cvtColor(yuv, cv2.COLOR_YUV2BGR_YUY2), np.uint8)


def red(image: Image) -> Image:
    return np.asarray(image[:, :, 2], np.uint8)


def y(image: Image) -> Image:
    """As the driver for USB cameras takes it."""
    measured = luminance(image)
    assert measured is not None
    return measured


@dataclass(frozen=True, slots=True)
class Camera:
    """A way from light to the measured image; `exposed` is the height of the light in the red filter, DN."""

    name: str
    colour: bool
    codec: Codec
    measured: Codec
    exposed: float = 190.0


CAMERAS = (
    Camera("monochrome, raw", False, raw, raw),
    *(Camera(f"monochrome, MJPG {quality}", False, jpeg(quality), raw) for quality in (95, 85, 70, 50)),
    Camera("colour, uncompressed, red", True, raw, red),
    Camera("colour, YUYV, red", True, yuyv, red),
    Camera("colour, MJPG 95 4:2:2, red", True, jpeg(95), red),
    Camera("colour, MJPG 85 4:2:2, red", True, jpeg(85), red),
    Camera("colour, MJPG 85 4:2:0, red", True, jpeg(85, cv2.IMWRITE_JPEG_SAMPLING_FACTOR_420), red),
    Camera("colour, YUYV, Y", True, yuyv, y),
    Camera("colour, MJPG 85 4:2:2, Y", True, jpeg(85), y),
    Camera("colour, YUYV, Y exposed to 190", True, yuyv, y, 2400.0),
)


def frame(camera: Camera, shape: SpotShape, x: float, y: float, rng: np.random.Generator) -> Image:
    """The frame as it leaves the camera and is decoded."""
    light = signals(np.array([x]), np.array([y]), shape.optical, camera.exposed, (SIZE, SIZE))[0]
    if not camera.colour:
        return camera.measured(camera.codec(expose(light, BENCH, rng)))
    filtered = GREEN * light
    filtered[::2, ::2] = light[::2, ::2]
    filtered[1::2, 1::2] = BLUE * light[1::2, 1::2]
    mosaic = expose(filtered, BENCH, rng)
    return camera.measured(camera.codec(np.asarray(cv2.cvtColor(mosaic, cv2.COLOR_BayerRGGB2BGR), np.uint8)))


def measure(camera: Camera, shape: SpotShape, count: int, seed: int) -> str:
    rng = np.random.default_rng(seed)
    detector = SpotDetector(SpotDetectorParameters(read_noise_dn=BENCH.read_dn, shot_dn=BENCH.shot_dn))
    errors, peaks = [], []
    for x, y in rng.uniform(*MIDDLE, (count, 2)):
        image = frame(camera, shape, x, y, rng)
        peaks.append(float(image.max()))
        if isinstance(spot := detector.detect(image), Spot):
            errors.append((spot.x_px - x, spot.y_px - y))
    found = len(errors) / count
    if not errors:
        return f"{camera.name:32s} found {found:4.0%}  brightest {np.median(peaks):3.0f}"
    e = np.array(errors)
    rms, mean = np.sqrt((e**2).mean(axis=0)), e.mean(axis=0)
    return (
        f"{camera.name:32s} found {found:4.0%}  brightest {np.median(peaks):3.0f}"
        f"  rms {rms[0]:.4f} / {rms[1]:.4f}  mean {mean[0]:+.4f} / {mean[1]:+.4f} px"
    )


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--spots", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    for sigma_x, sigma_y in ((1.0, 0.8), (1.4, 1.4), (2.0, 2.0)):
        print(f"sigma {sigma_x} x {sigma_y} px, {given.spots} spots, seed {given.seed}")
        for camera in CAMERAS:
            print("  " + measure(camera, SpotShape(sigma_x, sigma_y, camera.exposed), given.spots, given.seed))
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
