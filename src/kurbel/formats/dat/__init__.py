"""Columns of numbers, for programs that plot."""

from kurbel.formats.registry import RecordsFormat

FORMAT = RecordsFormat(
    name="dat",
    rank=85,
    suffixes=(".dat",),
    media="columns of numbers, for pgfplots and gnuplot",
    decimal="point",
)
