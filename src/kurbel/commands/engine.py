"""The functions of `import kurbel` about engines: pages of irregularity, flywheels, dead centres."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from fractions import Fraction
from os import PathLike
from typing import TYPE_CHECKING

from kurbel.drive.crank import Crank
from kurbel.engine.request import OVER_ANGLE
from kurbel.errors import ProblemError
from kurbel.page.folders import LANGUAGES
from kurbel.page.layouts import layout_of
from kurbel.page.table import Table
from kurbel.reading import notation
from kurbel.reading.choices import choose
from kurbel.reading.given import (
    Exact,
    as_angle,
    as_fraction,
    as_names,
    as_ratio,
    as_share,
    read_each,
    read_values,
)
from kurbel.reading.speed import Speed

if TYPE_CHECKING:
    from kurbel.drive.flywheel import Flywheel
    from kurbel.drive.moving import Moving
    from kurbel.engine.engine import Diagram, Load

ENGINE_SUBJECTS = ("irregularity", "strokes", *OVER_ANGLE, "flywheel")


def make_engine_table(
    expansions: Exact | Iterable[Exact] | None = None,
    ratios: Exact | Iterable[Exact] | None = None,
    *,
    layout: str = "weisbach-150",
    methods: str | Iterable[str] = (),
    back: Exact | None = None,
    exponent: Exact = 1,
    clearance: Exact = 0,
    cards: str | PathLike[str] | Iterable[str | PathLike[str]] = (),
    other_side: float | None = None,
    double_acting: bool = True,
    cranks: Exact | Iterable[Exact] = 0,
    angles: Exact | Iterable[Exact] | None = None,
    bore: Exact | None = None,
    pressure: Exact | None = None,
    stroke: Exact | None = None,
    speed: Exact | None = None,
    reciprocating: Exact | None = None,
    rod_mass: Exact | None = None,
    centre: Exact | None = None,
    gyration: Exact | None = None,
    rod_file: str | PathLike[str] | None = None,
    rotating: Exact | None = None,
    power: Exact | None = None,
    irregularities: Exact | Iterable[Exact] = (),
    radius: Exact | None = None,
    columns: str | Iterable[str] = (),
    digits: int | None = None,
    rounding: str = "half-away",
    lang: str = "de",
    label: str = "",
) -> Table:
    """Return a page about steam engines with its certified digits, as `kurbel delta` and its like print.

    Expansion ratios, crank ratios and angles default to the layout's own; values may be text as on the
    command line. `back`, `exponent` and `clearance` are b = R_b/Q (None: the best), n and κ; `cards` are
    files of indicator cards, which take the place of all these, and `other_side` is the pressure in Pa on
    the other face of a single-acting piston. `cranks` are the angles of several cranks in degrees. `bore`
    in m and `pressure` in Pa, but for a card, make newtons of forces. Masses in kg count with these, the
    `stroke` in m and the `speed` in turns per second: `reciprocating`, those of the rod as in
    `make_inertia_table`, and `rotating`, the crank's own at its pin. A page of flywheels needs `power` in W,
    the speed and the `irregularities` δ to keep; `radius` in m adds the mass there. Raises KurbelError.

    >>> from kurbel import typeset
    >>> print(typeset(make_engine_table("2..4"), "csv"), end="")
    epsilon,ratio,delta
    2,1:5,1.282
    3,1:5,1.374
    4,1:5,1.423
    """
    from kurbel.engine.engine import Steam
    from kurbel.engine.request import EngineRequest
    from kurbel.page.build import build

    page = layout_of(layout, ENGINE_SUBJECTS)
    if cards:
        steams: Sequence[Steam | Diagram] = _diagrams(cards, other_side)
    else:
        given = page.expansions if expansions is None else expansions
        inside = (as_fraction(exponent), as_share(clearance))
        steams = [
            Steam(expansion, None if back is None else as_share(back), *inside)
            for expansion in read_values(given, _expansion_ratios, as_fraction)
        ]
    drives = _drives(
        [*read_values(page.ratios if ratios is None else ratios, notation.ratios, as_ratio)],
        _optional(stroke),
        speed,
        (reciprocating, rotating, centre, gyration, rod_file, rod_mass),
    )
    heavy = any(drive.moving is not None for drive in drives)
    wheels = _flywheels(power, speed, irregularities, radius, heavy) if page.subject == "flywheel" else ()
    shifts = notation.crank_angles(cranks) if isinstance(cranks, str) else read_each(cranks, as_angle)
    return build(
        EngineRequest(
            layout=page,
            steams=steams,
            drives=drives,
            double=double_acting,
            cranks=shifts,
            methods=(methods,) if isinstance(methods, str) else tuple(methods),
            angles=read_values((page.angles or "0") if angles is None else angles, notation.angles, as_angle),
            flywheels=wheels if page.subject == "flywheel" else (),
            load=None if bore is None else _load(bore, pressure),
            digits=digits,
            rounding=rounding,
            lang=choose(lang, LANGUAGES, "language"),
            columns=as_names(columns),
            label=label,
        )
    )


def _load(bore: Exact, pressure: Exact | None) -> Load:
    from kurbel.engine.engine import Load

    return Load(as_fraction(bore), _optional(pressure))


# Reciprocating and rotating mass; the rod's centre, gyration, file and mass.
Masses = tuple[
    Exact | None, Exact | None, Exact | None, Exact | None, str | PathLike[str] | None, Exact | None
]


def _drives(
    ratios: Sequence[Fraction], stroke: Fraction | None, speed: Exact | None, masses: Masses
) -> list[Crank]:
    drives = [Crank(ratio, radius=None if stroke is None else stroke / 2) for ratio in ratios]
    if all(one is None for one in masses):
        return drives
    turns = None if speed is None else Speed(as_fraction(speed))
    # One rod for all ratios has a length of its own only if there is one ratio.
    moving = _moving(masses, drives[0].rod_length if len(drives) == 1 else None)
    return [replace(drive, speed=turns, moving=moving) for drive in drives]


def _moving(masses: Masses, length: Fraction | None) -> Moving:
    from kurbel.drive.moving import Moving
    from kurbel.drive.rod_given import given_rod

    reciprocating, rotating, centre, gyration, file, mass = masses
    rod = None
    if any(one is not None for one in masses[2:]):
        shares = [None if one is None else as_share(one) for one in (centre, gyration)]
        rod = given_rod(shares[0], shares[1], file, _optional(mass), length)
    return Moving(_optional(reciprocating) or Fraction(0), rod, _optional(rotating) or Fraction(0))


def _optional(value: Exact | None) -> Fraction | None:
    return None if value is None else as_fraction(value)


def _diagrams(
    cards: str | PathLike[str] | Iterable[str | PathLike[str]], other_side: float | None
) -> list[Diagram]:
    from kurbel.engine.card_file import read_card
    from kurbel.engine.engine import Diagram

    files = [cards] if isinstance(cards, (str, PathLike)) else cards
    return [Diagram(read_card(file), other_side) for file in files]


def _expansion_ratios(texts: Iterable[str]) -> Sequence[Fraction]:
    return notation.numbers(texts, "expansion ratio")


def _flywheels(
    power: Exact | None,
    speed: Exact | None,
    irregularities: Exact | Iterable[Exact],
    radius: Exact | None,
    heavy: bool,
) -> tuple[Flywheel, ...]:
    from kurbel.drive.flywheel import Flywheel

    if speed is None or (power is None and not heavy):
        raise ProblemError("a page of flywheels needs the power in W and the speed in turns per second")
    if power is not None and heavy:
        raise ProblemError(
            "with masses the power follows from pressure, bore, stroke and speed; leave it out"
        )
    size = None if radius is None else as_fraction(radius)
    turns = Speed(as_fraction(speed))
    return tuple(
        Flywheel(None if power is None else as_fraction(power), turns, each, size)
        for each in read_values(irregularities, notation.irregularities, as_ratio)
    )


def make_dead_centres_table(
    arms: Exact | Iterable[Exact] | None = None,
    ratios: Exact | Iterable[Exact] | None = None,
    *,
    exact: bool = False,
    layout: str = "weisbach-149",
    columns: str | Iterable[str] = (),
    digits: int | None = None,
    rounding: str = "half-away",
    lang: str = "de",
    label: str = "",
) -> Table:
    """Return the page of the dead centres of beam engines, as `kurbel deadcentres` prints it.

    `arms` are a/r and `ratios` r:l; by the approximations of § 149 or, with `exact`, from the true geometry.
    Raises KurbelError.

    >>> from kurbel import typeset
    >>> print(typeset(make_dead_centres_table(3, "1:5", columns="mu,path_1"), "csv"), end="")
    mu,path_1
    0.7958,0.00010
    """
    from kurbel.linkage.beam_page import BeamRequest
    from kurbel.page.build import build

    page = layout_of(layout, ("dead centres",))
    return build(
        BeamRequest(
            layout=page,
            arms=tuple(read_values(page.arms if arms is None else arms, _arms, as_fraction)),
            ratios=tuple(read_values(page.ratios if ratios is None else ratios, notation.ratios, as_ratio)),
            exact=exact,
            digits=digits,
            rounding=rounding,
            lang=choose(lang, LANGUAGES, "language"),
            columns=as_names(columns),
            label=label,
        )
    )


def _arms(texts: Iterable[str]) -> Sequence[Fraction]:
    return notation.numbers(texts, "beam arm")
