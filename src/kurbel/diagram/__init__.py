"""Turning-moment diagrams that no engine of kurbel makes, and how a machine's energy varies under them."""
