"""The manifest that `kurbel handbook init` writes: it builds at once, and comments say what else there is."""

from __future__ import annotations

import os
from importlib.util import find_spec

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


def first_manifest(lang: str) -> str:
    """Return the text of a manifest in the language; what needs an extra that is missing is commented out."""
    plot, pdf = find_spec("matplotlib") is not None, find_spec("typst") is not None
    with open(os.path.join(os.path.dirname(__file__), "first_manifest.txt"), encoding="utf-8") as file:
        manifest = file.read()
    return manifest.format(
        lang=lang,
        pdf='"pdf", ' if pdf else "",
        pdf_hint="" if pdf else "# \"pdf\" needs the extra: pip install 'kurbel[pdf]'\n",
        hash="" if plot else "# ",
        figure_hint="" if plot else "\n# Drawings need the extra: pip install 'kurbel[plot]'",
        **_TEXTS[lang],
    )
