"""Several mounts of one object: a person turned or tilted it in between, and each mount has an object frame of its own."""
