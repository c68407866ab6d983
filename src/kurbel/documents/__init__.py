"""Prose, whole documents and marked places as they are in every format."""
