"""Mounts of one object that overlap in part, and how they are brought together."""
