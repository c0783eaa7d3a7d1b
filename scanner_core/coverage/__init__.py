"""Which part of an object a scan has measured well enough, why the rest is not, and what would help.

- **The measure is the standard uncertainty of the surface**, as the reconstruction states it at every vertex, and whether points bear it
  out.  The density of points would call a sharp crest and a plain alike, and a distance to the points says nothing of a hole.
- **Reasons come from light, not from the look of the surface.**  :mod:`~scanner_core.coverage.sightlines` casts rays from a place to the
  beam's pivot and both cameras at every ten degrees of the table; what hinders it is the first thing that light would meet
  (:class:`~scanner_core.coverage.reason.Reason`).  A place that light reaches but that is not within is short of points, and only that is
  scanned again; the other reasons say what a person can do: turn the object over, powder it, move it.
- **The surface where nobody has looked is a guess**, and a film over a hole is in plain sight.  So the exposures have a say
  (:mod:`~scanner_core.coverage.exposures`, :mod:`~scanner_core.coverage.rejections`): where light should have given a point and gave
  none, the verdict tells why; and spots that one camera alone saw have a place on the beam, with which the surface is reconstructed once
  more (:mod:`~scanner_core.coverage.guess`) to see what hides what.  That costs a reconstruction, so an error-driven scan does without
  it between its passes and takes it for the report at its end.
- **Two shares are told**, because they mean different things: ``within_fraction`` of the whole surface, and
  ``reachable_within_fraction`` of what can be measured as the object stands.  The second one is what a scan can bring to 1 and what its
  passes tell; the first one needs further mounts.

:mod:`~scanner_core.coverage.covering` brings it together in a :class:`~scanner_core.coverage.report.CoverageReport`; places of one reason
are joined and sized by :mod:`~scanner_core.coverage.placing`.
"""
