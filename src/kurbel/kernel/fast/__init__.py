"""The kernel's own formulas as loops of numba's, with the bits that they have on arrays."""
