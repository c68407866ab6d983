"""A number other than the crank angle for which a condition holds: speed, force, pressure, mass, ratio."""
