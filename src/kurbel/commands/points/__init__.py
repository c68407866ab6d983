"""Points of the rod: what options ask for of them."""
