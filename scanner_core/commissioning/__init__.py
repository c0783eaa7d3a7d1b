"""Setting a rig up: which devices there are, whether the rig does what it is told by what its cameras see, and its first rig file."""
