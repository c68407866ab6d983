"""The other crank drives: the arc crank, the parallel crank, the beam engine, quick returns."""
