"""What is described, checked once: crank, rod, masses, flywheel, machine file."""
