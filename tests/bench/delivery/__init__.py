"""Benchmarks of what is checked before a delivery."""
