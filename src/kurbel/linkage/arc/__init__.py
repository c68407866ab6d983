"""The arc crank, whose rod moves a rocker."""
