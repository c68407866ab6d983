"""What the command line says of itself: topics and examples, tasks, and a search."""
