"""CSV: one record a line."""

from kurbel.formats.registry import RecordsFormat

FORMAT = RecordsFormat(
    name="csv",
    rank=80,
    suffixes=(".csv",),
    media="one record a line, for spreadsheets",
    decimal="point",
    legible=1,
    usual=True,
    takes=("excel",),
)
