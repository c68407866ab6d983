"""Where templates and layouts lie, and the languages that they have: all that a command line's help asks."""

from __future__ import annotations

import os
import re
from functools import cache
from typing import TypeAlias

from kurbel.errors import LayoutError
from kurbel.reading.files import File

LANGUAGES = ("de", "en")
Folder: TypeAlias = str | os.PathLike[str]


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


def layout_names(folder: Folder | None = None) -> tuple[str, ...]:
    """Return the names of kurbel's layouts, and of those in a folder of the user's.

    Raises LayoutError for a folder that has none, or one that is called as kurbel's own: what a page says by
    its layout's name shall not depend on where it is made.
    """
    own = _names(template_folder())
    if folder is None:
        return own
    if not os.path.isdir(folder):
        raise LayoutError(f"cannot read the layouts {folder}: there is no such folder")
    theirs = _names(folder)
    if not theirs:
        raise LayoutError(f"{folder} has no layouts: no folder in it has a layout.toml")
    for name in theirs:
        if name in own:
            raise LayoutError(f"{_file(folder, name)} has the name of a layout of kurbel's; give it another")
        if not _NAME.fullmatch(name):
            raise LayoutError(
                f"{_file(folder, name)}: the folder {name[:60]} names the layout; use letters, digits and -"
            )
    return tuple(sorted(own + theirs))


def layout_file(name: str, folder: Folder | None = None) -> Folder:
    """Return where the layout of that name is described."""
    return _file(template_folder() if folder is None else folder, name)


_NAME = re.compile(r"[A-Za-z0-9]+(?:-+[A-Za-z0-9]+)*")


def _names(folder: Folder) -> tuple[str, ...]:
    return tuple(sorted(name for name in os.listdir(folder) if os.path.exists(_file(folder, name))))


def _file(folder: Folder, name: str) -> Folder:
    file = os.path.join(str(folder), name, "layout.toml")
    return File(file, folder.folder) if isinstance(folder, File) else file
