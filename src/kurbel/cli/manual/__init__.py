"""What the command line says of itself: its options in sections."""
