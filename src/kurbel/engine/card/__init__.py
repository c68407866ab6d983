"""The indicator card: as it was measured, its force on the piston, and a turn under it."""
