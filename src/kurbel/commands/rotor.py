"""Rotating masses: what they leave unbalanced, and what balances them."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any, TypeAlias

from kurbel.commands.options import Option, alone, measure
from kurbel.commands.part import CommandOptions, flag_of
from kurbel.commands.parts.drive import Speed
from kurbel.commands.parts.sheet import Layouts, Sheet, columns_option, layout_option
from kurbel.commands.subject import function
from kurbel.errors import NotationError, ProblemError
from kurbel.page.subject import Question
from kurbel.reading.given import as_speed
from kurbel.reading.measures import as_angles_or_unknown, as_measures, as_measures_or_unknown

if TYPE_CHECKING:
    from kurbel.balancing.rotors.rotor import Mass, Places

# One of each mass, None for what is asked for.
Sought: TypeAlias = Sequence[Fraction | None]
MOST_PLANES = 2


def _planes(given: Any, what: str) -> tuple[Fraction, ...]:
    planes = as_measures(given, "displacement", "plane")
    if len(planes) > MOST_PLANES:
        raise ProblemError(f"{len(planes)} planes of {what} were given; two are enough")
    return planes


def _bearings(given: Any, what: str) -> tuple[Fraction, ...]:
    held = _planes(given, what)
    if len(held) == 1:
        raise ProblemError("one bearing was given; the forces are shared by two, --bearings '0;1.8m'")
    return held


def _place(given: Any, what: str) -> Fraction:
    lengths = as_measures(given, "displacement", what)
    if len(lengths) != 1:
        raise NotationError(f"{what} is a list of {len(lengths)}; give one length")
    return lengths[0]


class RotorOptions(Speed, Layouts, Sheet, CommandOptions):
    """Print what rotating masses leave unbalanced, and what balances them.

    Balancing masses in one plane balance the forces, in two the couples too. What is asked for is a ?: a mass
    with its angle or two angles for static balance, two masses with their angles or one and two angles for
    complete balance, and two planes in place of a mass with its angle.

    \b
    kurbel rotor --masses '200;300;400kg' --radii '80;70;60mm' --angles '0;45;115'
    kurbel rotor --masses '12;9kg' --radii 5cm --angles '0;70' --planes '0;3cm' --balance-planes '1;5cm'
    kurbel rotor --masses '?;9;5;4kg' --radii 10cm --angles '?;0;?;?' --planes '0;0.6;1.2;1.8m'
    kurbel rotor --masses 3kg --radii 2cm --angles 0 --planes 20cm --bearings '0;1m' --speed 900/min
    \f
    >>> import kurbel
    >>> page = kurbel.rotor([3, 4], radii=0.1, angles=[0, 90], columns="line,unbalance_kgm,angle")
    >>> print(kurbel.typeset(page, "csv"), end="")
    line,unbalance_kgm,angle
    mass_1,0.3,0
    mass_2,0.4,90
    unbalance,0.50000,53.13
    """

    unnamed = "masses"
    sequence = "masses radii angles planes balance_planes balance_radii bearings speed about"

    masses: Option[Sought] = Option(
        "The masses: '200kg;300kg', or '200;300kg'; a ? for one that is asked for.", "MASSES", unit="kg",
        required=True, read=lambda given, what: as_measures_or_unknown(given, "mass", what), what="mass",
        whole=True,
    )  # fmt: skip
    radii = measure(
        lambda given, what: as_measures(given, "length", what),
        "Radii of their centres of mass: '200;150mm', or one for all.", "LENGTHS", unit="m", what="radius",
        whole=True,
    )  # fmt: skip
    angles: Option[Sought] = Option(
        "Their directions, in the sense of rotation: '0;45;120'; a ? for what is asked.", "ANGLES",
        unit="degrees", required=True, read=alone(as_angles_or_unknown), whole=True,
    )  # fmt: skip
    planes: Option[Sought | None] = Option(
        "Their planes along the shaft: '0;400;800mm'; a ? for what is asked.", "LENGTHS", unit="m",
        read=lambda given, what: as_measures_or_unknown(given, "displacement", what), what="plane",
        whole=True,
    )  # fmt: skip
    balance_planes: Option[tuple[Fraction, ...]] = Option(
        "Planes of balancing masses, one or two: '100;1100mm'.", "LENGTHS", unit="m", read=_planes,
        what="balancing masses", whole=True,
    )  # fmt: skip
    balance_radii = measure(
        lambda given, what: as_measures(given, "length", what),
        "Radii of the balancing masses: 100mm; without them m r is printed.", "LENGTHS", unit="m", whole=True,
    )  # fmt: skip
    bearings: Option[tuple[Fraction, ...]] = Option(
        "Places of the two bearings along the shaft: '0;1.8m'.",
        "LENGTHS",
        unit="m",
        read=_bearings,
        whole=True,
    )
    speed = Speed.speed.but(help="Speed, for forces in N: 300/min, 12.5rad/s.", read=alone(as_speed))
    about = measure(
        _place,
        "Plane about which moments are taken: 400mm; default: where planes count from.", "LENGTH", unit="m",
    )  # fmt: skip
    columns = columns_option("rotor", "line,unbalance_kgm,angle")
    layout = layout_option("rotor")

    def question(self) -> Question:
        from kurbel.balancing.rotors.page import RotorRequest
        from kurbel.balancing.rotors.rotor import Rotor

        page, masses = self.page("rotor", "rotor"), self._masses()
        along = self.says("planes")
        about = self.about if along else None
        return RotorRequest(
            layout=page,
            rotor=Rotor(masses, about or Fraction(0)),
            places=self._places(),
            speed=self.speed,
            planar=not along,
            columns=self.names("line,unbalance_kgm,angle"),
            **self.printed(),
        )

    def _masses(self) -> tuple[Mass, ...]:
        from kurbel.balancing.rotors.rotor import Mass

        masses, directions = self.masses, self.angles
        count = len(masses)
        radii, planes = self.radii, self.planes
        lengths: Sought = (None,) * count if radii is None else _for_all(radii, count)
        places: Sought = (Fraction(0),) * count if planes is None else planes
        for what, values in (("radii", lengths), ("angles", directions), ("planes", places)):
            if len(values) != count:
                raise ProblemError(
                    f"the number of {what} is {len(values)} and that of masses {count}; every mass needs one"
                    " of each"
                )
        return tuple(map(Mass, masses, lengths, directions, places))

    def _places(self) -> Places:
        """Return where what balances and what holds the shaft lies; in one plane nothing does."""
        from kurbel.balancing.rotors.rotor import Places

        if not self.says("planes"):
            return Places((), (), ())
        planes = self.balance_planes or ()
        radii: Sought = (None,) * len(planes)
        if planes and (lengths := self.balance_radii) is not None:
            radii = _for_all(lengths, len(planes))
        if len(radii) != len(planes):
            raise ProblemError(
                f"the number of balance radii is {len(radii)} and that of balance planes {len(planes)}; give"
                " one of each, or one radius for all"
            )
        return Places(planes, tuple(radii), self.bearings or ())

    def unread(self, option: Option[Any]) -> str:
        if option.name == "balance_radii":
            return (
                "--balance-radii is of the masses in --balance-planes; add these, such as --balance-planes"
                " '100;1100mm' beside --planes, or in one plane ask for a mass with its angle by a ? and give"
                " its radius among --radii"
            )
        return f"{flag_of(option.name)} needs the planes of the masses; add --planes"


rotor = function(RotorOptions, "rotor")


def _for_all(values: Sequence[Fraction], count: int) -> Sequence[Fraction]:
    """Return one value as that of all."""
    return (values[0],) * count if len(values) == 1 else values
