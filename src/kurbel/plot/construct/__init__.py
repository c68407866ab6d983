"""Constructions as drawings: what books/constructions says, to scale, step by step."""
