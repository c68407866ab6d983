"""What is asked of one cylinder."""
