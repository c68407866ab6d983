"""What CI runs: the manifest of a handbook, its build, check and watch."""
