"""The true geometry and the image model of the virtual rigs.

A preset is what stands on the virtual table: cameras and laser where they really are, not where the rig file believes
them to be.  The product never reads it; it calibrates.  All image terms are physical, with their equations below.
Positions are in the table frame (see :mod:`scanner_core`).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from scanner_core.errors import UsageError
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.optics.camera_model import CameraModel

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class VirtualPreset:
    """One virtual rig.

    Attributes
    ----------
    cameras
        Left and right, true; their "rig" frame is here the table frame: ``camera = rotation @ table + translation``.
    rate_hz, exposure_ms
        Triggered frames a second, and the exposure at which `peak_dn` holds.
    distance_mm
        R, from the cameras to the middle of the volume.
    laser_position_mm, laser_target_mm
        Pivot of the beam, and the point that it hits at X0 Y0, (3,).
    beam_diameter_mm
        1/e^2 diameter of the collimated Gaussian beam; its standard deviation is a quarter of it.
    beam_nodes
        Rays that sample the profile: 7 (quadrature exact to degree 5), or 25 (Gauss-Hermite product, degree 9) where the
        image is so sharp that single rays would show.
    focal_length_mm, f_number, wavelength_um
        Lens and light; sin u = focal_length / (2 f_number distance) is the lens's half aperture seen from the object.
    lens_sigma_px
        Gaussian standard deviation of the lens (x, y) that does not depend on the distance (aberrations, electronics).
    defocus_sigma_px, focus_mm
        Defocus (x, y) at R, for a lens focused at `focus_mm`; at depth z it is
        ``defocus_sigma |1/z - 1/focus| / |1/R - 1/focus|`` (circle of confusion, thin lens).
    peak_dn
        Brightest pixel of a spot at R on a matt white surface that faces the camera, at `exposure_ms` and 0 dB,
        over the black level.  The spot's flux is
        ``flux0 power albedo (exposure / exposure_ms) 10^(gain / 20) cos(normal, view) cos(field) (R / d)^2``:
        a Lambertian scatterer of all the beam's light, seen through a lens of foreshortened aperture.
    electrons_per_dn
        At 0 dB; the shot noise's variance is ``signal / electrons_per_dn`` DN^2.
    read_noise_dn, black_dn
        At 0 dB, rms; and the level of a dark frame.
    speckle
        Share of the fully developed, unpolarized speckle: 1 gives centroid shifts of
        ``0.65 wavelength / (2 pi sin u)`` rms on the surface per camera and axis (Dorsch, Haeusler, Herrmann 1994),
        bounded by the beam's sigma (in quadrature of the reciprocals), and a lognormal flux of contrast
        ``0.65 / sqrt(speckles in the spot)``; both are fields on the surface, so they repeat where the beam comes back,
        and a beam that moves by L during the exposure averages over them.  Their correlation length is the beam's own
        sigma, not the speckles' size: the pattern is fixed to the surface, what changes is the part of it that is lit
        (``tests/bench/optics/speckle_waves.py`` computes the waves; it finds shifts 0.7 times as large as these).
    surface_um
        rms of the optical surface about the geometric one along the normal (translucence, coating grain), a field with
        a correlation length of `surface_cell_mm`; both cameras see the same.
    specular
        Share of the light that leaves as a mirror reflection and makes a stray spot where it hits again.
    ambient_dn
        Room light in the spot's frames over the black level at `exposure_ms` and 0 dB; it brings its own shot noise.
    saturates
        Whether the spot may exceed 255 DN; else its light is attenuated so that the brightest pixel stays below (an ideal
        exposure control).
    backlash_deg
        Play of the table's drive: ``true = min(max(true before, reported), reported + backlash)``.
    warm_up_px, warm_up_s
        The images of both cameras drift while these get warm: by ``warm_up (1 - exp(-t / warm_up_s))`` along x and y, in
        opposite directions in the two cameras.

    Not modelled: the coherence of defocused light.  A lens that blurs by defocus spreads the speckles of its aperture, and
    the centroid's shift grows with the blur; see ``tests/bench/optics/speckle_waves.py``.
    """

    name: str
    cameras: tuple[CameraModel, CameraModel]
    rate_hz: float
    exposure_ms: float
    distance_mm: float
    laser_position_mm: Array
    laser_target_mm: Array
    beam_diameter_mm: float
    beam_nodes: int
    focal_length_mm: float
    f_number: float
    wavelength_um: float
    lens_sigma_px: tuple[float, float]
    defocus_sigma_px: tuple[float, float]
    focus_mm: float
    peak_dn: float
    electrons_per_dn: float
    read_noise_dn: float
    black_dn: float
    speckle: float
    surface_um: float
    surface_cell_mm: float
    specular: float
    ambient_dn: float
    backlash_deg: float
    warm_up_px: tuple[float, float]
    warm_up_s: float
    saturates: bool = True

    @property
    def beam_sigma_mm(self) -> float:
        return self.beam_diameter_mm / 4

    @property
    def sin_aperture(self) -> float:
        """sin u of the lens's half aperture seen from the object."""
        return self.focal_length_mm / (2 * self.f_number * self.distance_mm)

    @property
    def speckle_cell_mm(self) -> float:
        """Size of a speckle on the surface: the lens's resolution."""
        return 1e-3 * self.wavelength_um / (2 * self.sin_aperture)

    @property
    def speckle_shift_mm(self) -> float:
        """rms shift of the centroid on the surface, per camera and axis; it cannot leave the footprint."""
        free = 0.65e-3 * self.wavelength_um / (2 * np.pi * self.sin_aperture)
        return float(self.speckle * free * self.beam_sigma_mm / np.hypot(free, self.beam_sigma_mm))

    @property
    def speckle_contrast(self) -> float:
        """Relative rms of a spot's flux."""
        speckles = np.pi * (0.5 * self.beam_diameter_mm) ** 2 / self.speckle_cell_mm**2
        return float(self.speckle * 0.65 / np.sqrt(max(1.0, speckles)))

    def without(self, *terms: str) -> VirtualPreset:
        """The same rig with terms of the image model switched off (see :data:`TERMS`).

        Raises
        ------
        UsageError
            E-USE-01 for a term that is not known.
        """
        changes: dict[str, Any] = {}
        for term in terms:
            if term not in TERMS:
                raise UsageError("E-USE-01", what=f"The image model has no term '{term}'", do=f"choose from {', '.join(TERMS)}")
            changes |= TERMS[term]
        if changes.pop("undistorted", False):
            changes["cameras"] = tuple(replace(camera, distortion=np.zeros(5)) for camera in self.cameras)
        if changes.pop("square", False):
            changes["cameras"] = tuple(_square(camera) for camera in changes.get("cameras", self.cameras))
        return replace(self, **changes)

    def changed(self, image_model: Mapping[str, Any]) -> VirtualPreset:
        """The same rig with what a rig file's table ``[image_model]`` says.

        `image_model` holds numbers of this class by their names, and under ``without`` a list of terms to switch off.
        The spot's size stays when `f_number` changes: the lens is focused anew.  The distance and the rate belong to the
        cameras and cannot be set.

        Raises
        ------
        UsageError
            E-USE-01 for a name or a value that makes no rig.
        """
        numbers = {name: value for name, value in image_model.items() if name != "without"}
        for name, value in numbers.items():
            if name not in _NUMBERS:
                raise UsageError("E-USE-01", what=f"The image model has no number '{name}' to set", do=f"choose from {', '.join(_NUMBERS)}")
            number = isinstance(value, int | float) and not isinstance(value, bool) and 0 <= value < 1e9
            if not number or (value == 0 and name not in _MAY_BE_OFF):
                least = "a number that is not negative" if name in _MAY_BE_OFF else "a number greater than zero"
                raise UsageError("E-USE-01", what=f"'{name}' of the image model is {value}", do=f"choose {least}")
        terms = image_model.get("without", ())
        if not isinstance(terms, list | tuple):
            raise UsageError("E-USE-01", what="'without' of the image model is no list", do=f"choose from {', '.join(TERMS)}")
        changes: dict[str, Any] = {name: float(value) for name, value in numbers.items()}
        rig = replace(self, **changes)
        if rig.focus_mm == rig.distance_mm:
            raise UsageError(
                "E-USE-01",
                what=f"'focus_mm' of the image model is the cameras' distance, {rig.distance_mm:g} mm, where nothing is out of focus",
                do="choose another focus, or switch the term 'defocus' off",
            )
        if rig.sin_aperture >= 1:
            raise UsageError("E-USE-01", what="The image model's lens is wider than it is far away", do="choose a larger 'f_number'")
        return rig.without(*map(str, terms))


