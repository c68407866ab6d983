"""A construction of the books: its drawing, and the table of the lengths that it gives."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from kurbel.books.constructions.construction_page import (
    ConstructionRequest,
    construction,
    construction_names,
    unfound,
)
from kurbel.books.constructions.model import Construction
from kurbel.books.constructions.placed import ALONE, CENTRE, GYRATION, TAKEN, BesideDrive
from kurbel.commands.options import Count, Kind, Option, amount, file, measure, word
from kurbel.commands.part import CommandOptions
from kurbel.commands.parts.drawing import DECIMAL, DrawingSize
from kurbel.commands.parts.drive import AnyDrive
from kurbel.commands.parts.loads import Loads
from kurbel.commands.parts.masses import MovingRod
from kurbel.commands.parts.sheet import Layouts, PlainPrinting, Sheet, columns_option, layout_option
from kurbel.commands.shown import Drawing, mark_of
from kurbel.commands.subject import function
from kurbel.drive.moved import Drive
from kurbel.drive.rod import Rod
from kurbel.engine.loads.ideal import Steam
from kurbel.errors import ChoiceError, ProblemError
from kurbel.exact.kind import floats
from kurbel.exact.numerals import exact_text
from kurbel.motion.points import points_of
from kurbel.page.layouts import Layout, layout_of
from kurbel.reading.given import File, allowed_name, as_angle, as_share, as_share_or_length
from kurbel.reading.names import enumerated
from kurbel.reading.notation import about

# How far beyond its pins a rod is drawn, in its lengths.
FARTHEST = 1
UNKNOWN = "that of the rod is not known; add --stroke, or give a share of the rod's length"
# No construction has more.
MOST_STEPS = 20


class _Name(Kind):
    """The name of a construction; one that has no source is told so."""

    name, python = "construction", "str"

    def read(self, text: str, typed: Mapping[str, object]) -> str:
        names = self.known(typed)
        if text not in names and (sentence := unfound(text)):
            raise ChoiceError(sentence)
        return allowed_name(text, names, self.name)

    def known(self, typed: Mapping[str, object]) -> tuple[str, ...]:
        # While it parses, click has a mark of its own for what was not given.
        folder = typed.get("constructions")
        return construction_names(folder if isinstance(folder, File) else None)


class ConstructionAtAngle(AnyDrive, CommandOptions):
    """A construction of a crank drive at one crank angle, and what some take beside it."""

    topic = "question"

    unnamed = "name"

    constructions = file(
        "Folder with constructions of your own: DIR/<name>.toml.", "DIR",
        environment="KURBEL_CONSTRUCTIONS", first=True,
    )  # fmt: skip
    angle = amount(
        "Crank angle from the inner dead centre, in degrees: 50.", "ANGLE", unit="degrees", topic="angles"
    )
    point = amount(
        "Ensslin's Figs. 2 and 4: the point of the rod, in rod lengths from the crosshead pin: 0.5, 50%, or a"
        " length.",
        "SHARE",
    )
    centre = MovingRod.centre.but(
        help="Ensslin's Figs. 5 to 7: centre of mass of the rod from the crosshead pin, in rod lengths;"
        " default: 0.65; or a length."
    )
    gyration = MovingRod.gyration.but(
        help="Radius of gyration about it, in rod lengths; default: 0.35; or a length."
    )
    eps = Loads.eps.but(
        help="Radinger: expansion ratio, cut-off after 1/ε of the stroke: 4; default: a constant force."
    )
    back = measure(
        as_share, "Back pressure as a share of the steam pressure: 0.1; default: the best.", "B",
        what="back pressure", topic="steam",
    )  # fmt: skip
    name: Option[str] = word(
        f"The construction: {', '.join(construction_names())}.", kind=_Name(), default="", positional=True,
        required=True,
    )  # fmt: skip

    @property
    def chosen(self) -> Construction:
        """The construction that is named."""
        return construction(self.name, self.constructions)

    def held(self) -> ConstructionAtAngle:
        """Return the same with the mechanism for which alone the construction holds, where none is named, and
        with what its book takes for it."""
        shown, own = self.chosen, {}
        if not (self.says("mechanism", "offset") or "straight" in shown.given.holds):
            own["mechanism"] = shown.given.holds[0]
        usual = shown.given.usual if own.get("mechanism", self.mechanism) in shown.given.holds else {}
        own |= {name: value for name, value in usual.items() if not self.says(name)}
        return type(self)(self.values.instead(own, own=True))

    def requested(self, page: Layout, **sheet: Any) -> ConstructionRequest:
        """Return what is asked for. Raises ProblemError where the construction does not hold of the drive."""
        shown, held = self.chosen, self.held()
        if held.drive().name not in shown.given.holds:
            raise ProblemError(
                shown.given.refusal
                or f"construction {self.name} holds for the {enumerated(shown.given.holds)} crank alone"
            )
        chosen, described = held.described(leaving=() if held.is_sized() else ("stroke", "rod"))
        drives = chosen.drives(described, page.ratios)
        if len(drives) != 1:
            raise ProblemError(
                f"a construction is of one drive, and {len(drives)} ratios were given; choose one"
            )
        (drive,) = drives
        if not drive.crank.ratio and "ratio" in chosen.takes:
            raise ProblemError("a rod of infinite length cannot be drawn; give a finite one, such as 1:5")
        shown = shown.of(chosen.name)
        request = ConstructionRequest(
            layout=page,
            construction=shown,
            mechanism=chosen,
            drive=drive,
            angle=self._angle(shown, drive),
            beside=self._beside(shown, drive),
            **sheet,
        )
        if sentence := shown.fault(request.at(floats())):
            raise ProblemError(sentence)
        return request

    def is_sized(self) -> bool:
        """Whether lengths count: both together, which give the ratio, or to compare another with them."""
        compared = (self.values.values.get(name) for name in ("point", "centre", "gyration"))
        measured = any(isinstance(one, str) and any(map(str.isalpha, one)) for one in compared)
        return measured or self.says("stroke") == self.says("rod") or self.compares_lengths()

    def unread(self, option: Option[object]) -> str:
        name = option.name
        if name in TAKEN:
            return f"construction {self.name} takes no --{name}; leave it out"
        if name in ("stroke", "rod"):
            other = "rod" if name == "stroke" else "stroke"
            return f"--{name} gives the ratio with --{other}; add that, or leave --{name} out"
        return ""

    def _angle(self, shown: Construction, drive: Drive) -> Fraction | None:
        """Return the crank angle, none for the position of the book."""
        given = self.angle
        if given is None and shown.position and not drive.crank.offset:
            return None
        if not (shown.given.angle or shown.position):
            if given is not None:
                raise ProblemError(f"construction {shown.name} is of no crank angle; leave --angle out")
            return Fraction(0)
        return as_angle(shown.given.angle if given is None else given, "angle") % 360

    def _beside(self, shown: Construction, drive: Drive) -> BesideDrive:
        """Return what is given beside the drive, of what the construction takes."""
        takes = {name: self.raw(name) if name in shown.given.takes else None for name in TAKEN}
        point = ALONE.point if takes.get("point") is None else _point(takes["point"], drive)
        if not -FARTHEST <= point <= 1 + FARTHEST:
            raise ProblemError(
                f"the point of the rod is {about(point)} L from the crosshead pin; it must lie within -1..2,"
                " at most a rod's length beyond its pins"
            )
        rod = _rod(takes.get("centre"), takes.get("gyration"), drive)
        return BesideDrive(point, rod, self._steam() if "eps" in shown.given.takes else None)

    def _steam(self) -> Steam | None:
        if not self.says("eps"):
            if self.says("back"):
                raise ProblemError(
                    "--back is for steam that expands; add its expansion ratio, such as --eps 4"
                )
            return None
        ratios = self.eps or ()
        if len(ratios) != 1:
            raise ProblemError(f"a construction is of one expansion ratio; {len(ratios)} are given")
        return Steam(ratios[0], self.back)


class ConstructionOptions(ConstructionAtAngle, Layouts, Sheet):
    """Print the lengths of a construction beside their true values, and its steps.

    \f
    >>> import kurbel
    >>> page = kurbel.construct("blau-9", ratio="1:5", angle=45, columns="length,drawn,true")
    >>> print(kurbel.typeset(page, "csv").splitlines()[1])
    ad,0.34315,0.34315
    """

    in_short = "table point ratio angle offset machine steps width"

    columns = columns_option("construction", "formula,drawn,true")
    layout = layout_option("construction")

    def question(self) -> ConstructionRequest:
        page = self.page("construction", "construction")
        return self.requested(page, columns=self.names("drawn,true"), **self.printed())


class DrawnConstruction(ConstructionAtAngle, DrawingSize):
    """Draw a construction to scale, with the letters of its book.

    As SVG, PNG, PDF or PGF, or as an HTML page with steps to click through.
    \f
    Lengths are in mm, angles in degrees. Source: the book's figure, in the title; of lines, ISO 128-2.

    >>> import kurbel
    >>> drawing = kurbel.plot_construction("blau-9", ratio="1:4", angle=50, lang="en")
    >>> drawing.plain_title
    'Piston paths, after Blau, Fig. 9 for R:L = 1:4, α = 50°'
    >>> drawing.about.split(";")[0]
    'R = 17.5 mm'
    """

    topic = "question"

    steps: Option[int | None] = Option(
        "The drawing up to its step N, on the same page as the whole: 3. Default: all steps.",
        "N",
        Count("steps", 1, MOST_STEPS, "is no step"),
    )
    lang = PlainPrinting.lang.but()
    decimal = DECIMAL.but()

    def question(self) -> Drawing:
        from kurbel.plot.construct import construction_drawing, construction_page

        lang, decimal, last = self.lang, self.decimal, self.steps
        mark = mark_of(lang, decimal)
        asked = self.requested(layout_of("construction", ("construction",), None), lang=lang)
        count = len(asked.construction.steps)
        if last is not None and last > count:
            raise ProblemError(f"construction {self.name} has {count} steps, and step {last} was asked for")
        drawn = construction_drawing(asked, mark, self.size, last)

        def page(svg: str) -> str:
            if last is not None:
                raise ProblemError("an HTML page goes through all steps; leave --steps out")
            return construction_page(asked, svg, decimal)

        return Drawing.of(drawn, lang, mark, page)


def _point(given: object, drive: Drive) -> Fraction:
    points = points_of(given, [drive.crank])
    if len(points) != 1:
        raise ProblemError(f"a construction is of one point of the rod; {len(points)} are given")
    (point,) = points
    if point.beside:
        raise ProblemError(
            f"point {point.text} lies beside the axis of the rod, where Ensslin's figures have no point;"
            f" write {exact_text(point.share)}, or take kurbel table --point {point.text}"
        )
    return point.share


def _rod(centre: object, gyration: object, drive: Drive) -> Rod | None:
    if centre is None and gyration is None:
        return None
    crank = drive.crank
    length = None if crank.radius is None else crank.radius / crank.ratio

    def share(value: object, what: str, usual: Fraction) -> Fraction:
        return usual if value is None else as_share_or_length(value, what, length, UNKNOWN)

    return Rod.from_crosshead(
        share(centre, "centre of mass", CENTRE), share(gyration, "radius of gyration", GYRATION)
    )


construct = function(ConstructionOptions, "construct")
plot_construction = function(DrawnConstruction, "plot_construction", drawn=True)
