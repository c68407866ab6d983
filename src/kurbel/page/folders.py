"""Where templates and layouts lie, and the languages that they have: all that a command line's help asks."""

from __future__ import annotations

import os
from functools import cache

from kurbel.errors import LayoutError

LANGUAGES = ("de", "en")


@cache
def template_folder() -> str:
    """Return the folder of templates: in the installed package, else in the checkout.

    An editable install holds no copy of the templates; the checkout's folder serves it.
    """
    package = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    for folder in (f"{package}/templates", f"{package}/../../templates"):
        if os.path.isdir(folder):
            return os.path.normpath(folder)
    raise LayoutError(f"there are no templates beside {package}; the installation is not complete")


@cache
def layout_names() -> tuple[str, ...]:
    folder = template_folder()
    return tuple(
        sorted(name for name in os.listdir(folder) if os.path.exists(f"{folder}/{name}/layout.toml"))
    )
