"""The combined load of the connecting rod over a turn: its extremes, and its reversal at the crosshead."""
