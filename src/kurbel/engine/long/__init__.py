"""Engines at very many crank angles: floats with bounds first, and balls for the doubtful cells."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from kurbel.engine.long.columns import LongColumns
    from kurbel.engine.request import EngineRequest
    from kurbel.page.table import Records


def long_columns(request: EngineRequest) -> LongColumns | None:
    """Return the columns in chunks, None where there is no NumPy or floats would settle too few digits."""
    from kurbel.motion.bulk import has_arrays

    if not has_arrays():
        return None
    from kurbel.engine.long.columns import LongColumns

    found = LongColumns(request)
    return found if found.is_worth() else None


def engine_records(request: EngineRequest) -> Records:
    """Return the records over the crank angle, in chunks where these are worth it."""
    from kurbel.page.build import records_of

    records = records_of(request)
    if request.long is None:
        return records
    from kurbel.engine.long.columns import EngineRows

    return records._replace(rows=EngineRows(request, [field.key for field in records.fields]))
