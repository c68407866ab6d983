"""Pure arithmetic of the crank drive: one formula for floats, arrays and balls."""
