"""Formats of pages by their names."""

from __future__ import annotations

from kurbel.formats.registry import PageFormat, by_name


def page_format(name: str) -> PageFormat:
    form = by_name(name)
    assert isinstance(form, PageFormat)
    return form
