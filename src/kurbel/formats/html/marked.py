"""Marked places in HTML."""

from __future__ import annotations

from kurbel.documents.inject import MARKUP_COMMENT, Kind
from kurbel.documents.inject_code import NoCode

KIND = Kind(
    name="HTML",
    suffixes=(".html", ".htm", ".xhtml"),
    left="<!--",
    right="-->",
    comment=MARKUP_COMMENT,
    code=NoCode,
)
