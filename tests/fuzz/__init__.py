"""Fuzzing of everything that reads what comes from outside: the same harnesses for hypothesis and for a coverage-guided fuzzer."""
