"""The site of the documentation: Markdown by MyST, set by the theme of NumPy, SciPy and pandas.

pydata-sphinx-theme, for its bar of sections at the top, its menus for keyboard and telephone, its own dark
colours, and the axe tests that it runs on itself; it brings its icons along. furo has no bar at the top.
"""

from __future__ import annotations

import kurbel

project = "kurbel"
version = release = kurbel.__version__
copyright = "the authors of kurbel"
language = "en"

extensions = ["myst_parser", "sphinx_copybutton", "sphinx_design"]
exclude_patterns = ["developers/_*"]
nitpicky = True

myst_enable_extensions = ["attrs_block", "attrs_inline", "colon_fence", "deflist"]
myst_heading_anchors = 4

html_theme = "pydata_sphinx_theme"
html_title = "kurbel"
html_copy_source = False
html_show_sourcelink = False
html_last_updated_fmt = None
html_theme_options = {
    "navbar_align": "left",
    "header_links_before_dropdown": 7,
    "show_prev_next": True,
    "footer_start": [],
    "footer_end": [],
}
copybutton_prompt_text = "$ "
copybutton_only_copy_prompt_lines = True
