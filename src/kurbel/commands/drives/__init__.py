"""Crank drives as options give them."""
