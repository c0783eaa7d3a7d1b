"""Speckle from wave optics, to see what the virtual rig's model of it is worth.

::

    python -m tests.bench.optics.speckle_waves [--seed 0]

A rough surface (complex normal amplitudes) under a Gaussian beam is imaged through a circular pupil, two polarizations
added; the centroid of the image's intensity is what speckle does to a spot.  Printed are its standard deviation beside
the formula ``0.65 lambda / (2 pi sin u)``, its correlation as the beam moves over the surface, what averaging over a path
leaves of it, and how it grows when the lens is out of focus: coherent light is not blurred like a painted spot.
"""

from __future__ import annotations

import argparse

import numpy as np

WAVELENGTH_MM = 0.633e-3
BEAM_SIGMA_MM = 0.15
STEP_MM = 0.05
PATH = np.arange(0, 1.01, STEP_MM)
LENSES = (("bench", 8.5, 4.0, 435.0), ("workshop", 8.0, 2.0, 600.0), ("workshop at f/4", 8.0, 4.0, 600.0), ("paper-2003", 8.5, 8.0, 770.0))


class Lens:
    """A grid on the surface (n x n, `pitch_mm`) and its coherent transfer through a lens."""

    def __init__(self, sin_u: float, defocus_sigma_mm: float = 0.0, pitch_mm: float = 0.016, n: int = 320) -> None:
        self.x = (np.arange(n) - n / 2) * pitch_mm
        frequency = np.fft.fftfreq(n, pitch_mm)
        square = frequency[:, None] ** 2 + frequency[None, :] ** 2
        # Out of focus by dz the blur is a disc of radius dz sin u, whose standard deviation per axis is half of that.
        phase = -np.pi * WAVELENGTH_MM * (2 * defocus_sigma_mm / sin_u) * square
        self.transfer = (np.sqrt(square) <= sin_u / WAVELENGTH_MM) * np.exp(1j * phase)

    def centroids(self, rng: np.random.Generator, places_mm: np.ndarray) -> np.ndarray:
        """Shift (m, 2) mm of the image's centroid for a beam at places along x of one rough surface."""
        n = len(self.x)
        rough = rng.standard_normal((2, n, n)) + 1j * rng.standard_normal((2, n, n))
        shifts = []
        for place in places_mm:
            amplitude = np.exp(-((self.x[None, :] - place) ** 2 + self.x[:, None] ** 2) / (4 * BEAM_SIGMA_MM**2))
            light = (np.abs(np.fft.ifft2(np.fft.fft2(rough * amplitude) * self.transfer)) ** 2).sum(axis=0)
            total = light.sum()
            shifts.append((light.sum(axis=0) @ self.x / total - place, light.sum(axis=1) @ self.x / total))
        return np.array(shifts)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--surfaces", type=int, default=24)
    given = parser.parse_args()
    for name, focal_mm, f_number, distance_mm in LENSES:
        sin_u = focal_mm / (2 * f_number * distance_mm)
        rng = np.random.default_rng(given.seed)
        runs = np.array([Lens(sin_u).centroids(rng, PATH - PATH.mean()) for _ in range(given.surfaces)])
        sd = runs.std()
        correlation = [float((runs[:, 0] * runs[:, k]).mean() / (runs[:, 0] ** 2).mean()) for k in (2, 4, 6, 8)]
        left = [float(np.mean([runs[:, i : i + k + 1].mean(axis=1).std() for i in range(0, len(PATH) - k, 4)]) / sd) for k in (6, 9, 12)]
        formula = 650 * WAVELENGTH_MM / (2 * np.pi * sin_u)
        print(f"{name} (f/{f_number:g}): centroid {1e3 * sd:.1f} um, formula {formula:.1f} um", flush=True)
        print("   correlation at 0.1, 0.2, 0.3, 0.4 mm: " + ", ".join(f"{c:.2f}" for c in correlation))
        print("   left after a path of 0.30, 0.45, 0.60 mm: " + ", ".join(f"{f:.2f}" for f in left))
        for defocus_mm in (0.1, 0.2, 0.4):
            blurred = Lens(sin_u, defocus_mm)
            spread = np.array([blurred.centroids(rng, np.zeros(1)) for _ in range(given.surfaces)]).std()
            print(f"   out of focus by a blur of {1e3 * defocus_mm:.0f} um (sigma, on the surface): centroid {1e3 * spread:.1f} um", flush=True)


if __name__ == "__main__":
    main()
