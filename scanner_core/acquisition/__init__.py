"""From a wish to points in the case: the plan, the cameras' frames and their pairing, the scan that follows the plan, and its health.

One thread, the scan's, owns the controller; capture threads see the frames, and whatever takes seconds to compute is done in a worker
process while the rig rests, dark (:mod:`~scanner_core.acquisition.runner`, :mod:`~scanner_core.acquisition.following`).

A scan either spreads its points evenly, or goes *where the error is* (:mod:`~scanner_core.acquisition.error_driven`):

- **One record, whose plan grows.**  Every further pass adds views to the plan of the same scan, and the case holds them before the first
  of them is exposed.  So whatever is right for a scan is right for it: counts that balance over the trigger ids, resuming after a pulled
  plug (also one between two passes), registration of all views together, and computing anew.  A scan for each pass would have needed all
  of that once more, across scans.  The price: views are not evenly spread, and a plan is not known before its scan, so it is not recorded.
- **The uncertainty steers, not the density of points or the curvature.**  The fitted surface states at every vertex how well it is known;
  that already weighs how many points there are, how each lies to beam and cameras, and what detail it must carry.  Points go where one
  of them lessens the squared error most (:mod:`~scanner_core.acquisition.allocation`), from the angle from which it tells most
  (:mod:`~scanner_core.acquisition.view_choice`), in rows that cost little time (:mod:`~scanner_core.acquisition.beam_rows`).
- **What was tried counts for more than what was predicted.**  A surface that is half known promises sights that are not there; the share
  of exposures that gave points (:mod:`~scanner_core.acquisition.yields`) and where the beam really went
  (:mod:`~scanner_core.acquisition.beam_fit`) come from the scan itself, and a pass takes no more points than there are so far.
- **It has an end** (:class:`~scanner_core.acquisition.passes.PassesEnd`), which a person is told: all within, no gain, points or views
  spent.  Where no surface can be made, the rest of the points is spread evenly: a scan never comes to nothing by being clever.
- What one axis cannot reach is not chased; :mod:`~scanner_core.acquisition.remount` says how to set the object down anew.
"""
