"""Pages and records over very many crank angles: floats with bounds first, balls for the doubtful cells."""

from __future__ import annotations

from pkgutil import resolve_name
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from kurbel.motion.long.columns import LongColumns
    from kurbel.page.subject import Question
    from kurbel.page.table import Records


def worthwhile(question: Question, columns: str) -> LongColumns | None:
    """Return the columns of a question, by the place of their class; None where there is no NumPy or floats
    would settle too few digits."""
    from kurbel.motion.bulk import has_arrays

    if not has_arrays():
        return None
    found: LongColumns = resolve_name(columns)(question)
    return found if found.is_worth() else None


def long_records(question: Question) -> Records:
    """Return the records over the crank angle, in chunks where these are worth it."""
    from kurbel.page.build import records_of

    records = records_of(question)
    if question.long is None:
        return records
    from kurbel.motion.long.columns import LongRows

    return records._replace(rows=LongRows(question, [field.key for field in records.fields]))
