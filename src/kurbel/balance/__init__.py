"""The harmonics of the piston's motion and the balance of engines with several cranks."""
