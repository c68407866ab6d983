"""Turning-moment diagrams that no engine makes, as options describe them."""
