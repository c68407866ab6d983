"""What --columns can choose from, for the completion of shells."""

from __future__ import annotations

from kurbel.reading.given import File


def column_keys(name: str, folder: File | None = None) -> tuple[str, ...]:
    """Return the keys of the columns of a layout, and of others of its subject."""
    from kurbel.page.layouts import layout
    from kurbel.page.subject import subject

    page = layout(name, folder)
    return subject(page.subject).column_keys(page)
