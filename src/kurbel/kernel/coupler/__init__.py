"""Any point of the rod: its path, velocity and acceleration."""
