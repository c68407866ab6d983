"""What the package has made ahead says the same as what it was made of."""

from __future__ import annotations

import tomllib
from pathlib import Path
from zlib import crc32

import pytest
from everything import everything, tall, wide

from kurbel.formats import filling
from kurbel.formats.registry import FORMATS, PageFormat
from kurbel.formats.render import render
from kurbel.page.ahead import LAYOUTS
from kurbel.page.layouts import layout_file, layout_names, template_folder

SET = [form.name for form in FORMATS.values() if isinstance(form, PageFormat) and form.name != "text"]


def test_every_layout_was_read_ahead_and_no_other() -> None:
    texts = [Path(str(layout_file(template_folder(), name))).read_bytes() for name in layout_names()]
    assert {crc32(text): tomllib.loads(text.decode()) for text in texts} == LAYOUTS, "run make docs"


@pytest.mark.parametrize("name", SET)
def test_a_template_compiled_ahead_sets_what_jinja_makes_of_it(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    pages = [(page, breaks) for page in (everything(), wide(4), tall()) for breaks in (False, True)]
    ahead = [render(page, name, longtable=breaks) for page, breaks in pages]
    asked = []
    monkeypatch.setattr(filling, "filled", lambda *given: asked.append(given))
    assert ahead == [render(page, name, longtable=breaks) for page, breaks in pages]
    assert len(asked) == len(pages)
