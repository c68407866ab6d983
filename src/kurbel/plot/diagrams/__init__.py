"""Drawings of turning-moment diagrams without an engine."""
