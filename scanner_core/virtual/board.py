"""The calibration board before the virtual cameras, under a lamp."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.rigid import RigidTransform
from scanner_core.optics.board import CharucoTarget
from scanner_core.optics.camera_model import CameraModel
from scanner_core.virtual.presets import TARGET, VirtualPreset
from scanner_core.virtual.print_errors import TYPICAL, BoardFaults, PrintErrors
from scanner_core.virtual.projection import lens_sigma_px

Array = NDArray[np.float64]
Image = NDArray[np.float32]

WHITE_DN, BLACK_DN, ROOM_DN = 190.0, 22.0, 14.0
"""Over the black level, at the preset's exposure: paper that faces the lamp, ink, and everything round the board."""

LAMP_MM = (420.0, 260.0, 760.0)
"""The room's lamp in the table frame; paper in the middle of the volume that faces it has :data:`WHITE_DN`."""
_LAMP_GRID = 9

_TEXELS_PER_SQUARE = 200
_MARGIN_MM = 12.0
_MANY_PIXELS = 500_000
"""Above this two samples per pixel and axis suffice instead of three: the pixels are finer than the lens."""
_BLUR_PX = 8
"""Pixels round the board that its blur reaches."""


class BoardRenderer:
    """Images of a board by inverse mapping of a fine grid of samples per pixel.

    Each sample's ray is undistorted with the true camera and met with the board's plane (a homography), moved by the
    board's own errors; the texture is read there, blurred like the lens does and averaged over the pixel.
    """

    def __init__(self, preset: VirtualPreset, index: int, target: CharucoTarget, faults: BoardFaults = TYPICAL) -> None:
        self._preset, self._camera = preset, preset.cameras[index]
        self._target = target
        self._fine = 3 if self._camera.size_px[0] * self._camera.size_px[1] < _MANY_PIXELS else 2
        self.errors = PrintErrors(target, faults)
        self._per_mm = _TEXELS_PER_SQUARE / target.square_mm
        size = (target.columns * _TEXELS_PER_SQUARE, target.rows * _TEXELS_PER_SQUARE)
        self._margin = round(_MARGIN_MM * self._per_mm)
        paper = np.asarray(target.board().generateImage(size, marginSize=0, borderBits=1))
        paper = cv2.copyMakeBorder(paper, *(self._margin,) * 4, cv2.BORDER_CONSTANT, value=255)
        self._texture = (BLACK_DN + (WHITE_DN - BLACK_DN) / 255.0 * paper).astype(np.float32)
        self._rays: Image | None = None

    def signal(self, pose: RigidTransform) -> Image:
        """Noise-free image (H, W) in DN over the black level; `pose` takes the board's frame to the table frame."""
        width, height = self._camera.size_px
        image = np.full((height, width), ROOM_DN, np.float32)
        rotation = self._camera.rotation @ pose.rotation
        origin = self._camera.rotation @ pose.translation + self._camera.translation
        left, top, right, bottom = self._outline(pose)
        if rotation[:, 2] @ origin <= 0 or left >= right or top >= bottom:
            return image
        step = self._fine
        rays = self._fine_rays()[:, step * top : step * bottom, step * left : step * right]
        u, v = self._texels(rays[0], rays[1], rotation, origin)
        fine = cv2.remap(self._texture * self._lamp_light(pose), u, v, cv2.INTER_LINEAR, borderMode=cv2.BORDER_CONSTANT, borderValue=ROOM_DN)
        centre = origin + rotation[:, :2] @ (0.5 * np.array(self._target.size_mm))
        sigma = lens_sigma_px(self._preset, float(max(centre[2], 1.0)))
        fine = cv2.GaussianBlur(fine, (0, 0), sigmaX=step * sigma[0], sigmaY=step * sigma[1], borderType=cv2.BORDER_REPLICATE)
        image[top:bottom, left:right] = cv2.resize(fine, (right - left, bottom - top), interpolation=cv2.INTER_AREA)
        return image

    def _outline(self, pose: RigidTransform) -> tuple[int, int, int, int]:
        """Left, top, right and bottom (exclusive) of the part of the image that the board can reach."""
        (width_mm, height_mm), edge = self._target.size_mm, _MARGIN_MM
        along = np.linspace(-edge, width_mm + edge, 12), np.linspace(-edge, height_mm + edge, 12)
        x, y = np.meshgrid(*along)
        pixels = self._camera.project(pose.apply(np.stack([x.ravel(), y.ravel(), np.zeros(x.size)], axis=1)))
        low = np.floor(pixels.min(axis=0)).astype(int) - _BLUR_PX
        high = np.ceil(pixels.max(axis=0)).astype(int) + _BLUR_PX + 1
        width, height = self._camera.size_px
        return max(0, int(low[0])), max(0, int(low[1])), min(width, int(high[0])), min(height, int(high[1]))

    def _texels(self, x: Image, y: Image, rotation: Array, origin: Array) -> tuple[Image, Image]:
        """Where in the texture rays (normalized image coordinates) end; rotation and origin take the board to the camera."""
        # Board (x, y) in mm to normalized image coordinates is [r1 r2 t]; its inverse takes rays to the board.
        m = np.linalg.inv(np.c_[rotation[:, :2], origin]).astype(np.float32)
        depth = m[2, 0] * x + m[2, 1] * y + m[2, 2]
        depth[np.abs(depth) < 1e-9] = 1e-9
        board_x, board_y = (m[0, 0] * x + m[0, 1] * y + m[0, 2]) / depth, (m[1, 0] * x + m[1, 1] * y + m[1, 2]) / depth
        along_x, along_y, into = (np.float32(r[0]) * x + np.float32(r[1]) * y + np.float32(r[2]) for r in rotation.T)
        slope_x, slope_y = along_x / into, along_y / into
        # The errors belong to the mark that is seen, not to where its ray meets the plane: with 0.3 mm of bend the first
        # answer is wrong by a micrometre, the second by nothing.
        mark_x, mark_y = board_x, board_y
        for _ in range(2):
            shift_x, shift_y, bulge = self.errors.at(mark_x, mark_y)
            mark_x, mark_y = board_x - (shift_x + bulge * slope_x), board_y - (shift_y + bulge * slope_y)
        scale, offset = np.float32(self._per_mm), np.float32(self._margin - 0.5)
        return scale * mark_x + offset, scale * mark_y + offset

    def _lamp_light(self, pose: RigidTransform) -> Image:
        """Light of the lamp on every texel, ``cos(normal, lamp) / d^2`` plus a tenth from everywhere; it varies slowly."""
        rows, columns = self._texture.shape
        along = (np.arange(_LAMP_GRID) + 0.5) / _LAMP_GRID
        x, y = np.meshgrid(along * columns, along * rows)
        places = np.stack([x.ravel() - self._margin, y.ravel() - self._margin, np.zeros(x.size)], axis=1) / self._per_mm
        to_lamp = np.array(LAMP_MM) - pose.apply(places)
        distance2 = (to_lamp**2).sum(axis=1)
        cosine = np.maximum(to_lamp @ -pose.rotation[:, 2], 0.0) / np.sqrt(distance2)
        reference = float(((np.array(LAMP_MM) - TARGET) ** 2).sum())
        light = np.minimum(0.1 + 0.9 * cosine * reference / distance2, 1.15).reshape(x.shape).astype(np.float32)
        return np.asarray(cv2.resize(light, (columns, rows), interpolation=cv2.INTER_LINEAR), np.float32)

    def _fine_rays(self) -> Image:
        """Undistorted normalized coordinates of the samples, (2, fine H, fine W)."""
        if self._rays is None:
            width, height = self._camera.size_px
            columns = (np.arange(self._fine * width) + 0.5) / self._fine - 0.5
            rows = (np.arange(self._fine * height) + 0.5) / self._fine - 0.5
            x, y = np.meshgrid(columns, rows)
            rays = self._camera.normalize(np.stack([x.ravel(), y.ravel()], axis=1))
            self._rays = np.ascontiguousarray(rays.T.reshape(2, *x.shape), np.float32)
        return self._rays


