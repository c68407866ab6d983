"""Turning-moment diagrams that no engine makes: torques by formula, points or areas, and loads."""
