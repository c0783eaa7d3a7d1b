"""Which points of a cloud a person means: by an outline or a brush on the screen, a box, a plane at the base, or as outliers.

Everything here answers with a mask (n,) over the points; nothing is changed.
"""
