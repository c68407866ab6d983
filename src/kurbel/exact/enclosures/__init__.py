"""Arrays of floats that know how far each of them may lie from the true value."""
