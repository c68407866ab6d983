"""The work of a sweep: who computes its parts, and the folder where they lie until the file is whole."""
