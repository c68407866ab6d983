"""Workbooks of Excel."""

from kurbel.formats.registry import WorkbookFormat

FORMAT = WorkbookFormat(
    name="xlsx",
    rank=74,
    suffixes=(".xlsx",),
    media="a workbook of Excel: the page, and its values",
    figures="png",
)
