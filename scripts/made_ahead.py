"""Write what the package has made ahead, so that no start has to: layouts that were read, templates compiled.

python scripts/made_ahead.py

Each is found by the checksum of the file that it was made of: one that was changed since is read as those of
users are, which takes a start some milliseconds more.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator
from pathlib import Path
from zlib import crc32

import kurbel
from kurbel.formats.filling import FILTERS
from kurbel.formats.registry import FORMATS, PageFormat
from kurbel.formats.render import environment_of
from kurbel.page.layouts import layout_file, layout_names, template_folder

PACKAGE = Path(kurbel.__file__).parent
RUNTIME = ("LoopContext", "Macro", "Markup", "Undefined", "identity", "missing", "str_join")
HEAD = '''"""Made of {of} by scripts/made_ahead.py, by the checksums of their files; not to be edited."""

{body}'''
_LAYOUTS = """from collections.abc import Mapping
from typing import Any

LAYOUTS: Mapping[int, Mapping[str, Any]] = {"""
# What Jinja's compiler writes around a template, and what stands here in its place.
_BEFORE = re.compile(r".*?\ndef root\(context, missing=missing, environment=environment\):\n", re.DOTALL)
_AFTER = re.compile(r"\nblocks = \{\}\ndebug_info = .*", re.DOTALL)
_FILTER = re.compile(
    r"    try:\n        (t_\d+ = environment\.filters\['(\w+)'\])\n    except KeyError:\n(?: {8}.*\n){3}"
)


def main() -> None:
    for path, text in made().items():
        path.write_text(text, encoding="utf-8")


def made() -> dict[Path, str]:
    """Return the modules by their files."""
    return {PACKAGE / "page" / "ahead.py": layouts(), **dict(templates())}


def layouts() -> str:
    """Return the module of all layouts."""
    folder = template_folder()
    read = {name: Path(str(layout_file(folder, name))).read_bytes() for name in layout_names()}
    lines = (f"    {crc32(text)}: {tomllib.loads(text.decode())!r}," for text in read.values())
    return HEAD.format(of="the layouts", body="\n".join([_LAYOUTS, *lines, "}", ""]))


def templates() -> Iterator[tuple[Path, str]]:
    """Yield the modules of the formats whose pages are set by a template."""
    for form in FORMATS.values():
        if isinstance(form, PageFormat) and (file := page_template(form)).exists():
            runtime = f"from kurbel.formats.filling import {', '.join(RUNTIME)}"
            known = f"TEMPLATES = {{{crc32(file.read_bytes())}: root}}\n"
            body = "\n\n".join((f"# mypy: ignore-errors\n{runtime}\n", compiled(form, file), known))
            yield PACKAGE / "formats" / form.name / "ahead.py", HEAD.format(of="the template", body=body)


def page_template(form: PageFormat) -> Path:
    """Return the file of the template of a format's pages."""
    return Path(form.templates) / f"{form.name}.jinja"


def compiled(form: PageFormat, file: Path) -> str:
    """Return the function that Jinja's compiler makes of a template.

    Raises TemplateSyntaxError for a filter that neither the format has nor `filling`.
    """
    environment = environment_of(form, None).overlay()
    # Jinja's own would be called with more than the values.
    environment.filters = {**FILTERS, **form.writer.filters()}
    code = environment.compile(file.read_text(encoding="utf-8"), f"base/{file.name}", raw=True)
    body = _AFTER.sub("", _BEFORE.sub("", code, count=1))
    body = _FILTER.sub(r"    \1\n", body)
    return f"def root(context, environment):\n{body.rstrip()}\n"


if __name__ == "__main__":
    main()
