"""Mechanisms that move on interactive pages: where their joints are at every crank angle."""
