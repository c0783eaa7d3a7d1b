"""Icons, rig presets and translations; read through ``importlib.resources``."""
