"""Sweeps: a command at every combination of what its options are given, and files of columns."""
