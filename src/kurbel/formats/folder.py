"""Folders with templates of a user's: what lies in one, and a copy of kurbel's own to begin with."""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterable, Sequence
from tempfile import TemporaryDirectory

from kurbel.errors import LayoutError, OutputError
from kurbel.formats.registry import Format
from kurbel.page.layouts import layout_file, layout_names, template_folder
from kurbel.reading.given import choose, did_you_mean

BASE, SUFFIX = "base", ".jinja"
# What is around a page: a document of its own, sliders.
MORE = (["document"], ["steps"])


def has_templates(folder: str) -> bool:
    """Tell whether a user's folder has templates, or files that ours include.

    Raises LayoutError for a folder that is none, and for a template of no page, which would be ignored.
    """
    if not os.path.isdir(folder):
        raise LayoutError(f"there is no folder {folder} with templates")
    own = [place for place in _names("", folder) if os.path.exists(layout_file(folder, place))]
    allowed = {**dict.fromkeys((*layout_names(), *own), page_templates()), BASE: _names(BASE)}
    for place, names in allowed.items():
        for name in _names(place, folder):
            if name.endswith(SUFFIX) and name not in names:
                near = did_you_mean(name, names)
                raise LayoutError(
                    f"{folder}/{place}/{name} is a template of nothing{near}; what others include stands in"
                    " another folder"
                )
    return bool(_names(BASE, folder) or _of_layouts(folder))


def check_layouts(folders: Iterable[str], known: Sequence[str]) -> None:
    """Raise LayoutError for a template whose layout is neither kurbel's nor in one of the known folders."""
    for folder in folders:
        for place, name in _of_layouts(folder):
            if any(os.path.exists(layout_file(one, place)) for one in (template_folder(), *known)):
                continue
            raise LayoutError(
                f"{folder}/{place}/{name} is of no layout{did_you_mean(place, layout_names())}; --layouts"
                " names the folder of one's own"
            )


def _of_layouts(folder: str) -> list[tuple[str, str]]:
    """Return the layouts for which a folder has templates, each with the name of one."""
    pages = page_templates()
    return [
        (place, name)
        for place in _names("", folder)
        if place != BASE
        for name in _names(place, folder)
        if name in pages
    ]


def is_set_by_template(form: Format) -> bool:
    """Tell whether pages in a format are set by a template, its own or that of the format it is made of."""
    return form.kind in ("compiled", "document") or f"{form.name}{SUFFIX}" in _names(BASE)


def page_templates() -> list[str]:
    """Return the names of the templates by which pages are set, not those of whole handbooks."""
    names = {name: name.split(".") for name in _names(BASE) if name.endswith(SUFFIX)}
    formats = {parts[0] for parts in names.values() if len(parts) == 2}
    return [name for name, parts in names.items() if parts[0] in formats and parts[1:-1] in ([], *MORE)]


def copied(name: str, folder: str) -> str:
    """Write the layout of that name, with a copy of the templates of its pages, into a folder of a user's.

    Returns the new folder. Raises ChoiceError for a layout that there is not, OutputError for a folder that
    has it already.
    """
    ours, target = template_folder(), os.path.join(folder, choose(name, layout_names(), "layout"))
    if os.path.lexists(target):
        raise OutputError(f"{target} is there already; name another folder, or remove it")
    try:
        os.makedirs(folder, exist_ok=True)
        with TemporaryDirectory(dir=folder, prefix=f".{name}.") as place:
            made = os.path.join(place, name)
            shutil.copytree(os.path.join(ours, name), made)
            for template in page_templates():
                if not os.path.exists(os.path.join(made, template)):
                    shutil.copyfile(os.path.join(ours, BASE, template), os.path.join(made, template))
            os.rename(made, target)
    except OSError as error:
        raise OutputError(f"cannot write {target}: {error.strerror or error}") from error
    return target


def _names(place: str, folder: str = "") -> list[str]:
    """Return what lies at a place of a folder, by default of ours, nothing where that is no folder."""
    path = os.path.join(folder or template_folder(), place)
    return sorted(os.listdir(path)) if os.path.isdir(path) else []
