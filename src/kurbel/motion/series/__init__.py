"""Approximations of the motion: methods by powers of λ, their errors over the turn, and Rötscher's steps."""
