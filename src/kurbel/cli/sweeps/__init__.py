"""`kurbel sweep`: a command at every combination of what its options are given, into a file of columns."""
