"""Ensslin's figures: the accelerations of the connecting rod in parts (Figs. 1 to 4), and the rod under each
of them alone, with its inertia force and what it presses on A and B (Figs. 5 to 7).

rod.py has what all figures share, forces.py what the last three do.
"""
