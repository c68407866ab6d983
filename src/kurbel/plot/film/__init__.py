"""Drawings that move: which parts of a figure go which way over a turn, as animated SVG and as GIF."""
