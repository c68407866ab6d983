"""Engines of unlike cylinders on their pages: what is said of each, and the list of them."""
