"""Conditions on any drive: all crank angles at which they hold."""
