"""What the command line says of itself: topics and examples, tasks, a search, and its manual pages."""
