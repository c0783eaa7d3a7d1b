"""Pages and panels: they show values and tell intentions, and compute nothing."""
