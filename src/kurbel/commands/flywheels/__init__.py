"""The flywheel of an engine, and that of a problem without one."""