_NUMBERS = tuple(item.name for item in fields(VirtualPreset) if item.type == "float" and item.name not in ("distance_mm", "rate_hz"))
_MAY_BE_OFF = ("speckle", "surface_um", "specular", "ambient_dn", "backlash_deg", "read_noise_dn")
"""Numbers that may be zero."""

TERMS: dict[str, dict[str, Any]] = {
    "speckle": {"speckle": 0.0},
    "surface": {"surface_um": 0.0},
    "spot_size": {"beam_diameter_mm": 0.01},
    "lens_blur": {"lens_sigma_px": (0.01, 0.01)},
    "defocus": {"defocus_sigma_px": (0.0, 0.0)},
    "distortion": {"undistorted": True},
    "non_square_pixels": {"square": True},
    "shot_noise": {"electrons_per_dn": 1e12},
    "read_noise": {"read_noise_dn": 0.0},
    "saturation": {"saturates": False},
    "stray_light": {"specular": 0.0},
    "ambient_light": {"ambient_dn": 0.0},
    "backlash": {"backlash_deg": 0.0},
    "warm_up": {"warm_up_px": (0.0, 0.0)},
}
"""What can be switched off, to see what limits a rig: values of :class:`VirtualPreset` by the term's name."""

GEOMETRIC_TERMS = ("distortion", "non_square_pixels")
"""Terms that change the cameras: the rig has to be calibrated again."""


