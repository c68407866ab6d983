"""What --columns can choose from, for the completion of shells."""

from __future__ import annotations

from kurbel.reading.files import File


def column_keys(name: str, folder: File | None = None) -> tuple[str, ...]:
    """Return the keys of the columns of a layout, and of others of its subject."""
    from kurbel.page.layouts import layout

    page = layout(name, folder)
    from kurbel.page.subject import SUBJECTS, subject

    if page.subject in SUBJECTS:
        return subject(page.subject).column_keys(page)
    from kurbel.engine.request import engine_column_keys

    return engine_column_keys(page)
