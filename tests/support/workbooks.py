"""Workbooks as they are in their files: what each cell holds, by its sheet, row and column."""

from __future__ import annotations

import io
import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any
from xml.etree.ElementTree import Element, fromstring
from zipfile import ZipFile

S = "{http://schemas.openxmlformats.org/spreadsheetml/2006/main}"
R = "{http://schemas.openxmlformats.org/officeDocument/2006/relationships}"
TABLE, OFFICE, TEXT, STYLE, NUMBER = (
    f"{{urn:oasis:names:tc:opendocument:xmlns:{name}:1.0}}"
    for name in ("table", "office", "text", "style", "datastyle")
)
Place = tuple[int, int]


@dataclass
class Read:
    """A sheet: its cells with anything in them, their number formats, and how many cells each covers."""

    values: dict[Place, float | str] = field(default_factory=dict)
    formats: dict[Place, str] = field(default_factory=dict)
    spans: dict[Place, Place] = field(default_factory=dict)
    formulas: int = 0
    slanted: set[Place] = field(default_factory=set)
    lowered: set[Place] = field(default_factory=set)
    centred: set[Place] = field(default_factory=set)

    def row(self, number: int) -> list[float | str]:
        return [value for (row, _), value in sorted(self.values.items()) if row == number]


def xlsx_sheets(content: bytes) -> dict[str, Read]:
    """Return the sheets of a workbook of Excel by their names."""
    with ZipFile(io.BytesIO(content)) as file:
        texts = [_letters(one, S) for one in _part(file, "xl/sharedStrings.xml")]
        styles = _part(file, "xl/styles.xml")
        formats, centred = [*_formats(styles)], [*_centred(styles)]
        slanted, lowered = [*_with_fonts(styles, "i")], [*_with_fonts(styles, "vertAlign")]
        names = [str(one.get("name")) for one in _part(file, "xl/workbook.xml").iter(f"{S}sheet")]
        sheets = {}
        for number, name in enumerate(names, 1):
            root, read = _part(file, f"xl/worksheets/sheet{number}.xml"), Read()
            for cell in root.iter(f"{S}c"):
                _read_cell(cell, texts, formats, read)
                for places, has in (
                    (read.slanted, slanted), (read.lowered, lowered), (read.centred, centred)
                ):  # fmt: skip
                    if has[int(cell.get("s", 0))]:
                        places.add(_place(str(cell.get("r"))))
            for merged in root.iter(f"{S}mergeCell"):
                first, last = map(_place, str(merged.get("ref")).split(":"))
                read.spans[first] = last[0] - first[0] + 1, last[1] - first[1] + 1
            sheets[name] = read
    return sheets


def _read_cell(cell: Element, texts: list[str], formats: list[str], read: Read) -> None:
    place, value = _place(str(cell.get("r"))), cell.find(f"{S}v")
    read.formulas += cell.find(f"{S}f") is not None
    if value is not None and value.text:
        read.values[place] = texts[int(value.text)] if cell.get("t") == "s" else float(value.text)
        read.formats[place] = formats[int(cell.get("s", 0))]


def _formats(styles: Element) -> Iterator[str]:
    own = {one.get("numFmtId"): str(one.get("formatCode")) for one in styles.iter(f"{S}numFmt")}
    known = {"0": "General", "1": "0", "2": "0.00", "49": "@"}
    used = styles.find(f"{S}cellXfs")
    assert used is not None
    for one in used:
        yield own.get(one.get("numFmtId")) or known[str(one.get("numFmtId"))]


def _with_fonts(styles: Element, mark: str) -> Iterator[bool]:
    fonts, used = styles.find(f"{S}fonts"), styles.find(f"{S}cellXfs")
    assert fonts is not None
    assert used is not None
    for one in used:
        yield fonts[int(one.get("fontId", 0))].find(f"{S}{mark}") is not None


def _centred(styles: Element) -> Iterator[bool]:
    used = styles.find(f"{S}cellXfs")
    assert used is not None
    for one in used:
        place = one.find(f"{S}alignment")
        yield place is not None and place.get("horizontal") == "center"


def ods_sheets(content: bytes) -> dict[str, Read]:
    """Return the sheets of a workbook as OpenDocument by their names."""
    with ZipFile(io.BytesIO(content)) as file:
        root = _part(file, "content.xml")
    formats = {
        str(one.get(f"{STYLE}name")): str(one.get(f"{STYLE}data-style-name"))
        for one in root.iter(f"{STYLE}style")
    }
    return {str(one.get(f"{TABLE}name")): _read_table(one, formats) for one in root.iter(f"{TABLE}table")}


def _read_table(table: Element, formats: dict[str, str]) -> Read:
    read = Read()
    for row, cells in enumerate(table.iter(f"{TABLE}table-row")):
        column = 0
        for cell in cells:
            kind = cell.get(f"{OFFICE}value-type")
            if kind:
                lines = "\n".join(_letters(one) for one in cell.iter(f"{TEXT}p"))
                value = cell.get(f"{OFFICE}value")
                read.values[row, column] = lines if value is None else float(value)
                read.formats[row, column] = formats[str(cell.get(f"{TABLE}style-name"))]
            down, across = (int(cell.get(f"{TABLE}number-{way}-spanned", 1)) for way in ("rows", "columns"))
            if (down, across) != (1, 1):
                read.spans[row, column] = down, across
            read.formulas += cell.get(f"{TABLE}formula") is not None
            column += int(cell.get(f"{TABLE}number-columns-repeated", 1))
    return read


def sheets_of(content: bytes) -> dict[str, Read]:
    """Return the sheets of a workbook in either format."""
    with ZipFile(io.BytesIO(content)) as file:
        own = "mimetype" in file.namelist()
    return ods_sheets(content) if own else xlsx_sheets(content)


def _part(file: ZipFile, name: str) -> Element:
    return fromstring(file.read(name))


def _letters(element: Element, space: str = "") -> str:
    found: Any = element.iter(f"{space}t") if space else [element]
    return "".join("".join(one.itertext()) for one in found)


def _place(address: str) -> Place:
    letters, digits = re.fullmatch("([A-Z]+)([0-9]+)", address).groups()  # type: ignore[union-attr]
    column = 0
    for letter in letters:
        column = 26 * column + ord(letter) - ord("A") + 1
    return int(digits) - 1, column - 1
