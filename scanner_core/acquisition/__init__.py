"""Scan plan, capture threads, pairing, runner and live cloud."""