def _square(camera: CameraModel) -> CameraModel:
    """The same field of view along x with pixels as high as they are wide; the image has fewer rows for its height."""
    matrix = camera.matrix.copy()
    matrix[1, 1] = matrix[0, 0]
    return replace(camera, matrix=matrix)


def look_at(position: ArrayLike, target: ArrayLike) -> RigidTransform:
    """Table frame to the frame of an upright camera at `position` whose optical axis meets `target`, both (3,) mm."""
    eye = np.asarray(position, np.float64)
    forward = np.asarray(target, np.float64) - eye
    forward /= np.linalg.norm(forward)
    right = np.cross(forward, [0.0, 0.0, 1.0])
    right /= np.linalg.norm(right)
    rotation = np.stack([right, np.cross(forward, right), forward])
    return RigidTransform(rotation, -rotation @ eye)


def spherical(distance_mm: float, azimuth_deg: float, elevation_deg: float, target: ArrayLike) -> Array:
    """The point at a distance, azimuth (about +z, from +x) and elevation from `target`, (3,) mm."""
    a, e = np.radians(azimuth_deg), np.radians(elevation_deg)
    return np.asarray(target, np.float64) + distance_mm * np.array([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)])


TARGET = (0.0, 0.0, 25.0)
"""Middle of the volume, where all nominal axes meet."""
ELEVATION_DEG = 30.0
LASER_ELEVATION_DEG = 38.0


