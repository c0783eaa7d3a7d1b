"""Which part of an object a scan has measured well enough, why the rest is not, and what would help.

The surface so far comes from the reconstruction, with its standard uncertainty and its support at every vertex.
:mod:`~scanner_core.coverage.sightlines` casts rays against it: what the beam and the two cameras reach at a table angle.
From that :mod:`~scanner_core.coverage.report` says of every vertex whether it is within the wanted uncertainty or why not.
"""
