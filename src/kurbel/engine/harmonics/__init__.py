"""Harmonics of the tangential force and the torque, of each cylinder and of the engine."""
