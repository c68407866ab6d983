"""Pages of ours with a script: tables whose steps are chosen, drawings that move, and drawings that are made
step by step, with the data of all steps, kept short. Without a script, and on paper, all stands there too."""

from __future__ import annotations

import json
import re
from base64 import b64encode
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from functools import cache
from hashlib import sha256
from typing import Any, NamedTuple

from kurbel.exact.numerals import Label, Number, number_text
from kurbel.formats.html import FORMAT
from kurbel.formats.html.document import inline
from kurbel.formats.html.writer import RUNS
from kurbel.formats.registry import PageFormat, by_name
from kurbel.formats.render import render, render_document
from kurbel.formats.writer import PageWriter
from kurbel.page.axes import PHI
from kurbel.page.labels import plain
from kurbel.page.layouts import template_text
from kurbel.page.steps import Cursor, Joint, Point, Scene, Slider, Steps
from kurbel.page.table import Table, Value

# Where pages are cut, and lines of words.
TAG, SPACE = re.compile(r"(<[^>]*>)"), re.compile(r"( )")
# The first of these that no text has parts texts in one string.
_SEPARATORS = ("|", "~", "^", "¦", "\t")


def packed(pages: Sequence[str], cut: re.Pattern[str] = TAG) -> dict[str, Any]:
    """Return the pages for JSON; pieces of them begin and end where they are `cut`.

    In `shapes` texts and numbers of gaps alternate; every page has one, of a kind, and a text of what stands
    in its gaps, joined by `by`.
    """
    tokens = [cut.split(page) for page in pages]
    separator = separator_of(token for page in tokens for token in page)
    lengths = list(dict.fromkeys(map(len, tokens)))
    shapes, texts = [], [""] * len(pages)
    for length in lengths:
        alike = [number for number, page in enumerate(tokens) if len(page) == length]
        shape, own = _shaped([tokens[number] for number in alike])
        shapes.append(shape)
        for number, values in zip(alike, own, strict=True):
            texts[number] = separator.join(values)
    kinds = [lengths.index(len(page)) for page in tokens]
    return {"by": separator, "shapes": shapes, "kinds": kinds, "texts": texts}


def _shaped(pages: Sequence[Sequence[str]]) -> tuple[list[str | int], list[list[str]]]:
    """Return what pages of as many pieces have in common, with gaps, and of each what fills these.

    Pieces that are alike on every page, as of a table that stands there twice, share a gap.
    """
    shape: list[str | int] = []
    gaps: dict[tuple[str, ...], int] = {}
    for pieces in zip(*pages, strict=True):
        if len(set(pieces)) > 1:
            shape.append(gaps.setdefault(pieces, len(gaps)))
        elif shape and isinstance(shape[-1], str):
            shape[-1] += pieces[0]
        else:
            shape.append(pieces[0])
    return shape, [list(own) for own in zip(*gaps, strict=True)] or [[] for _ in pages]


def separator_of(texts: Iterable[str]) -> str:
    """Return what parts these texts in one string."""
    letters = set("".join(texts))
    return next(one for one in (*_SEPARATORS, *map(chr, range(0xE000, 0xF8FF))) if one not in letters)


def scenes_of(scenes: Sequence[Scene | None]) -> dict[str, object]:
    """Return the joints that scenes have in common, each scene once, and which one each step has."""
    known = list(dict.fromkeys(scene for scene in scenes if scene is not None))
    joints: dict[Joint, int] = {}
    told = [_scene(scene, joints) for scene in known]
    return {
        "joints": [_flat(joint) for joint in joints],
        "scenes": told,
        "moves": [None if scene is None else known.index(scene) for scene in scenes],
    }


def _scene(scene: Scene, joints: dict[Joint, int]) -> dict[str, object]:
    def named(joint: Joint) -> int:
        return joints.setdefault(joint, len(joints))

    return {
        "box": _flat((scene.low, scene.high)),
        "fixed": [[line.kind, *_flat(line.points)] for line in scene.fixed],
        "links": [[link.kind, named(link.start), named(link.end), link.letter] for link in scene.links],
        "pins": [named(pin) for pin in scene.pins],
        "heads": [named(head) for head in scene.heads],
        "path": None if scene.path is None else _flat((scene.path,)),
    }


def _flat(points: Iterable[Point]) -> list[int]:
    return [round(1000 * one) for point in points for one in point]


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
) -> dict[str, object]:
    """Return what the template of the block reads; `page` sets the table of a step."""
    steps = table.steps
    assert steps is not None
    setter = Setter(writer, mark)
    data = setter.data(steps, page)
    return dict(
        fragment=fragment,
        key=f"live-{table.anchor}",
        lang=table.lang,
        words=WORDS[table.lang],
        sliders=[setter.slider(one) for one in steps.sliders],
        cursor=setter.cursor(steps.cursor) if steps.cursor else None,
        quantities=[tuple(map(setter.label, one)) for one in steps.columns],
        drawn=any(move is not None for move in data["moves"]),
        data=as_json(data),
    )


def as_json(data: Mapping[str, Any]) -> str:
    # Nothing in it ends the script.
    text = json.dumps(data, ensure_ascii=False, separators=(",", ":"))
    return text.replace("<", "\\u003c").replace("\u2028", "\\u2028").replace("\u2029", "\\u2029")


