"""Engines at very many crank angles: floats with bounds first, and balls for the doubtful cells."""
