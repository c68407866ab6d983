"""Drawings of the motion, the mechanisms, the forces and the turning effort."""
