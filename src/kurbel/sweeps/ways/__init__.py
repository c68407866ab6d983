"""How the values of a sweep are computed: point by point, over the crank angle, or in arrays."""
