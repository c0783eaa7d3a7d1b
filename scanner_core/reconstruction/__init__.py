"""Points in, a closed triangular surface out: the adaptive deformation in its three phases."""