class Setter:
    """Sets what stands around the table, in HTML with a decimal mark."""

    def __init__(self, writer: PageWriter, mark: str) -> None:
        self.writer, self.mark = writer, mark

    def label(self, label: Label) -> str:
        return self.writer.label(label, self.mark)

    def plain(self, label: Label) -> str:
        return plain(label, self.mark)

    def slider(self, one: Slider) -> dict[str, object]:
        return {
            "key": one.key, "label": self.label(one.label), "last": len(one.steps) - 1, "start": one.start,
            "text": self.writer.escape(self.plain(one.steps[one.start])),
        }  # fmt: skip

    def cursor(self, one: Cursor) -> dict[str, object]:
        text = self.plain(one.places[one.start].label) + one.unit
        return {
            "key": one.key, "label": self.label(one.label), "last": len(one.places) - 1, "start": one.start,
            "text": self.writer.escape(text), "turn": one.turn,
        }  # fmt: skip

    def data(self, steps: Steps, page: Callable[[Table], str]) -> dict[str, Any]:
        """Return what the script reads; the steps are made one after the other."""
        made = (
            (
                page(one.table),
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


# What the file of a drawing that moves says of its run: first and last angle, that of the start, seconds.
RUN = re.compile(RUNS + r'([^"]*)"')
FILM_WORDS: Mapping[str, Mapping[str, str]] = {
    "de": {"choose": "Kurbelwinkel wählen", "numbers": "Werte beim Kurbelwinkel"},
    "en": {"choose": "Choose the crank angle", "numbers": "Values at the crank angle"},
}
KEY = "film"
# A name, a symbol, a unit, and the numbers at each degree.
Spoken = tuple[Label, Label, Label, tuple[Value, ...]]


def film_page(svg: str, title: Label, lang: str, mark: str, spoken: Sequence[Spoken]) -> str:
    """Return a page of its own: the drawing, its slider, and the printed numbers at each degree."""
    writer = FORMAT.writer
    said = writer.escape(plain(title, mark))
    drawing = film_block(svg, KEY, plain(title, mark), lang, mark, spoken)
    values = {"page": {"lang": lang, "key": KEY}, "title": said, "fragment": drawing}
    return render_document(FORMAT, "film", values)


def film_block(svg: str, name: str, title: str, lang: str, mark: str, spoken: Sequence[Spoken] = ()) -> str:
    """Return the drawing of a file that moves as part of a page of ours, with what leads it."""
    found = RUN.search(svg)
    assert found is not None
    first, last, start, seconds = map(float, found[1].split())
    setter = Setter(FORMAT.writer, mark)
    columns = [[setter.value(value) for value in values] for *_, values in spoken]
    data = {"first": first, "last": last, "start": start, "seconds": seconds, "mark": mark, "values": columns}
    values = {
        "key": name, "lang": lang, "words": {**WORDS[lang], **FILM_WORDS[lang]},
        "label": f"{PHI[lang]} {setter.label('$φ$')}",
        "first": f"{first:g}", "last": f"{last:g}", "start": f"{start:g}",
        "quantities": [
            (setter.label(said), setter.label(symbol), setter.unit(unit)) for said, symbol, unit, _ in spoken
        ],
        "drawing": inline(svg, name, title, own_page=True),
        "data": as_json(data),
    }  # fmt: skip
    return render_document(FORMAT, "film.block", values)


LESSON_WORDS: Mapping[str, Mapping[str, str]] = {
    "de": {
        "steps": "Schritte",
        "start": "Anfang",
        "back": "Zurück",
        "next": "Weiter",
        "all": "Alles",
        "lengths": "Strecken der Zeichnung",
        "keys": "Tasten ← und →",
        "of": "Schritt {} von {}",
        "whole": "Alle {} Schritte",
    },
    "en": {
        "steps": "Steps",
        "start": "Start",
        "back": "Back",
        "next": "Next",
        "all": "All",
        "lengths": "Lengths of the drawing",
        "keys": "Keys ← and →",
        "of": "Step {} of {}",
        "whole": "All {} steps",
    },
}


def lesson(
    svg: str, step: Callable[[str], int], steps: Sequence[Label], table: Table, decimal: str | None
) -> str:
    """Return the page of a drawing; `step` says the number of the step of a part by its id in the SVG file.

    `table` is what stands below; its caption is the title of the page.
    """
    form = by_name("html")
    assert isinstance(form, PageFormat)
    writer, mark = form.writer, form.decimal_mark(table.lang, decimal)

    title, words = plain(table.caption, mark), LESSON_WORDS[table.lang]
    script, style = ("\n" + template_text(f"lesson.{kind}") for kind in ("js", "css"))
    values = {
        "lang": table.lang,
        "words": words,
        "title": writer.escape(title),
        "heading": writer.label(table.caption, mark),
        "drawing": inline(svg, "drawing", title, own_page=True, step=step),
        "steps": [writer.label(one, mark) for one in steps],
        "table": render(replace(table, caption=words["lengths"]), "html", decimal=decimal, place="document"),
        "style": style,
        "script": script,
        "allowed": f"sha256-{b64encode(sha256(script.encode()).digest()).decode()}",
    }
    return render_document(form, "lesson", values)
