"""A drawing that is made step by step as one HTML page: its steps are clicked through, its table is below.

Without a script, and on paper, the whole drawing stands beside the list of its steps.
"""

from __future__ import annotations

import re
from base64 import b64encode
from collections.abc import Mapping, Sequence
from dataclasses import replace
from hashlib import sha256

from kurbel.exact.numerals import Label
from kurbel.formats.html.svg import inline
from kurbel.formats.html.writer import panelled
from kurbel.formats.registry import PageFormat, by_name
from kurbel.formats.render import render, render_document
from kurbel.page.labels import plain, set_label
from kurbel.page.layouts import template_text
from kurbel.page.table import Table

WORDS: Mapping[str, Mapping[str, str]] = {
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
_GROUP = re.compile(r'<g id="([^"]+)">')


def lesson(
    svg: str, parts: Mapping[str, int], steps: Sequence[Label], table: Table, decimal: str | None
) -> str:
    """Return the page of a drawing whose parts have ids in its SVG file, each with the number of its step.

    `table` is what stands below; its caption is the title of the page.
    """
    form = by_name("html")
    assert isinstance(form, PageFormat)
    writer, mark = form.writer, form.decimal_mark(table.lang, decimal)

    def set_text(label: Label) -> str:
        formula = set_label(label, writer.escape, lambda one: writer.formula(one, mark), lambda note: "")
        return writer.finish(formula)

    title, words = plain(table.caption, mark), WORDS[table.lang]
    script, style = ("\n" + template_text(f"lesson.{kind}") for kind in ("js", "css"))
    values = {
        "lang": table.lang,
        "words": words,
        "title": writer.escape(title),
        "heading": set_text(table.caption),
        "drawing": inline(_numbered(svg, parts), "drawing", title, own_page=True),
        "steps": [set_text(one) for one in steps],
        "table": panelled(render(replace(table, caption=words["lengths"]), "html", decimal=decimal)),
        "style": style,
        "script": script,
        "allowed": f"sha256-{b64encode(sha256(script.encode()).digest()).decode()}",
    }
    return render_document(form, "lesson", values)


def _numbered(svg: str, parts: Mapping[str, int]) -> str:
    """Return the drawing whose parts say their steps."""

    def numbered(found: re.Match[str]) -> str:
        step = parts.get(found[1])
        return f'{found[0][:-1]} data-step="{step}">' if step else found[0]

    return _GROUP.sub(numbered, svg)
