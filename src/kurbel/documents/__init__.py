"""Prose, whole documents, and marked places in one's own documents."""
