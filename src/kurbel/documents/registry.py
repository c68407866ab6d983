"""The formats that have whole documents of a handbook, and what makes them."""

from __future__ import annotations

from collections.abc import Mapping
from importlib import import_module
from typing import TYPE_CHECKING, cast

from kurbel.reading.choices import choose

if TYPE_CHECKING:
    from kurbel.documents.document import Document

# The module of each has a function `files` with the arguments of `document_files` but the format.
MODULES = {
    "latex": "kurbel.documents.latex",
    "markdown": "kurbel.documents.markdown",
    "html": "kurbel.documents.html",
    "typst": "kurbel.documents.typst",
}


def document_files(
    document: Document, format: str, fragments: Mapping[str, str], templates: str | None = None
) -> dict[str, str]:
    """Return the whole documents of a format as texts by their paths in the output folder.

    `fragments` has each table by its name, rendered in the format, and for HTML each figure as SVG;
    `templates` is a folder of the user's own templates. Raises KurbelError for a reference to nothing and
    for a template that cannot be used.
    """
    module = import_module(MODULES[choose(format, MODULES, "format of documents")])
    return cast("dict[str, str]", module.files(document, fragments, templates))
