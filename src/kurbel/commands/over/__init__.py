"""Tables over the piston's path in place of the crank angle."""
