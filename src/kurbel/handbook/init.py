"""The manifest that `kurbel handbook init` writes: it builds at once, and comments say what else there is."""

from __future__ import annotations

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

_MANIFEST = '''\
# A handbook of kurbel. Build it with: kurbel handbook build
# `kurbel handbook check` tells in CI whether what was built is what this file says.

title = "{title}"
# subtitle = "..."
# author = "..."
lang = "{lang}"                 # de or en
# decimal = "point"         # comma or point; by default that of the language
formats = ["html", "latex", "markdown", {pdf}"typst", "csv", "json"]
output = "pages"            # a folder beside this file
# machine = "engine.toml"   # a machine for all commands that take --machine
# templates = "mine/"       # templates of your own, such as mine/base/html.jinja
{pdf_hint}
# [pdf]
# engine = "typst"          # or lualatex or latexmk, with a TeX
# standards = ["a-2b"]      # PDF/A for archives; "ua-1" for readers who do not see it

# Options for all commands that have them; a chapter may have defaults of its own.
[defaults]
ratio = "1:5"
# digits = 4

[[chapter]]
title = "{motion}"

# A text in Markdown, with formulas between dollar signs and references to tables.
[[chapter.part]]
text = """
{intro}
"""

# What you would type after `kurbel`. The name is that of its files and, behind tab: or fig:, its label.
[[chapter.part]]
run = "table --step 15 --to 180"
name = "{table}"
{figure_hint}
{hash}[[chapter.part]]
{hash}run = "plot --columns p"
{hash}name = "{figure}"

[[chapter]]
title = "{engine}"
# [chapter.defaults]
# digits = 3

[[chapter.part]]
run = "delta --eps 2..6"
name = "{delta}"
# caption = "..."           # in place of the command's own
# lang = "en"

[[chapter]]
title = "{books}"

# Worked examples of the books, and their printed values held against recomputed ones.
[[chapter.part]]
run = "example blau 33"

[[chapter.part]]
run = "collate weisbach-149"
'''


def first_manifest(lang: str) -> str:
    """Return the text of a manifest in the language; what needs an extra that is missing is commented out."""
    plot, pdf = find_spec("matplotlib") is not None, find_spec("typst") is not None
    return _MANIFEST.format(
        lang=lang,
        pdf='"pdf", ' if pdf else "",
        pdf_hint="" if pdf else "# \"pdf\" needs the extra: pip install 'kurbel[pdf]'\n",
        hash="" if plot else "# ",
        figure_hint="" if plot else "\n# Drawings need the extra: pip install 'kurbel[plot]'",
        **_TEXTS[lang],
    )