def camera_azimuth_deg(half_convergence_deg: float) -> float:
    """Azimuth of a camera at :data:`ELEVATION_DEG` whose axis makes `half_convergence_deg` with the plane between the two."""
    e = np.radians(ELEVATION_DEG)
    whole = np.cos(np.radians(2 * half_convergence_deg))
    return float(0.5 * np.degrees(np.arccos((whole - np.sin(e) ** 2) / np.cos(e) ** 2)))


# What the mounting got wrong, the same for every preset: rotation vectors in rad (camera frame), offsets in mm.
_MISALIGNED = (
    (RigidTransform.from_vector([0.0061, -0.0043, 0.0035], [0.0, 0.0, 0.0]), np.array([1.9, -2.6, 1.2])),
    (RigidTransform.from_vector([-0.0048, 0.0057, -0.0041], [0.0, 0.0, 0.0]), np.array([-2.3, 1.4, -1.7])),
)
_LASER_MISPLACED = np.array([2.4, -1.7, 1.9])
_LASER_MISAIMED = np.array([0.6, 0.9, -0.5])


def _cameras(
    distance_mm: float,
    half_convergence_deg: float,
    size_px: tuple[int, int],
    focal_px: tuple[float, float],
    distortions: tuple[ArrayLike, ArrayLike],
) -> tuple[CameraModel, CameraModel]:
    """Both cameras as they really stand; the table frame's +x points to the middle between them, by its definition."""
    azimuth = camera_azimuth_deg(half_convergence_deg)
    poses = []
    for side, (turned, offset) in zip((-1, 1), _MISALIGNED, strict=True):
        nominal = look_at(spherical(distance_mm, side * azimuth, ELEVATION_DEG, TARGET), TARGET)
        centre = -nominal.rotation.T @ nominal.translation + offset
        rotation = turned.rotation @ nominal.rotation
        poses.append((rotation, centre))
    middle = 0.5 * (poses[0][1] + poses[1][1])
    onto_x = RigidTransform.about_z(-float(np.degrees(np.arctan2(middle[1], middle[0])))).rotation
    cameras = []
    width, height = size_px
    for (rotation, centre), scale, off, distortion in zip(
        poses, ((1.0043, 1.0021), (0.9968, 0.9982)), ((0.0071, -0.0106), (-0.0058, 0.0119)), distortions, strict=True
    ):
        fx, fy = focal_px[0] * scale[0], focal_px[1] * scale[1]
        cx, cy = 0.5 * (width - 1) + off[0] * width, 0.5 * (height - 1) + off[1] * height
        matrix = np.array([[fx, 0.0, cx], [0.0, fy, cy], [0.0, 0.0, 1.0]])
        turned_rotation = rotation @ onto_x.T
        cameras.append(CameraModel(matrix, np.asarray(distortion, np.float64), turned_rotation, -turned_rotation @ (onto_x @ centre), size_px))
    return cameras[0], cameras[1]


_DISTORTIONS = ((-0.112, 0.094, 0.00042, -0.00031, -0.021), (-0.104, 0.081, -0.00035, 0.00047, -0.016))
"""k1, k2, p1, p2, k3."""


def _bench() -> VirtualPreset:
    """604 x 294 pixels of 10 x 15.6 um behind 8.5 mm, R = 435 mm; a slight defocus makes the spot sigma 1.0 x 0.8 px.

    That sigma holds footprint (0.29 x 0.19 px), lens and the pixel's own box (1/sqrt(12) px).  The shutters are open for most
    of a frame's time, under a laser that is attenuated accordingly: a beam that moves meanwhile averages over the speckle.
    """
    return VirtualPreset(
        name="bench",
        cameras=_cameras(435.0, 36.5, (604, 294), (850.0, 545.0), _DISTORTIONS),
        rate_hz=60.0,
        exposure_ms=12.0,
        distance_mm=435.0,
        laser_position_mm=spherical(450.0, 0.0, LASER_ELEVATION_DEG, TARGET) + _LASER_MISPLACED,
        laser_target_mm=np.array(TARGET) + _LASER_MISAIMED,
        beam_diameter_mm=0.6,
        beam_nodes=7,
        focal_length_mm=8.5,
        f_number=4.0,
        wavelength_um=0.633,
        lens_sigma_px=(0.45, 0.36),
        defocus_sigma_px=(0.795, 0.626),
        focus_mm=250.0,
        peak_dn=198.0,
        electrons_per_dn=80.0,
        read_noise_dn=1.4,
        black_dn=8.0,
        speckle=1.0,
        surface_um=0.0,
        surface_cell_mm=0.3,
        specular=0.02,
        ambient_dn=1.5,
        backlash_deg=0.02,
        warm_up_px=(0.008, 0.005),
        warm_up_s=900.0,
    )


