"""The manifest that `kurbel handbook init` writes: it builds at once, and comments say what else there is."""

from __future__ import annotations

import os
from importlib.util import find_spec

from kurbel.errors import HandbookError, OutputError
from kurbel.formats.render import whole_file
from kurbel.handbook.manifest import NAME

_TEXTS = {
    "de": {
        "title": "Tafeln des Kurbeltriebs",
        "motion": "Kolbenbewegung",
        "intro": "Der Kolbenweg $x$ zählt vom Totpunkt. [](#kolbenbewegung) gilt für $R:L = 1:5$.",
        "table": "kolbenbewegung",
        "figure": "beschleunigung",
        "engine": "Dampfmaschine",
        "delta": "ungleichfoermigkeit",
        "books": "Bücher",
    },
    "en": {
        "title": "Tables of the crank drive",
        "motion": "Motion of the piston",
        "intro": "The piston's path $x$ counts from the dead centre. [](#motion) is for $R:L = 1:5$.",
        "table": "motion",
        "figure": "acceleration",
        "engine": "Steam engine",
        "delta": "irregularity",
        "books": "Books",
    },
}


def write_first_manifest(folder: str, lang: str) -> str:
    """Write a manifest in the language into a folder, which is made, and return its path."""
    path = os.path.join(folder, NAME)
    if os.path.lexists(path):
        raise HandbookError(f"{path} is there already; kurbel handbook build builds it")
    try:
        os.makedirs(folder, exist_ok=True)
    except OSError as error:
        raise OutputError(f"cannot make the folder {folder}: {error.strerror}") from error
    with whole_file(path) as stream:
        stream.write(first_manifest(lang).encode())
    return path


def first_manifest(lang: str) -> str:
    """Return the text of a manifest in the language; what needs an extra that is missing is commented out."""
    plot, pdf = find_spec("matplotlib") is not None, find_spec("typst") is not None
    with open(os.path.join(os.path.dirname(__file__), "first_manifest.txt"), encoding="utf-8") as file:
        manifest = file.read()
    return manifest.format(
        lang=lang,
        pdf='"pdf", ' if pdf else "",
        pdf_hint="" if pdf else "# \"pdf\" needs an extra; in kurbel's checkout: pip install '.[pdf]'\n",
        hash="" if plot else "# ",
        figure_hint="" if plot else "\n# Drawings need an extra; in kurbel's checkout: pip install '.[plot]'",
        **_TEXTS[lang],
    )
