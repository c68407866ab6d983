"""Flywheels without an engine: what is given of one finds the rest, from the energy swing to the rim."""
