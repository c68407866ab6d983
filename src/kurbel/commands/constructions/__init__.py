"""Constructions as options describe them."""
