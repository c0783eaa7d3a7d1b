"""Measures the optics against the truth of the virtual rig, over many seeds."""
