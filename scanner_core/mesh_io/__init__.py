"""Meshes and point clouds in files."""

from scanner_core.mesh_io.reader import read_mesh, read_points
from scanner_core.mesh_io.writer import check_suffix, write_mesh, write_points

__all__ = ["check_suffix", "read_mesh", "read_points", "write_mesh", "write_points"]
