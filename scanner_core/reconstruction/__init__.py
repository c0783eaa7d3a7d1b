"""Points in, a closed triangular mesh out, by adaptive deformation in three phases.

The phases are the published ones, each in its own file and in this order:

``inflate``
    An icosahedron (12 vertices, 20 triangles) inflates inside the points until it meets them and is subdivided 1:4.
``refine``
    The surface is fitted to the points and locally re-sampled where an error function asks for more detail.
``smooth``
    Taubin's lambda | mu filter, which neither shrinks the surface nor changes its connectivity.

``pipeline.reconstruct`` runs them; ``parameters`` says what can be asked for, ``report`` what is answered.

Decisions
---------
*The balloon is guided by an enclosed region, not by the points.*  A balloon pulled by raw points gets caught in noise and
stray points, and leaks where the base was not scanned.  ``region`` finds the inside on voxels: a shielded potential tells
outside from inside without normals, and a winding number (a Poisson equation on the grid) closes what was not scanned;
for a plane border its level one half is that plane.  No surface is extracted from the voxels: they only say how much room
is left in front of a vertex.

*The data term is a smoothing spline on the mesh* (``spline``), not the nearest point: the noise of many points is averaged
over a bandwidth.  What it penalises is the unevenness of the curvature, so that a sphere is not flattened.  Robust weights
come after the solve, because rejecting before it throws detail away.

*The bandwidth differs from place to place* (``bandwidth``).  One for the whole surface is too wide at a ridge and too narrow on
the plain around it: on a heart model with 170 um of noise it leaves 61 um, the local choice 38.  Cross-validation over the
surroundings of each vertex chooses, from coarse to fine, and where the narrowest bandwidth that the triangles carry wins,
there is more detail than they can show: that is where they are split.  So the published idea, to re-sample where the
data's error is large, decides about the fit; where a settled surface only has to be drawn, the sag of the facets decides
(``error_function``).  On a dental arch with 30,000 triangles uniform ones leave 16.9 um, the data's error 16.3, the sag 14.6.

*Under heavy noise a point has no foot* (``association``).  When the noise is as wide as the triangles, every vertex gets its
probability of being the point's origin, and the fit climbs the likelihood of the surface.  It knows of the bias that noise
causes on curved surfaces and of points that are nearer to the wrong wall: 1 mm of noise on 20,000 points of an ear leaves
150 um, nearest points 195.  There the points do not tell how much detail is real; a floor for the bandwidth does.

*Points count by their covariances and their number* (``observations``).  A covariance is believed in its proportions; its scale
comes from the residuals.  More than 120,000 points are merged into cells, which for least squares is exact; coarse levels see
larger cells.

*What no point supports is a cap, not a guess* (``support``, ``cap``): a soap film in the rim of the scanned surface.  A thin plate
would bulge by millimetres, and a film free to move the rim would drag measured surface along.  What is supported is told by
the density of the points on the surface against the density that they have among themselves.  A cap is never counted as measured.

*The uncertainty is the smoother's own* (``uncertainty``, ``pass_band``): the noise that it passes, and the detail that it takes away.

*Most of the time goes where the surface still moves.*  Few passes see all of it; then only the restless places are solved again.
A warm start of the feet was tried and given up: in slits it keeps points at the wrong wall.

*Who is content early gets a whole surface.*  Phase two ends with the first of its levels that reaches all points, then come the same
repairs and checks; the uncertainty is that of the coarser fit.  On three shapes with 1,200 to 24,000 triangles the error was predicted
1.05 to 2.15 times too large, never too small.  Phase one is not cut short: a balloon amid the points is no surface of theirs.

*Never a wrong mesh.*  The balloon must fill the region; folds, crossings and bad triangles are mended where they are
(``repair``); the result must be closed, manifold, outward, free of crossings, and must reach the points: otherwise one
sentence says why there is no mesh.

Coordinates are taken about the centre of the points; the same points and seed give the same bytes.
"""
