"""The size of a crank, given in other ways than by its stroke 2R."""
