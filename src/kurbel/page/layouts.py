"""Page layouts: what templates/<layout>/layout.toml says, checked, and where the templates lie."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from functools import cache
from typing import Any, NamedTuple

from kurbel.errors import ChoiceError, LayoutError
from kurbel.exact.numerals import Label
from kurbel.reading.choices import choose

LANGUAGES = ("de", "en")
# What a page is about, and the axes that it shares out.
SUBJECTS: Mapping[str, tuple[str, ...]] = {
    "motion": ("ratio", "angle", "column"),
    "inertia": ("ratio", "angle", "column"),
    "inertia errors": ("ratio", "force", "model", "column"),
    "tangent": ("ratio", "column"),
    "irregularity": ("expansion", "ratio", "column"),
    "strokes": ("expansion", "ratio", "stroke", "column"),
    "turning": ("expansion", "ratio", "angle", "column"),
    "collation": ("place", "column"),
    "crank forces": ("expansion", "ratio", "angle", "column"),
    "machine": ("expansion", "ratio", "angle", "column"),
    "flywheel": ("expansion", "ratio", "target", "column"),
    "dead centres": ("arm", "ratio", "column"),
    "roots": ("ratio", "condition", "stroke", "root", "column"),
    "harmonics": ("order", "ratio"),
    "balance": ("ratio", "residual", "order", "column"),
    "arc crank": ("ratio", "angle", "column"),
    "parallel crank": ("angle", "column"),
}

Localised = Mapping[str, str]


class LayoutColumn(NamedTuple):
    """A column of a layout. `method` None leaves the formulas to the user; spanners and heading None to
    the quantity. It gives way to the quantity `unless` where that is known."""

    key: str
    quantity: str
    method: str | None = None
    spanners: tuple[Localised, ...] | None = None
    heading: tuple[Localised, ...] | None = None
    decimals: int | None = None
    unless: str = ""


class Layout(NamedTuple):
    """An arrangement of the axes of its subject.

    `down` lists the axes that run down, outermost first; those in `stub` are printed in the stub, the
    others head a group of rows. `across` lists the axes of the columns, outermost first. `block` is the
    largest number of columns of one panel, 0 for no limit. With `pairs` an angle stands over its mirror
    image. `formulas` has the formulas printed below the table; pages whose heads state them do without.
    `unit` adds a last column with the unit of each row.
    """

    key: str
    title: Localised
    caption: Localised
    ratios: tuple[str, ...]
    angles: tuple[str, ...]
    down: tuple[str, ...]
    stub: tuple[str, ...]
    across: tuple[str, ...]
    columns: tuple[LayoutColumn, ...]
    source: Localised
    notes: tuple[Localised, ...]
    stub_headings: Mapping[str, Localised]
    angle_symbol: str = "φ"
    ratio_symbol: str = "R:L"
    block: int = 0
    pairs: bool = False
    formulas: bool = True
    subject: str = "motion"
    expansions: tuple[str, ...] = ()
    arms: tuple[str, ...] = ()
    unit: bool = False

    def stub_heading(self, axis: str, default: Label, lang: str) -> Label:
        """Return the heading over the stub column of an axis."""
        return self.stub_headings[axis][lang] if axis in self.stub_headings else default

    @property
    def fixed(self) -> bool:
        """Whether the page's heads state formulas, so that neither columns nor method can be chosen."""
        return all(column.method is not None for column in self.columns)


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


def layout_of(name: str, subjects: Sequence[str]) -> Layout:
    """Return the layout of that name if it is about one of the subjects."""
    page = layout(name)
    if page.subject not in subjects:
        fitting = [other for other in layout_names() if layout(other).subject in subjects]
        raise ChoiceError(f"layout {name} is about something else; choose from {', '.join(fitting)}")
    return page


@cache
def layout(name: str) -> Layout:
    """Return the layout of that name; an unknown name is answered with the nearest and the list."""
    import tomllib

    path = f"{template_folder()}/{choose(name, layout_names(), 'layout')}/layout.toml"
    try:
        with open(path, "rb") as file:
            return _layout(name, tomllib.load(file))
    except (tomllib.TOMLDecodeError, KeyError, TypeError, ValueError) as error:
        raise LayoutError(f"layout {name}: layout.toml cannot be used: {error}") from error


def _layout(name: str, page: dict[str, Any]) -> Layout:
    known = {*Layout._fields} - {"key"}
    unknown = sorted(page.keys() - known)
    if unknown:
        raise ValueError(f"unknown key {unknown[0]}")
    down, across = tuple(page["down"]), tuple(page["across"])
    subject = page.get("subject", "motion")
    axes = SUBJECTS[subject]
    if sorted(down + across) != sorted(axes):
        raise ValueError(f"down and across must share out {', '.join(axes)}")
    notes = page.get("notes", {language: [] for language in LANGUAGES})
    return Layout(
        key=name,
        title=_localised(page["title"]),
        caption=_localised(page["caption"]),
        ratios=tuple(page["ratios"]),
        angles=tuple(page.get("angles", ())),
        down=down,
        stub=tuple(page["stub"]),
        across=across,
        columns=tuple(_column(**column) for column in page["columns"]),
        source=_localised(page.get("source", "")),
        notes=tuple({"de": de, "en": en} for de, en in zip(notes["de"], notes["en"], strict=True)),
        stub_headings={axis: _localised(text) for axis, text in page.get("stub_headings", {}).items()},
        angle_symbol=page.get("angle_symbol", "φ"),
        ratio_symbol=page.get("ratio_symbol", "R:L"),
        block=page.get("block", 0),
        pairs=page.get("pairs", False),
        formulas=page.get("formulas", True),
        subject=subject,
        expansions=tuple(page.get("expansions", ())),
        arms=tuple(page.get("arms", ())),
        unit=page.get("unit", False),
    )


def _column(
    quantity: str,
    key: str = "",
    method: str | None = None,
    spanners: list[str] | None = None,
    heading: list[str] | None = None,
    decimals: int | None = None,
    unless: str = "",
) -> LayoutColumn:
    return LayoutColumn(
        key=key or quantity,
        quantity=quantity,
        method=method,
        spanners=None if spanners is None else tuple(map(_localised, spanners)),
        heading=None if heading is None else tuple(map(_localised, heading)),
        decimals=decimals,
        unless=unless,
    )


def _localised(text: str | dict[str, str]) -> Localised:
    """Both languages of a text: {de = ..., en = ...}, "German|English", or one text for both."""
    if isinstance(text, dict):
        return {language: text[language] for language in LANGUAGES}
    return (
        dict(zip(LANGUAGES, text.split("|"), strict=True)) if "|" in text else dict.fromkeys(LANGUAGES, text)
    )
