"""Approximations: the motion by powers of λ, what such a power series leaves out, and successive steps."""
