"""The functions of `import kurbel` about the connecting rod: inertia, and forces square to the crank."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from os import PathLike

from kurbel.drive.crank import Crank
from kurbel.drive.rod_given import given_rod
from kurbel.errors import ProblemError
from kurbel.page.folders import LANGUAGES
from kurbel.page.layouts import layout_of
from kurbel.page.table import Table
from kurbel.reading import notation
from kurbel.reading.choices import choose
from kurbel.reading.given import Exact, as_angle, as_fraction, as_names, as_ratio, as_share, read_values
from kurbel.reading.speed import Speed

INERTIA_SUBJECTS = ("inertia", "inertia errors")


def make_inertia_table(
    ratios: Exact | Iterable[Exact] | None = None,
    *,
    centre: Exact | None = None,
    gyration: Exact | None = None,
    rod_file: str | PathLike[str] | None = None,
    rod_mass: Exact | None = None,
    layout: str = "inertia",
    angles: Exact | Iterable[Exact] | None = None,
    offset: Exact = 0,
    radius: Exact | None = None,
    speed: Exact | None = None,
    columns: str | Iterable[str] = (),
    digits: int | None = None,
    rounding: str = "half-away",
    lang: str = "de",
    label: str = "",
) -> Table:
    """Return the page of the forces of the moving connecting rod, as `kurbel inertia` prints it.

    `centre` is a/L, counted from the crosshead pin, and `gyration` k/L about the centre of mass; `rod_file`
    is a CSV file of the rod's masses in place of both. `rod_mass` in kg, `radius` R in metres and `speed` in
    turns per second add columns in N and N m. The sheet `inertia-errors` is of the whole turn and takes no
    angles. Raises KurbelError.

    >>> from kurbel import typeset
    >>> page = make_inertia_table("1:5", centre=0.6, gyration=0.48, angles=90, columns="inertia_guide")
    >>> print(typeset(page, "csv"), end="")
    inertia_guide
    0.0067
    """
    from kurbel.motion.inertia_page import ErrorsRequest
    from kurbel.motion.question import Request
    from kurbel.page.build import build

    page = layout_of(layout, INERTIA_SUBJECTS)
    size = None if radius is None else as_fraction(radius)
    turns = None if speed is None else Speed(as_fraction(speed))
    kilograms = None if rod_mass is None else as_fraction(rod_mass)
    shares = [None if one is None else as_share(one) for one in (centre, gyration)]
    values = read_values(page.ratios if ratios is None else ratios, notation.ratios, as_ratio)
    bare = [Crank(ratio, as_fraction(offset), size, turns) for ratio in values]
    cranks = tuple(
        replace(crank, rod=given_rod(shares[0], shares[1], rod_file, kilograms, crank.rod_length))
        for crank in bare
    )
    choose(lang, LANGUAGES, "language")
    if page.subject == "inertia errors":
        if angles is not None:
            raise ProblemError(f"layout {layout} is of the whole turn; leave the angles out")
        return build(
            ErrorsRequest(
                layout=page,
                cranks=cranks,
                digits=digits,
                rounding=rounding,
                lang=lang,
                columns=as_names(columns),
                label=label,
            )
        )
    at = read_values(page.angles if angles is None else angles, notation.angles, as_angle)
    return build(
        Request(
            layout=page,
            cranks=cranks,
            angles=at,
            digits=digits,
            rounding=rounding,
            lang=lang,
            columns=as_names(columns),
            label=label,
        )
    )


def make_tangent_table(
    ratios: Exact | Iterable[Exact] | None = None,
    *,
    force: Exact | None = None,
    radius: Exact | None = None,
    layout: str = "forces-tangent",
    columns: str | Iterable[str] = (),
    digits: int | None = None,
    rounding: str = "half-away",
    lang: str = "de",
    label: str = "",
) -> Table:
    """Return the sheet of the forces where the rod touches the crank circle: `kurbel forces --at tangent`.

    `force` is the piston force in newtons and `radius` R in metres. Raises KurbelError.

    >>> from kurbel import typeset
    >>> print(typeset(make_tangent_table("3:4", columns="phi,rod_force,guide_force"), "csv"), end="")
    phi,rod_force,guide_force
    53.1301,1.2500,0.7500
    """
    from kurbel.motion.tangent_page import TangentRequest
    from kurbel.page.build import build

    page = layout_of(layout, ("tangent",))
    size = None if radius is None else as_fraction(radius)
    newtons = None if force is None else as_fraction(force)
    values = read_values(page.ratios if ratios is None else ratios, notation.ratios, as_ratio)
    return build(
        TangentRequest(
            layout=page,
            cranks=tuple(Crank(ratio, radius=size, force=newtons) for ratio in values),
            digits=digits,
            rounding=rounding,
            lang=choose(lang, LANGUAGES, "language"),
            columns=as_names(columns),
            label=label,
        )
    )
