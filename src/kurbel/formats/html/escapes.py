"""Prose and marks of labels in HTML."""

from __future__ import annotations

import re

_HTML = str.maketrans({"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;"})


def escape(prose: str) -> str:
    """Return prose of which every character is printed and none obeyed."""
    return prose.translate(_HTML)


def note_mark(mark: str, target: str = "") -> str:
    """Return a raised mark, with a link to its note if that has a name."""
    text = f"{escape(mark)})"
    return f'<sup><a href="#{escape(target)}">{text}</a></sup>' if target else f"<sup>{text}</sup>"


# Browsers break a line between a formula and a sign beside it, whatever the sign.
_BESIDE_FORMULA = re.compile(r"(?<![^\s<>])(?:[^\s<>]*<math.*?</math>)+[^\s<>]*")


def finish(label: str) -> str:
    """Return a label that was set, with every formula on one line with the signs that touch it."""
    return _BESIDE_FORMULA.sub(_kept, label)


def _kept(match: re.Match[str]) -> str:
    text = match[0]
    alone = text.startswith("<math") and text.endswith("</math>")
    return text if alone else f'<span class="kept">{text}</span>'
