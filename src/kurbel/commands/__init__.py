"""What is asked for, for Python: one function a page."""
