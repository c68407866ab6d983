"""Printed formulas of the books: each against the one that it follows from, by proof or counter-example."""
