"""A drawing: its size, whether it moves, and what of a page it shows."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from kurbel.commands.options import FLAG, Choice, Option, measure, word
from kurbel.commands.part import Part
from kurbel.errors import ProblemError
from kurbel.exact.numerals import DECIMALS
from kurbel.reading.given import as_length, as_number

if TYPE_CHECKING:
    from kurbel.plot.drawings import DrawingWish
    from kurbel.plot.style import Size

# In mm.
LEAST, MOST = 20, 1000
# In seconds, of a turn.
USUAL_SECONDS, LEAST_SECONDS, MOST_SECONDS = 6, 1, 120


def as_page_length(given: object, what: str) -> float:
    """Return a length on the page in mm. Raises KurbelError beyond the limits."""
    from kurbel.reading.units import is_measure

    measured = isinstance(given, str) and is_measure(given)
    found = 1000 * as_length(given, what) if measured else as_number(given, what)
    if not LEAST <= found <= MOST:
        raise ProblemError(
            f"the {what} of the drawing is {float(found):.6g} mm; it must be from {LEAST} to {MOST} mm"
        )
    return float(found)


def as_seconds(given: object, what: str) -> float:
    """Return how long a turn takes. Raises KurbelError beyond the limits."""
    found = float(as_number(given, what))
    if not LEAST_SECONDS <= found <= MOST_SECONDS:
        raise ProblemError(
            f"a turn of {found:.6g} seconds was asked for; a drawing that moves takes {LEAST_SECONDS} to"
            f" {MOST_SECONDS} of them for each"
        )
    return found


# The decimal mark of a drawing by itself; that of a page stands with its formats.
DECIMAL = word(
    "comma or point; default: by the language.", kind=Choice("decimal mark", DECIMALS),
    environment="KURBEL_DECIMAL", last=True, topic="page",
)  # fmt: skip
flag = partial(Option, kind=FLAG, default=False, last=True)


class DrawingSize(Part):
    """How large a drawing is."""

    topic = "drawing"

    width = measure(
        as_page_length,
        "Width of the drawing in mm, or with a unit: 85, 3.5in; default 120 mm, or less where it needs"
        " less. Type and lines keep their size.",
        "LENGTH", unit="mm", last=True,
    )  # fmt: skip
    height = measure(
        as_page_length, "Height likewise; default: what it needs.", "LENGTH", unit="mm", last=True
    )

    @property
    def size(self) -> Size:
        """The size that is asked for, or what is left to the drawing."""
        from kurbel.plot.style import USUAL, Size

        width, height = self.width, self.height
        if width is None and height is None:
            return USUAL
        return Size(width or USUAL.width, height, width is not None)


class FilmOptions(Part):
    """Whether a drawing moves, and how fast."""

    topic = "drawing"

    animate: Option[bool] = flag(
        "Let the drawing move through its turn: -o turn.html (with a slider), turn.svg or turn.gif."
    )
    seconds = measure(
        as_seconds,
        f"Seconds that a turn of a drawing takes which moves, {LEAST_SECONDS} to {MOST_SECONDS}; default"
        f" {USUAL_SECONDS}.",
        "SECONDS", unit="seconds", last=True,
    )  # fmt: skip

    @property
    def turn(self) -> float | None:
        """The seconds of a turn, None for a drawing that stands still. Raises ProblemError."""
        if self.animate:
            return self.seconds or USUAL_SECONDS
        if self.says("seconds"):
            raise ProblemError("--seconds is for drawings that move; add --animate, or leave it out")
        return None


class DrawingOptions(DrawingSize, FilmOptions):
    """A page as a drawing: its size, whether it moves, and how its curves are shown."""

    topic = "drawing"

    polar: Option[bool] = flag("Draw a polar diagram, of the force on the crank pin or of free forces.")
    over_path: Option[bool] = flag(
        "Draw curves over the path in place of the angle: that of the piston, with the turning effort that of"
        " the crank pin."
    )
    infinite: Option[bool] = flag("Draw the motion with a rod of infinite length as well, dotted.")
    text: Option[bool] = flag(
        "SVG: letters stay text, to be searched and edited, in the reader's fonts; without it they are"
        " outlines, alike everywhere."
    )

    @property
    def wish(self) -> DrawingWish:
        """How the page is drawn, if not in its usual way."""
        from kurbel.plot.drawings import DrawingWish

        if self.animate and self.over_path:
            raise ProblemError(
                "--animate runs through the crank angle, and --over-path is another axis; leave one out"
            )
        return DrawingWish(self.polar, self.over_path, self.infinite)
