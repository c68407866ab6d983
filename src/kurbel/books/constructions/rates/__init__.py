"""Constructions of the piston's velocity and acceleration: each a module, what they share in plan.py.

Drawn where the pin's velocity v is as long as R: a length is then the velocity over ω, or the acceleration
over ω². None is drawn without a source that says its steps; registry.py names those for which none was found.
"""
