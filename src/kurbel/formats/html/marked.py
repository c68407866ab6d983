"""Marked places in HTML."""

from __future__ import annotations

from kurbel.documents.inject import MARKUP_COMMENT, Kind

KIND = Kind(
    name="HTML",
    suffixes=(".html", ".htm", ".xhtml"),
    left="<!--",
    right="-->",
    comment=MARKUP_COMMENT,
)
