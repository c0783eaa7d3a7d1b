"""Impronta's instrument, headless: from two cameras' frames to a closed triangular mesh.

Light goes in on one side and a file comes out on the other; the folders stand in that order::

    devices, virtual    cameras and the motion controller, real and simulated
    optics              spots, triangulation, calibration
    acquisition         plan, capture, pairing, runner
    case                what was measured, crash-safe
    geometry            transforms, point cloud, triangle mesh, registration, checks
    reconstruction      the three phases of the adaptive deformation
    jobs                the worker process
    mesh_io             files in and out

This package imports neither Qt nor pyvista nor ``app``; a test holds it to that.

Frames of reference, named in every signature:

``rig``
    The left camera's own frame (OpenCV: x right, y down, z forward), mm.
``object``
    Origin where the turntable's axis meets the table, +z up along the axis, +x horizontal towards the middle
    between the two cameras when the table stands at 0 degrees; it turns with the table.
``table``
    The same origin and axes as ``object`` at 0 degrees; it stands still.
``camera``
    One camera's own frame; ``camera = R rig + t``.

The table's angle is positive counter-clockwise seen from above: ``p_table = Rz(angle) p_object``.
Arrays of points are (n, 3) float64 in millimetres; images are (H, W) uint8 with the centre of the first pixel at (0, 0).
"""

__version__ = "0.1.0"
