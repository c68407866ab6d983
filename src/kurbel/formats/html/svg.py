"""A drawing's SVG file made part of an HTML page: names of its own, colours of the page, nothing to spare."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element

# The colours of drawings by the names that the style sheet gives them, which has others for dark paper.
COLOURS: Mapping[str, str] = {
    "#000000": "ink",
    "#ffffff": "paper",
    "#8c8c8c": "grey",
    "#d9d9d9": "pale",
    "#0072b2": "blue",
    "#d55e00": "orange",
    "#009e73": "green",
    "#a8508c": "purple",
    "#8f6b00": "brown",
}
# What is black by itself has the colour of the text around it.
_NAMES = {**COLOURS, "currentColor": "ink"}
_COLOUR = re.compile("|".join(_NAMES))
_TARGET = re.compile(r"(url\(#)([^)]+)")
_NAMESPACE = re.compile(r"^\{[^}]*\}")
# What a style sheet within a drawing says of all of its elements, and would say of the whole page.
_ALL = re.compile(r"\*\s*\{([^{}]*)\}")
_SPACE = re.compile(r"\s+")
# The class of the style sheet by which a drawing moves, and how the names in it begin.
MOVES, _MOVING = "film-style", re.compile(r"\bfilm-")


def inline(
    svg: str, name: str, title: str, own_page: bool, step: Callable[[str], int] = lambda name: 0
) -> str:
    """Return the drawing for the middle of a page, an element a line.

    Ids begin with `name`, those that nothing refers to are gone, and so are metadata; `title`, plain text, is
    what a screen reader says before the drawing's description. On a page of our own colours are those of its
    style sheet; on another's the drawing keeps its colours and says itself that it is no wider than the page.
    A group has the number that `step` says of its id, but 0.
    Raises xml.etree.ElementTree.ParseError for what is no SVG.
    """
    from xml.etree import ElementTree

    root = ElementTree.fromstring(svg)
    _prune(root)
    for group in root.iter("g"):
        if number := step(group.get("id", "")):
            group.set("data-step", str(number))
    _name(root, name, own_page)
    heading = ElementTree.Element("title", {"id": f"{name}-title"})
    heading.text = title
    root.insert(0, heading)
    kept = ("viewBox", "width", "height", "fill")
    size = {key: root.attrib[key] for key in kept if key in root.attrib}
    said = [root.get("style", ""), "" if own_page else "max-width: 100%; height: auto"]
    style = {"style": "; ".join(filter(None, said))} if any(said) else {}
    root.attrib.clear()
    root.attrib.update(size | style | {"role": "img", "aria-labelledby": f"{name}-title"})
    ElementTree.indent(root, "")
    return ElementTree.tostring(root, encoding="unicode")


def _prune(root: Element) -> None:
    """Drop what only files need; what a style sheet says of all elements, the root says."""
    for parent in [*root.iter()]:
        parent.tag = _NAMESPACE.sub("", parent.tag)
        for child in [*parent]:
            tag = _NAMESPACE.sub("", child.tag)
            if tag == "style" and (said := _ALL.search(child.text or "")):
                root.set("style", said[1])
            if tag in ("title", "metadata", "style") and child.get("class") != MOVES:
                parent.remove(child)
        parent.tail = None
        if parent.tag not in ("desc", "style"):
            parent.text = None
        attributes = {_NAMESPACE.sub("", key): value for key, value in parent.attrib.items()}
        parent.attrib.clear()
        parent.attrib.update(attributes)


def _name(root: Element, name: str, own_page: bool) -> None:
    """Give ids, and what refers to them, names of their own, and colours those of a page of ours."""
    values = [value for one in root.iter() for value in one.attrib.values()]
    targets = {match[2] for value in values for match in _TARGET.finditer(value)}
    targets |= {one.get("href", "").removeprefix("#") for one in root.iter()}
    for one in root.iter():
        if one.tag == "style":
            one.text = _MOVING.sub(f"{name}-film-", one.text or "")
        if one.get("id") not in targets and not _MOVING.match(one.get("id", "")):
            one.attrib.pop("id", None)
        for key, value in one.attrib.items():
            renamed = _SPACE.sub(" ", _renamed(key, value, name)).strip()
            if own_page:
                renamed = _COLOUR.sub(lambda colour: f"var(--{_NAMES[colour[0]]})", renamed)
            one.attrib[key] = renamed


def _renamed(key: str, value: str, name: str) -> str:
    if key == "id":
        return f"{name}-{value}"
    if key == "href":
        return f"#{name}-{value.removeprefix('#')}"
    return _TARGET.sub(rf"\g<1>{name}-\g<2>", value)
