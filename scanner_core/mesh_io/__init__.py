"""Meshes and point clouds in files."""
