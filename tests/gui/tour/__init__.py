"""The pages of the window as named scenes, for the pictures of the guide."""

from tests.gui.tour import compare_scenes, order_scenes, rig_scenes, scan_scenes, surface_scenes
from tests.gui.tour.registry import SCENES
from tests.gui.tour.tour import THEMES

__all__ = ["SCENES", "THEMES", "compare_scenes", "order_scenes", "rig_scenes", "scan_scenes", "surface_scenes"]
