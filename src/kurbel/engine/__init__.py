"""Engines and driven machines over their cycle: irregularity, turning effort, forces, flywheel, loads."""
