"""The functions of `import kurbel` about the arc crank and the parallel crank."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction

from kurbel.drive.crank import Crank
from kurbel.errors import ProblemError
from kurbel.linkage.arc import ArcCrank
from kurbel.page.folders import LANGUAGES
from kurbel.page.layouts import layout_of
from kurbel.page.table import Table
from kurbel.reading import notation
from kurbel.reading.choices import choose
from kurbel.reading.given import Exact, as_angle, as_fraction, as_names, as_ratio, read_values


def make_arc_table(
    rocker: Exact,
    ratios: Exact | Iterable[Exact] | None = None,
    *,
    pivot: tuple[Exact, Exact] | None = None,
    offset: Exact = 0,
    layout: str = "arc",
    angles: Exact | Iterable[Exact] | None = None,
    columns: str | Sequence[str] = (),
    digits: int | None = None,
    rounding: str = "half-away",
    lang: str = "de",
    label: str = "",
) -> Table:
    """Return the page of the arc crank, as `kurbel table --mechanism arc` prints it.

    `rocker` is B/R; `pivot` has the places of its pivot along and across the slide direction from the shaft,
    in units of R, by default L/R and `offset` + B/R. Ratios and angles default to the layout's own. Raises
    KurbelError.

    >>> from kurbel import typeset
    >>> print(typeset(make_arc_table(6, "1:5", angles=[0, 90], columns="phi,path,rocker"), "csv"), end="")
    phi,path,rocker
    0,0.0001,9.587
    90,1.1049,-0.963
    """
    from kurbel.linkage.page import LinkageRequest
    from kurbel.page.build import build

    page = layout_of(layout, ("arc crank",))
    distance, height = pivot_places(pivot)
    return build(
        LinkageRequest(
            layout=page,
            angles=read_values(page.angles if angles is None else angles, notation.angles, as_angle),
            cranks=tuple(
                ArcCrank(Crank(ratio, as_fraction(offset)), as_fraction(rocker), distance, height)
                for ratio in read_values(page.ratios if ratios is None else ratios, notation.ratios, as_ratio)
            ),
            digits=digits,
            rounding=rounding,
            lang=choose(lang, LANGUAGES, "language"),
            columns=as_names(columns),
            label=label,
        )
    )


def pivot_places(pivot: tuple[Exact, Exact] | None) -> tuple[Fraction, Fraction] | tuple[None, None]:
    """Return the places of a rocker's pivot along and across the slide direction, where they are given."""
    if pivot is None:
        return None, None
    if isinstance(pivot, str) or len(pivot) != 2:
        raise ProblemError(
            f"pivot is {str(pivot)[:40]}; give its places along and across the slide in units of R, as (5, 6)"
        )
    return as_fraction(pivot[0]), as_fraction(pivot[1])


def make_parallel_table(
    *,
    layout: str = "parallel",
    angles: Exact | Iterable[Exact] | None = None,
    columns: str | Sequence[str] = (),
    digits: int | None = None,
    rounding: str = "half-away",
    lang: str = "de",
    label: str = "",
) -> Table:
    """Return the page of the parallel crank, as `kurbel table --mechanism parallel` prints it.

    Raises KurbelError.

    >>> from kurbel import typeset
    >>> print(typeset(make_parallel_table(angles=60, columns="coupler_path,coupler_rise"), "csv"), end="")
    coupler_path,coupler_rise
    0.5000,0.8660
    """
    from kurbel.linkage.page import LinkageRequest
    from kurbel.page.build import build

    page = layout_of(layout, ("parallel crank",))
    return build(
        LinkageRequest(
            layout=page,
            angles=read_values(page.angles if angles is None else angles, notation.angles, as_angle),
            digits=digits,
            rounding=rounding,
            lang=choose(lang, LANGUAGES, "language"),
            columns=as_names(columns),
            label=label,
        )
    )
