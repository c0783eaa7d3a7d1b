"""Cameras and motion controllers: the seams (:mod:`.camera`, :mod:`.motion`) and the drivers side by side."""
