"""The steam engine over its turn: irregularity, turning effort, forces, flywheel, indicator cards."""
