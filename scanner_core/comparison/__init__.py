"""Two surfaces of one patient: what moved, where, how much, and whether the answer can be trusted."""
