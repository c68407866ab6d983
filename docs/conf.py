"""The site of the documentation: Markdown by MyST, set by the theme of NumPy, SciPy and pandas.

pydata-sphinx-theme, for its bar of sections at the top, its menus for keyboard and telephone, its own dark
colours, and the axe tests that it runs on itself; it brings its icons along. furo has no bar at the top.
"""

from __future__ import annotations

from pathlib import Path

from docutils import nodes
from sphinx.application import Sphinx

import kurbel
from kurbel.cli import COMMANDS

project = "kurbel"
version = release = kurbel.__version__
copyright = "the authors of kurbel"
language = "en"

extensions = ["myst_parser", "sphinx.ext.viewcode", "sphinx_copybutton", "sphinx_design"]
exclude_patterns = ["developers/_*"]
# Types that are not ours have no page here.
nitpick_ignore_regex = [("py:class", r"(?!kurbel\.).*")]
# `--eps` is no dash.
smartquotes = False

myst_enable_extensions = ["attrs_block", "attrs_inline", "colon_fence", "fieldlist"]
myst_heading_anchors = 4

html_theme = "pydata_sphinx_theme"
html_title = "kurbel"
html_favicon = "_static/logo-light.svg"
# The search finds what an index would list.
html_use_index = html_domain_indices = False
templates_path = ["_templates"]
html_static_path = ["_static"]
html_css_files = ["kurbel.css"]
html_search_scorer = str(Path(__file__).parent / "_static" / "search.js")
html_copy_source = False
html_show_sourcelink = False
html_last_updated_fmt = None
html_context = {"default_mode": "auto"}
html_theme_options = {
    "logo": {
        "text": "kurbel",
        "alt_text": "kurbel, to the first page",
        "image_light": "_static/logo-light.svg",
        "image_dark": "_static/logo-dark.svg",
    },
    "collapse_navigation": True,
    "navbar_align": "left",
    "header_links_before_dropdown": 6,
    "show_prev_next": True,
    "footer_start": [],
    "footer_end": [],
}
# Pages without pages below them have nothing to list at their left.
html_sidebars: dict[str, list[str]] = {
    name: [] for name in ("index", "tutorial", "anleitung", "digits", "changes", "playground")
}
copybutton_prompt_text = "$ "
copybutton_only_copy_prompt_lines = True

_COMMANDS, _FILES = "reference/command-line", "reference/files"
man_pages: list[tuple[str, str, str, list[str], int]] = [
    (f"{_COMMANDS}/kurbel", "kurbel", "certified tables of the crank drive", [], 1),
    *((f"{_COMMANDS}/{name}", f"kurbel-{name}", line, [], 1) for name, (_, line) in COMMANDS.items()),
    (f"{_FILES}/machine", "kurbel-machine.toml", "a machine, for --machine of every command", [], 5),
    (f"{_FILES}/layout", "kurbel-layout.toml", "a page layout of one's own, for --layouts", [], 5),
    (f"{_FILES}/sweep", "kurbel-sweep.toml", "a sweep, for kurbel sweep", [], 5),
    (f"{_FILES}/handbook", "kurbel-handbook.toml", "the manifest of a handbook", [], 5),
]
man_make_section_directory = True


def setup(app: Sphinx) -> None:
    app.connect("doctree-read", _with_dashes)
    app.connect("doctree-read", _in_its_language)
    app.connect("doctree-resolved", _without_links)


def _with_dashes(app: Sphinx, page: nodes.document) -> None:
    """Set the dash behind the name of a parameter, which Sphinx leaves to the quotes that are not wanted."""
    for text in page.findall(nodes.Text):
        if text == " -- ":
            text.parent.replace(text, nodes.Text(" – "))


def _in_its_language(app: Sphinx, page: nodes.document) -> None:
    """Tell readers that speak which page is German: docutils makes an attribute `lang` of the class."""
    if app.env.docname == "anleitung":
        for section in page.findall(nodes.section):
            section["classes"].append("language-de")
            break


def _without_links(app: Sphinx, page: nodes.document, name: str) -> None:
    """Leave the words of a manual page that link to other pages, where Sphinx would set <> behind them."""
    if app.builder.name == "man":
        for link in [*page.findall(nodes.reference)]:
            if link.get("internal"):
                link.replace_self(link.children)
