"""Printed values of the books against recomputed ones, with verdicts; their worked examples."""
