"""A construction of the books: its drawing, and the table of the lengths that it gives."""

import re
from collections.abc import Mapping
from fractions import Fraction
from pathlib import Path
from typing import Annotated, Any, Unpack

from kurbel.books.constructions.model import Construction
from kurbel.books.constructions.page import ConstructionRequest
from kurbel.books.constructions.registry import construction, construction_names, unfound
from kurbel.commands import parameters as option
from kurbel.commands.constructions import beside
from kurbel.commands.drawn.size import Sized, page_size
from kurbel.commands.machines import lone_lengths
from kurbel.commands.motion import described, meant, of_other_mechanisms, sheet_of
from kurbel.commands.options import FILE, Count, Kind, Option
from kurbel.commands.shown import Drawing, mark_of
from kurbel.commands.subject import draws, makes_table
from kurbel.errors import ChoiceError, ProblemError
from kurbel.exact.kind import floats
from kurbel.page.layouts import layout_of
from kurbel.reading.given import Exact, File, as_angle, as_names
from kurbel.reading.given import meant as meant_name


class _Name(Kind):
    """The name of a construction; one that has no source is told so."""

    name = "construction"

    def read(self, text: str, typed: Mapping[str, Any]) -> str:
        names = self.known(typed)
        if text not in names and (sentence := unfound(text)):
            raise ChoiceError(sentence)
        return meant_name(text, names, self.name)

    def known(self, typed: Mapping[str, Any]) -> tuple[str, ...]:
        # While it parses, click has a mark of its own for what was not given.
        folder = typed.get("constructions")
        return construction_names(folder if isinstance(folder, File) else None)


Name = Annotated[
    str,
    Option(f"The construction: {', '.join(construction_names())}.", kind=_Name(), positional=True),
]
Folder = Annotated[
    Path | None,
    Option(
        "Folder with constructions of your own: DIR/<name>.toml.", "DIR", FILE,
        environment="KURBEL_CONSTRUCTIONS", first=True,
    ),
]  # fmt: skip


# No construction has more.
MOST_STEPS = 20


class Given(option.AnyDrive, total=False):
    """A crank drive at one crank angle, and what some constructions take beside it."""

    constructions: Folder
    ratio: option.Ratios
    angle: Annotated[
        Exact | None,
        Option("Crank angle from the inner dead centre, in degrees: 50.", "ANGLE", unit="degrees"),
    ]
    point: beside.Point
    centre: beside.Centre
    gyration: beside.Gyration
    eps: beside.Eps
    back: beside.Back


class Listed(Given, option.Sheet, total=False):
    """The same on a page."""


def _of_others(values: Mapping[str, Any]) -> dict[str, str]:
    """Return what was given that describes drives of other constructions."""
    # Its layout says nothing of the mechanism, as those of tables do.
    refused = of_other_mechanisms({**_held(values), "layout": None})
    return {**refused, **beside.foreign(construction(values["name"], values["constructions"]))}


def _held(given: Mapping[str, Any]) -> Mapping[str, Any]:
    """Return the values with the mechanism for which alone the construction holds, where none is named, and
    with what its book takes for it. No layout of constructions says it."""
    shown, given = construction(given["name"], given["constructions"]), {**given, "layout": None}
    named = given["mechanism"] or given["offset"] is not None or "straight" in shown.holds
    if not named:
        given = {**given, "mechanism": shown.holds[0]}
    usual = shown.usual if given["mechanism"] in shown.holds else {}
    return {**given, **{name: value for name, value in usual.items() if given[name] is None}}


