"""From a table to the text or the bytes of a format."""
