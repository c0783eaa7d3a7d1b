"""Quality and speed of the reconstruction, on surfaces whose truth is known and beside other programs.

::

    python -m tests.bench.reconstruction              errors, topology and uncertainties, with the peers on the same draws
    python -m tests.bench.reconstruction.speed        paired times against Open3D
    python -m tests.bench.reconstruction.refinement   what each refinement criterion does with the same number of triangles
    python -m tests.bench.reconstruction.real FILE... real mesh files, sampled and reconstructed

All of them need the extra ``bench`` (``pip install -e .[bench]``); nothing here is imported by the program.
"""
