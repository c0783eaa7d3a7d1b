"""Measures the optics against the truth of the virtual rig and against bounds: each module is a command with a ``--help``."""
