"""Labels as words and formulas of a text."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from kurbel.documents import prose
from kurbel.exact.numerals import Label
from kurbel.page.labels import Mark, Prose, parse, primed


def inlines(label: Label) -> prose.Inlines:
    """Return a label as words and formulas of a text."""
    return tuple(_inlines(label))


def _inlines(label: Label) -> Iterator[prose.Inline]:
    for part in parse(label):
        if isinstance(part, Prose):
            yield prose.Text(primed(part.text))
        elif not isinstance(part, Mark):
            yield part


def text(words: str) -> prose.Paragraph:
    """Return words as a paragraph."""
    return prose.Paragraph((prose.Text(words),))


def parted(labels: Iterable[Label], by: str) -> prose.Inlines:
    """Return labels one behind another."""
    between = prose.Text(by)
    found = (one for label in labels for one in (between, *inlines(label)))
    return tuple(found)[1:]
