"""Files of columns: one module a format, found by the suffix of the file."""
