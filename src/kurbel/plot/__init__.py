"""Drawings of pages, each made by what its subject names, and of mechanisms."""
