"""The speed over the turn of an engine with a given flywheel, in steady state, and how even it is."""
