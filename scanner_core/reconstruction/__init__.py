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
over a bandwidth that cross-validation chooses, never below the noise itself.  Robust weights come after the solve, because
rejecting before it throws detail away.  Noise on a curved surface is not centred on it; its mean offset, sigma squared
times the mean curvature, is subtracted.

*Coarse to fine.*  Cross-validation runs on the coarsest mesh that can carry the winning bandwidth; finer levels only draw
the same surface with more triangles, and their number can be hit exactly: a split edge adds two.

*What no point supports is a cap, not a guess* (``cap``): a soap film in the rim of the scanned surface.  A thin plate would
bulge by millimetres, and a film free to move the rim would drag measured surface along.  It is marked as unsupported.

*Never a wrong mesh.*  The balloon must fill the region, the result must be closed, manifold and outward; otherwise one
sentence says why there is no mesh.

Coordinates are taken about the centre of the points; the same points and seed give the same bytes.
"""
