"""Two surfaces of one patient: what moved, where, how much, and whether the answer can be trusted.

::

    file, case -> inputs        surface in mm, its unit and oddities named           ComparedSurface
    -> aligning                 start, stable region, pose with covariance           Alignment
    -> measuring                signed distance both ways, level of detection        Deviation
    -> areas                    one entry a moved tooth, its rigid motion, words     Area
    -> report, keeping, window

What is worth arguing about:

*What is held fixed.*  The least-squares fit of two whole arches spreads the movement of the moved teeth over those that stayed: with
3 of 14 teeth moved it is 130-200 um off on tissue that did not move, with 10 of 14 about 600 um.  So the default frame is the region that the
surfaces have in common, found automatically: fit the half that agrees best, smooth the signed distance along the surface, keep what
lies within its own noise, take a seam off, drop small pieces, fit again.  Its lengths are millimetres, not rings, so that it does not depend
on the triangles.  A robust loss whose scale comes from the residuals fails when about half has moved; the noise is measured where
nothing moved.  If everything moved no geometry says what is fixed: then the frame is named, a person paints it, or the result is not
called reliable.  How far the other frames would have shifted the answer stands beside every result.

*Errors and doubts.*  What makes an answer meaningless (other objects, a mirrored file, no overlap) is an error with its sentence.  What
makes it weaker (open, turned triangles, a guessed unit, a small stable region) is a `Doubt`, a value that travels with the result
to screen, report and JSON; a serious one takes the word "reliable" away.  Nothing is repaired silently: the surfaces that are compared are
those of the files.

*Noise that is correlated.*  Scanners and meshers smooth, so neighbouring vertices err alike, and counting them as independent states
uncertainties that are several times too small.  The correlation along the surface is measured on the stable region, and goes into the
fit (generalised least squares), its covariance, the motions of teeth and the level of detection.

*No counterpart is not zero.*  Where the closest point lies on a border or farther than 3 mm away nothing was measured on the other
side; such places are hatched and left out of every number, and every number says its direction (after against before, + outward).

*A tooth is one entry.*  A map shows a moved tooth as a + and a - patch and reads less than it moved (a tooth that moved by 2.0 mm reads 1.6-1.9).
Patches that one rigid motion explains are one entry, ranked by that motion.

*Two levels of detection.*  The one of a comparison follows from its own noise and alignment; the null comparison (one model measured twice)
holds what repeats within each scan too, and belongs to a rig and a material.
"""
