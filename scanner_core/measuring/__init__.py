"""What a person measures on a surface: distances, sections, the length of an ear canal, volumes.

Lengths are in mm, areas in mm^2, volumes in mm^3, standard uncertainties (k = 1) in the unit of what they belong to, if not said otherwise.
"""
