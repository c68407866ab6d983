"""Strings of Typst's code."""

from __future__ import annotations

_STRING = str.maketrans({"\\": r"\\", '"': r"\"", "\n": r"\n"})


def string(text: str) -> str:
    """Return a text as a string of Typst's code, quotation marks included."""
    return f'"{text.translate(_STRING)}"'