def _asked(name: str, given: Mapping[str, Any], **sheet: Any) -> ConstructionRequest:
    """Return what is asked for; raise ProblemError for a drive for which the construction does not hold."""
    shown = construction(name, given["constructions"])
    given = _held({**given, "name": name})
    if meant(given).name not in shown.holds:
        *first, last = shown.holds
        others = f"{', '.join(first)} and {last}" if first else last
        raise ProblemError(shown.refusal or f"construction {name} holds for the {others} crank alone")
    chosen, said = described(given)
    page = sheet.pop("layout", None) or layout_of("construction", ("construction",), None)
    drives = chosen.drives(said, page.ratios)
    if len(drives) > 1:
        raise ProblemError(f"a construction is of one drive, and {len(drives)} ratios were given; choose one")
    (drive,) = drives
    if not drive.crank.ratio:
        raise ProblemError("a rod of infinite length cannot be drawn; give a finite one, such as 1:5")
    shown = shown.of(chosen.name)
    angle, more = _angle(shown, drive, given["angle"]), beside.read(given, drive)
    request = ConstructionRequest(
        layout=page, construction=shown, drive=drive, angle=angle, beside=more, **sheet
    )
    if sentence := shown.fault(request.at(floats())):
        raise ProblemError(sentence)
    return request


def _angle(shown: Construction, drive: Any, given: Exact | None) -> Fraction | None:
    """Return the crank angle, none for the position of the book."""
    if given is None and shown.position and not drive.crank.offset:
        return None
    if not (shown.angle or shown.position):
        if given is not None:
            raise ProblemError(f"construction {shown.name} is of no crank angle; leave --angle out")
        return Fraction(0)
    return as_angle(shown.angle if given is None else given, "angle") % 360


def _needless(values: Mapping[str, Any]) -> Mapping[str, str]:
    """Refuse the length of stroke or rod where no length is compared with it."""
    about = (values[name] for name in ("point", "centre", "gyration"))
    return {} if any(re.search("[a-z]", str(one or "")) for one in about) else lone_lengths(values)


@makes_table(foreign=_of_others, needless=_needless)
def construction_table(
    name: Name,
    *,
    columns: Annotated[option.Names, option.columns_option("construction", "formula,drawn,true")] = (),
    layout: Annotated[str | None, option.layout_option("construction")] = None,
    layouts: option.Layouts = None,
    **given: Unpack[Listed],
) -> ConstructionRequest:
    """Print the lengths of a construction beside their true values, and its steps.

    \f
    >>> import kurbel
    >>> page = kurbel.construction_table("blau-9", ratio="1:5", angle=45, columns="length,drawn,true")
    >>> print(kurbel.typeset(page, "csv").splitlines()[1])
    ad,0.34315,0.34315
    """
    page = layout_of(layout or "construction", ("construction",), layouts)
    return _asked(name, given, layout=page, columns=as_names(columns, "drawn,true"), **sheet_of(given))


class Drawn(Given, Sized, total=False):
    """The same as a drawing."""

    steps: Annotated[
        int | None,
        Option(
            "The drawing up to its step N, on the same page as the whole: 3. Default: all steps.",
            "N",
            Count("steps", 1, MOST_STEPS, "is no step"),
        ),
    ]
    lang: option.Lang
    decimal: option.Decimal


@draws(foreign=_of_others, needless=_needless)
def plot_construction(name: Name, **given: Unpack[Drawn]) -> Drawing:
    """Draw a construction to scale, with the letters of its book.

    As SVG, PNG, PDF or PGF, or as an HTML page with steps to click through.
    \f
    >>> import kurbel
    >>> drawing = kurbel.plot_construction("blau-9", ratio="1:4", angle=50, lang="en")
    >>> drawing.plain_title
    'Piston paths, after Blau, Fig. 9 for R:L = 1:4, α = 50°'
    >>> drawing.about.split(";")[0]
    'R = 17.5 mm'
    """
    from kurbel.plot.construct.drawing import construction_drawing
    from kurbel.plot.construct.lesson import construction_page

    mark = mark_of(given["lang"], given["decimal"])
    asked = _asked(name, given, lang=given["lang"])
    last, count = given["steps"], len(asked.construction.steps)
    if last is not None and last > count:
        raise ProblemError(f"construction {name} has {count} steps, and step {last} was asked for")
    drawn = construction_drawing(asked, mark, page_size(given), last)
    decimal = given["decimal"]

    def page(svg: str) -> str:
        if last is not None:
            raise ProblemError("an HTML page goes through all steps; leave --steps out")
        return construction_page(asked, svg, decimal)

    return Drawing.of(drawn, given["lang"], mark, page)
