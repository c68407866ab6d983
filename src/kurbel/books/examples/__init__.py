"""The worked examples of the books, as printed and recomputed."""
