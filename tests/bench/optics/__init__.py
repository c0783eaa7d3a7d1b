"""How well and how fast the spot is found, against the Cramer-Rao bound and a plain loop of OpenCV calls.

::

    python -m tests.bench.optics.spot_accuracy    errors over the bound, stated over actual uncertainty, sigma, for each centroid
    python -m tests.bench.optics.spot_moving      spots that move during the exposure, clipped or not
    python -m tests.bench.optics.spot_speed       detect, pair and triangulate, whole frames and tracked, in turns with the plain loop
"""
