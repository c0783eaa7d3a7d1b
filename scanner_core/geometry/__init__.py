"""Transforms, point clouds, triangle meshes, and what can be asked of them."""