def flat_on_table(target: CharucoTarget, table_deg: float, lowest_mm: float = 0.0) -> RigidTransform:
    """The board's pose when it lies face up on the table, roughly centred and askew, as an operator puts it.

    It is a thin print that keeps its bend: the lowest point of its face is at z = 0 (see :meth:`PrintErrors.lowest_mm`).
    """
    face_up = RigidTransform(np.diag([1.0, -1.0, -1.0]), np.zeros(3))
    centred = RigidTransform(np.eye(3), -np.array([*(0.5 * np.array(target.size_mm)), 0.0]))
    laid = RigidTransform(RigidTransform.about_z(94.0).rotation, np.array([3.4, -2.1, -lowest_mm]))
    return RigidTransform.about_z(table_deg) @ laid @ face_up @ centred


def operator_poses(preset: VirtualPreset, target: CharucoTarget, count: int = 24, seed: int = 0, *, whole: bool = False) -> list[RigidTransform]:
    """Board poses (board to table frame) as an operator holds it: through the whole volume, tilted and turned.

    Each camera sees at least half of the board's corners (all of them if `whole`), at less than 62 degrees from its normal.
    """
    rng = np.random.default_rng([seed, 0xB0A2D])
    middle = sum((camera.centre_mm() for camera in preset.cameras), np.zeros(3)) / 2
    room = 0.19 * preset.distance_mm
    half = np.array([*(0.5 * np.array(target.size_mm)), 0.0])
    poses: list[RigidTransform] = []
    while len(poses) < count:
        place = np.array(TARGET) + rng.uniform(-room, room, 3) * [1.0, 1.0, 0.7]
        facing = _facing(place, middle)
        tilt = RigidTransform.from_vector(np.radians([*rng.uniform(-32, 32, 2), rng.uniform(-40, 40)]), np.zeros(3))
        rotation = facing @ tilt.rotation
        pose = RigidTransform(rotation, place - rotation @ half)
        if all(_visible(camera, target, pose, 1.0 if whole else 0.5) for camera in preset.cameras):
            poses.append(pose)
    return poses


def _facing(place: Array, eye: Array) -> Array:
    """Board axes (columns x right, y down, z away) of a board at `place` that faces `eye`."""
    z = (place - eye) / np.linalg.norm(place - eye)
    x = np.cross(z, [0.0, 0.0, 1.0])
    x /= np.linalg.norm(x)
    return np.stack([x, np.cross(z, x), z], axis=1)


def _visible(camera: CameraModel, target: CharucoTarget, pose: RigidTransform, share: float) -> bool:
    points = pose.apply(target.object_points)
    towards = points.mean(axis=0) - camera.centre_mm()
    if pose.rotation[:, 2] @ towards < np.cos(np.radians(62)) * np.linalg.norm(towards):
        return False
    pixels, size = camera.project(points), np.array(camera.size_px)
    inside = ((pixels > 8) & (pixels < size - 9)).all(axis=1)
    return bool(inside.mean() >= share)
