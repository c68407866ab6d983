"""Drawings over the piston's path: both strokes closed into one curve."""
