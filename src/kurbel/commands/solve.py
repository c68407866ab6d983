"""The function of `import kurbel` about conditions: where they hold."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from kurbel.commands.linkage import pivot_places
from kurbel.drive.crank import Crank
from kurbel.errors import NotationError, ProblemError
from kurbel.linkage.arc import ArcCrank
from kurbel.linkage.arc_drive import ArcDrive
from kurbel.motion.drives import Drive, slide_drives
from kurbel.motion.evaluation import METHODS
from kurbel.page.folders import LANGUAGES
from kurbel.page.layouts import layout_of
from kurbel.page.table import Table
from kurbel.reading import notation
from kurbel.reading.choices import choose
from kurbel.reading.given import Exact, as_fraction, as_names, as_ratio, read_values
from kurbel.reading.speed import Speed
from kurbel.reading.where import read_condition


def make_solve_table(
    where: str | Iterable[str],
    ratios: Exact | Iterable[Exact] | None = None,
    *,
    method: str | None = None,
    offset: Exact = 0,
    radius: Exact | None = None,
    speed: Exact | None = None,
    rocker: Exact | None = None,
    pivot: tuple[Exact, Exact] | None = None,
    layout: str = "solve",
    columns: str | Sequence[str] = (),
    digits: int | None = None,
    rounding: str = "half-away",
    lang: str = "de",
    label: str = "",
) -> Table:
    """Return all crank angles of the turn at which conditions hold, as `kurbel solve` prints them.

    `where` has one condition or several, such as "p = 0", "s = 25%", "c = max", "p = 1/6 of dead centre".
    `radius` is R in metres and `speed` the speed in turns per second; with them values may have units:
    "x = 200 mm". `rocker`, B/R, and `pivot`, as of `make_arc_table`, make it the arc crank. Ratios default to
    the layout's own. Raises KurbelError, also where a condition holds nowhere.

    >>> from kurbel import typeset
    >>> page = make_solve_table("p = 0", "1:5", method="series", columns="stroke,phi,x")
    >>> print(typeset(page, "csv"), end="")
    stroke,phi,x
    outstroke,79.2724,0.9104
    return,100.7276,1.0896
    """
    from kurbel.page.build import build
    from kurbel.solve.page import SolveRequest

    page = layout_of(layout, ("roots",))
    values = read_values(page.ratios if ratios is None else ratios, notation.ratios, as_ratio)
    size = None if radius is None else as_fraction(radius)
    turns = None if speed is None else Speed(as_fraction(speed))
    by = "exact" if method is None else choose(method, METHODS, "method")
    cranks = [Crank(ratio, as_fraction(offset), size, turns) for ratio in values]
    drives: tuple[Drive, ...]
    if rocker is None:
        drives = slide_drives(cranks, by)
    elif by != "exact" or size is not None:
        raise ProblemError("the arc crank, in units of R, takes neither method nor radius; leave them out")
    else:
        places = pivot_places(pivot)
        drives = tuple(ArcDrive(ArcCrank(crank, as_fraction(rocker), *places)) for crank in cranks)
    if not drives:
        raise ProblemError("no crank ratio was given; give one, such as 1:5")
    texts = [where] if isinstance(where, str) else list(where)
    if not all(isinstance(text, str) for text in texts):
        raise NotationError('a condition is text, such as "p = 0"')
    return build(
        SolveRequest(
            layout=page,
            drives=drives,
            conditions=tuple(dict.fromkeys(read_condition(text, drives[0].names) for text in texts)),
            digits=digits,
            rounding=rounding,
            lang=choose(lang, LANGUAGES, "language"),
            columns=as_names(columns),
            label=label,
        )
    )
