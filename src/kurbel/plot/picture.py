"""What is drawn of a question: its panels, or a force as a vector, made by what its subject names."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple, TypeVar

from kurbel.errors import ProblemError
from kurbel.exact.certify import FLOAT_BITS, at_bits
from kurbel.exact.numerals import Label
from kurbel.page.layouts import Layout, layout
from kurbel.page.quantity import Column
from kurbel.page.subject import Question
from kurbel.plot.panel import NOTHING_AROUND, Around, Panel, PinForce
from kurbel.reading import notation
from kurbel.reading.given import found_at

if TYPE_CHECKING:
    from kurbel.plot.animated import Shot
    from kurbel.plot.drawings import Drawing
    from kurbel.plot.style import Size

Asked = TypeVar("Asked", bound=Question)
# The crank ratio in all drawings.
RATIO = "R:L"
# So many steps of the range make a curve smooth, half degrees over the turn; over many turns a wider step
# than this shows.
STEPS, WIDEST = 720, Fraction(5)
MOST_PANELS = 4
# Units by which a column is that of another one, which is a share.
KNOWN = ("_mm", "_mps", "_mps2", "_n", "_nm")


class Wish(NamedTuple):
    """How a page is drawn, if not in its usual way: as a polar diagram, over the path, beside the rod of
    infinite length."""

    polar: bool = False
    over_path: bool = False
    infinite: bool = False


class Picture(NamedTuple):
    """What is drawn: of which question, over smooth angles, its panels or a force, and what is around them.

    `columns` have the names of the question's in the letters of drawings. The title is by itself that of the
    page.
    """

    question: Question
    panels: Sequence[Panel] = ()
    around: Around = NOTHING_AROUND
    force: PinForce | None = None
    columns: Sequence[Column] = ()
    title: Label = ""


def picture(question: Question, wish: Wish) -> Picture:
    """Return what is drawn of a question. Raises ProblemError for what has no such drawing."""
    with at_bits(FLOAT_BITS):
        found: Picture = found_at(question.subject.drawn)(question, wish)
    if len(found.panels) > MOST_PANELS:
        names = "; ".join(panel.label.partition(" $")[0] for panel in found.panels)
        raise ProblemError(
            f"{len(found.panels)} panels are too many for a drawing, which has at most {MOST_PANELS}:"
            f" {names[:200]}; choose some by --columns"
        )
    if wish.polar and found.force is None:
        raise ProblemError(
            "--polar is for the force on the crank pin and for the free forces of an engine, of kurbel forces"
            " and kurbel balance; leave it out"
        )
    return found


def drawn(found: Picture, mark: str, size: Size, run: Shot | None = None) -> Drawing:
    """Return the drawing of a picture; with a shot it is run through."""
    from kurbel.plot.drawings import curves_drawing, polar_drawing

    if found.force is not None:
        made = polar_drawing(found.question, found.force, mark, size, run)
    else:
        made = curves_drawing(found.question, found.panels, mark, found.around, size, run)
    title = found.question.caption or found.title
    return made._replace(title=title) if title else made


def refuse(wish: Wish, **sentences: str) -> None:
    """Raise ProblemError for a wish that what is drawn cannot fulfil, each with its sentence."""
    for name, sentence in sentences.items():
        if getattr(wish, name):
            raise ProblemError(sentence)


def check_one(count: int, what: str) -> None:
    """Raise ProblemError where a polar diagram would be of several."""
    if count > 1:
        raise ProblemError(f"--polar draws one crank drive, and {count} {what} were given; choose one")


def drawing_layout(name: str) -> Layout:
    """Return the layout of that name with the letters of all drawings."""
    return lettered_as_drawings(layout(name))


def lettered_as_drawings(page: Layout) -> Layout:
    """Return a layout with the crank ratio as in all drawings, whatever its book has."""
    own: dict[str, Any] = vars(page) | {"ratio_symbol": RATIO}
    return Layout(**own)


def asked_of(question: Asked, **changes: Any) -> Asked:
    """Return the question as it is drawn, with the letters of all drawings; angles count from φ = 0."""
    page = lettered_as_drawings(question.layout)
    return replace(question, **{"layout": page, "zero": Fraction(0), "digits": None, **changes})


def smooth(angles: Sequence[Fraction], steps: int = STEPS) -> Sequence[Fraction]:
    """Return the angles with others between the first and the last, close enough for smooth curves."""
    if len(angles) > steps:
        return angles
    first, last = min(angles), max(angles)
    step = min((last - first) / steps or WIDEST, WIDEST)
    return sorted({*notation.progression(first, last, step), *angles})


def columns_of(question: Question) -> tuple[Column, ...]:
    """Return the columns that are drawn: those of the page, and unless they were named, a quantity once, in
    its unit."""
    columns = question.page_columns
    if question.columns:
        return columns
    keys = {column.key for column in columns}
    return tuple(one for one in columns if not any(one.key + unit in keys for unit in KNOWN))
