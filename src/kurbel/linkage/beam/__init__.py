"""The beam engine: its dead centres as the book has them, and the crank drive in its true geometry."""
