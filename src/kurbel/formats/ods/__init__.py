"""Workbooks of LibreOffice and other programs that keep to OpenDocument."""

from kurbel.formats.registry import WorkbookFormat

FORMAT = WorkbookFormat(
    name="ods",
    rank=76,
    suffixes=(".ods",),
    media="the same as OpenDocument, for LibreOffice",
    figures="png",
)