def _paper_2003() -> VirtualPreset:
    """The published rig: R = 770 mm, a sharp lens at f/8, 50 um of surface term; the spot is smaller than a pixel.

    The sensor's noise is not published; with that of a good camera of its day the static spot scatters as published.
    """
    return VirtualPreset(
        name="paper-2003",
        cameras=_cameras(770.0, 36.5, (604, 294), (850.0, 545.0), _DISTORTIONS),
        rate_hz=60.0,
        exposure_ms=2.0,
        distance_mm=770.0,
        laser_position_mm=spherical(780.0, 0.0, LASER_ELEVATION_DEG, TARGET) + _LASER_MISPLACED,
        laser_target_mm=np.array(TARGET) + _LASER_MISAIMED,
        beam_diameter_mm=0.6,
        beam_nodes=25,
        focal_length_mm=8.5,
        f_number=8.0,
        wavelength_um=0.633,
        lens_sigma_px=(0.20, 0.13),
        defocus_sigma_px=(0.05, 0.03),
        focus_mm=700.0,
        peak_dn=198.0,
        electrons_per_dn=90.0,
        read_noise_dn=0.88,
        black_dn=8.0,
        speckle=1.0,
        surface_um=50.0,
        surface_cell_mm=0.3,
        specular=0.02,
        ambient_dn=1.5,
        backlash_deg=0.02,
        warm_up_px=(0.0, 0.0),  # what the publication reports was measured on a warm rig
        warm_up_s=900.0,
    )


def _workshop() -> VirtualPreset:
    """A present-day camera: 1440 x 1080 pixels of 3.45 um behind 8 mm at f/2, R = 600 mm, half angle 30 deg.

    The fast lens is what the small pixels need: at f/4 speckle alone scatters a sphere by 40 um.
    """
    return VirtualPreset(
        name="workshop",
        cameras=_cameras(600.0, 30.0, (1440, 1080), (2320.0, 2320.0), _DISTORTIONS),
        rate_hz=60.0,
        exposure_ms=12.0,
        distance_mm=600.0,
        laser_position_mm=spherical(610.0, 0.0, LASER_ELEVATION_DEG, TARGET) + _LASER_MISPLACED,
        laser_target_mm=np.array(TARGET) + _LASER_MISAIMED,
        beam_diameter_mm=0.6,
        beam_nodes=7,
        focal_length_mm=8.0,
        f_number=2.0,
        wavelength_um=0.633,
        lens_sigma_px=(0.5, 0.5),
        defocus_sigma_px=(0.565, 0.565),
        focus_mm=523.0,
        peak_dn=198.0,
        electrons_per_dn=40.0,
        read_noise_dn=1.0,
        black_dn=6.0,
        speckle=1.0,
        surface_um=10.0,
        surface_cell_mm=0.3,
        specular=0.02,
        ambient_dn=1.0,
        backlash_deg=0.02,
        warm_up_px=(0.015, 0.015),
        warm_up_s=900.0,
    )


PRESETS: dict[str, VirtualPreset] = {preset.name: preset for preset in (_bench(), _paper_2003(), _workshop())}
"""By name; the same names as in :data:`scanner_core.devices.rig.PRESETS`."""
