"""From pixels to points: camera model, spot detection, triangulation, calibration."""
