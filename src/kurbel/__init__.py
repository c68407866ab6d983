"""Certified tables of the crank drive."""

__version__ = "0.1.0"
