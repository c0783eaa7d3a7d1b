"""Alignment, deviation, areas and motions on pairs of dental arches whose treatment is known, with peers in the same run."""
