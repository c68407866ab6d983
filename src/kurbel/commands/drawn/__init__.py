"""What all commands that draw have in common."""
