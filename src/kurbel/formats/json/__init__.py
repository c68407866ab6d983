"""JSON: one object with columns and rows."""

from kurbel.formats.registry import RecordsFormat

FORMAT = RecordsFormat(
    name="json",
    rank=90,
    suffixes=(".json",),
    media="one object with columns and rows, for programs",
    decimal="point",
    legible=7,
    usual=True,
)
