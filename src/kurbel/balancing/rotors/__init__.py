"""Rotating masses: what they leave unbalanced, and the masses that balance them."""
