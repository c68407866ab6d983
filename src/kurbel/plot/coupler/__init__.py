"""Points of the rod in drawings of mechanisms."""
