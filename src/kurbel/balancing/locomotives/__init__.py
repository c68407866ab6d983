"""Locomotives: balancing masses in the wheels, hammer blow, swaying couple, variation of tractive force."""
