"""The case file: one SQLite database that keeps everything that was measured."""
