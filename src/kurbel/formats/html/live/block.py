"""The block of an interactive page: its static table, what the script fills, and the data of all steps."""

from __future__ import annotations

import json
import re
from base64 import b64encode
from collections.abc import Callable, Mapping
from functools import cache
from hashlib import sha256
from typing import Any, NamedTuple

from kurbel.exact.numerals import Label, Number, number_text
from kurbel.formats.html.live.packing import SPACE, packed, separator_of, unpacked
from kurbel.formats.html.live.scenes import scenes_of
from kurbel.formats.writer import PageWriter
from kurbel.page.labels import plain, set_label
from kurbel.page.layouts import template_text
from kurbel.page.steps import Cursor, Slider, Steps
from kurbel.page.table import Table, Value

WORDS: Mapping[str, Mapping[str, str]] = {
    "de": {
        "choose": "Schritte wählen",
        "play": "Drehen",
        "stop": "Anhalten",
        "drawing": "Getriebe, maßstäblich",
        "undrawn": "Die Stange ist zu lang, um sie neben der Kurbel maßstäblich zu zeichnen.",
        "curve": "Verlauf",
    },
    "en": {
        "choose": "Choose steps",
        "play": "Turn",
        "stop": "Stop",
        "drawing": "Mechanism, to scale",
        "undrawn": "The rod is too long to be drawn to scale beside its crank.",
        "curve": "Curve",
    },
}
_REMARK = re.compile(r"\A\s*<!--.*?-->\n", re.DOTALL)
_PAGE = re.compile(r'(<div class="live-page">\n)(.*?)(</div>\n<script type="application/json" '
                   r'class="live-data">)(.*?)(</script>)', re.DOTALL)  # fmt: skip


class Live(NamedTuple):
    """The script of interactive pages, by what a page allows it, and their style: of tables ("live"), of
    drawings that move ("film"), or of both."""

    script: str
    allowed: str
    style: str


@cache
def live(kinds: tuple[str, ...]) -> Live:
    script, style = ("".join(template_text(f"{one}.{kind}") for one in kinds) for kind in ("js", "css"))
    script = f"\n{script}"
    return Live(script, f"sha256-{b64encode(sha256(script.encode()).digest()).decode()}", style)


def block(
    table: Table, fragment: str, page: Callable[[Table], str], writer: PageWriter, mark: str
) -> dict[str, Any]:
    """Return what the template of the block reads; `page` sets the table of a step."""
    steps = table.steps
    assert steps is not None
    setter = Setter(writer, mark)
    data = setter.data(steps, page)
    remark = _REMARK.match(fragment)
    return dict(
        remark=remark[0] if remark else "",
        fragment=_REMARK.sub("", fragment),
        key=f"live-{table.anchor}",
        lang=table.lang,
        words=WORDS[table.lang],
        sliders=[setter.slider(one) for one in steps.sliders],
        cursor=setter.cursor(steps.cursor) if steps.cursor else None,
        quantities=[tuple(map(setter.label, one)) for one in steps.columns],
        drawn=any(move is not None for move in data["moves"]),
        data=as_json(data),
    )


def finished(page: str, change: Callable[[str], str]) -> str:
    """Return a text with such blocks of which every table, shown or not, was changed."""

    def changed(match: re.Match[str]) -> str:
        before, fragment, between, text, after = match.groups()
        data = json.loads(text)
        data["pages"] = packed([change(one) for one in unpacked(data["pages"])])
        return f"{before}{change(fragment)}{between}{as_json(data)}{after}"

    return _PAGE.sub(changed, page)


def as_json(data: Mapping[str, Any]) -> str:
    # Nothing in it ends the script.
    text = json.dumps(data, ensure_ascii=False, separators=(",", ":"))
    return text.replace("<", "\\u003c").replace("\u2028", "\\u2028").replace("\u2029", "\\u2029")


class Setter:
    """Sets what stands around the table, in HTML with a decimal mark."""

    def __init__(self, writer: PageWriter, mark: str) -> None:
        self.writer, self.mark = writer, mark

    def label(self, label: Label) -> str:
        writer = self.writer
        text = set_label(
            label, writer.escape, lambda formula: writer.formula(formula, self.mark), lambda note: ""
        )
        return writer.finish(text)

    def plain(self, label: Label) -> str:
        return plain(label, self.mark)

    def slider(self, one: Slider) -> dict[str, Any]:
        return {
            "key": one.key, "label": self.label(one.label), "last": len(one.steps) - 1, "start": one.start,
            "text": self.writer.escape(self.plain(one.steps[one.start])),
        }  # fmt: skip

    def cursor(self, one: Cursor) -> dict[str, Any]:
        text = self.plain(one.places[one.start].label) + one.unit
        return {
            "key": one.key, "label": self.label(one.label), "last": len(one.places) - 1, "start": one.start,
            "text": self.writer.escape(text), "turn": one.turn,
        }  # fmt: skip

    def data(self, steps: Steps, page: Callable[[Table], str]) -> dict[str, Any]:
        """Return what the script reads; the steps are made one after the other."""
        made = (
            (
                _REMARK.sub("", page(one.table)),
                self.plain(one.table.caption),
                one.tracks,
                one.units,
                one.scene,
            )
            for one in steps
        )
        pages, titles, of_steps, units, scenes = zip(*made, strict=True)
        known_units = list(dict.fromkeys(units))
        texts = [[*map(self.value, track)] for tracks in of_steps for track in tracks]
        separator = separator_of(text for track in texts for text in track)
        joined = [separator.join(track) for track in texts]
        known = {text: number for number, text in enumerate(dict.fromkeys(joined))}
        count = len(steps.columns)
        of = [known[text] for text in joined]
        cursor = steps.cursor
        return {
            "sizes": [len(one.steps) for one in steps.sliders],
            "keys": [one.key for one in steps.sliders],
            "texts": [[self.plain(step) for step in one.steps] for one in steps.sliders],
            "start": steps.start,
            "cursor": None if cursor is None else {
                "key": cursor.key, "unit": cursor.unit, "turn": cursor.turn, "zero": cursor.zero,
                "texts": [self.plain(place.label) for place in cursor.places],
                "at": [place.at for place in cursor.places],
                "rows": [place.row for place in cursor.places],
                "columns": [place.column for place in cursor.places],
            },
            "titles": packed(titles, SPACE),
            "pages": packed(pages),
            "by": separator,
            "tracks": list(known),
            "of": [of[place : place + count] for place in range(0, len(of), count)] if count else [],
            "units": [[self.unit(one) for one in own] for own in known_units],
            "measured": [known_units.index(own) for own in units],
            **scenes_of(scenes),
        }  # fmt: skip

    def unit(self, label: Label) -> str:
        """Return a unit as it stands behind a figure."""
        return self.label(label) if label in ("", "°") else f" {self.label(label)}"

    def value(self, value: Value) -> str:
        if isinstance(value, Number):
            return number_text(value, self.mark, self.writer.minus)
        return self.plain(value or "")
