"""Any point of the rod: where it is, how pages ask for it, what they say of it."""
