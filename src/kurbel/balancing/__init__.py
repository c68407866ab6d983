"""The harmonics of the piston's motion, the balance of engines with several cranks, and firing orders."""
