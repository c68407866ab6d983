"""Rotating masses: what they leave unbalanced, and what balances them."""

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Annotated, Any, Unpack

from kurbel.commands import parameters as option
from kurbel.commands.balancing.measures import as_angles_or_unknown, as_measures, as_measures_or_unknown
from kurbel.commands.motion import sheet_of
from kurbel.commands.options import Option, is_given
from kurbel.commands.subject import makes_table
from kurbel.errors import NotationError, ProblemError
from kurbel.page.layouts import layout_of
from kurbel.page.subject import Question
from kurbel.reading.given import Exact, as_names, as_speed

if TYPE_CHECKING:
    from kurbel.balance.rotors.rotor import Mass, Places

Lengths = Annotated[option.Given | None, Option("", "LENGTHS", unit="m")]
MOST_PLANES = 2


class Paper(option.Sheet, total=False):
    """How the page is printed, with layouts of one's own."""

    layouts: option.Layouts


def _needless(values: Mapping[str, Any]) -> Mapping[str, str]:
    found = {}
    if not is_given(values["planes"]):
        for name in ("balance_planes", "bearings", "about"):
            found[name] = f"--{name.replace('_', '-')} needs the planes of the masses; add --planes"
    if not is_given(values["balance_planes"]):
        found["balance_radii"] = (
            "--balance-radii is of the masses in --balance-planes; add these, such as --balance-planes"
            " '100;1100mm' beside --planes, or in one plane ask for a mass with its angle by a ? and give its"
            " radius among --radii"
        )
    return found


@makes_table(
    needless=_needless,
    order="masses radii angles planes balance_planes balance_radii bearings speed about",
)
def rotor_table(
    masses: Annotated[
        option.Given,
        Option(
            "The masses: '200kg;300kg', or '200;300kg'; a ? for one that is asked for.", "MASSES", unit="kg"
        ),
    ],
    *,
    radii: Annotated[
        option.Given | None,
        Option("Radii of their centres of mass: '200;150mm', or one for all.", "LENGTHS", unit="m"),
    ] = None,
    angles: Annotated[
        option.Given,
        Option(
            "Their directions, in the sense of rotation: '0;45;120'; a ? for what is asked.",
            "ANGLES",
            unit="degrees",
        ),
    ],
    planes: Annotated[
        option.Given | None,
        Option("Their planes along the shaft: '0;400;800mm'; a ? for what is asked.", "LENGTHS", unit="m"),
    ] = None,
    balance_planes: Annotated[
        option.Given | None,
        Option("Planes of balancing masses, one or two: '100;1100mm'.", "LENGTHS", unit="m"),
    ] = None,
    balance_radii: Annotated[
        option.Given | None,
        Option("Radii of the balancing masses: 100mm; without them m r is printed.", "LENGTHS", unit="m"),
    ] = None,
    bearings: Annotated[
        option.Given | None,
        Option("Places of the two bearings along the shaft: '0;1.8m'.", "LENGTHS", unit="m"),
    ] = None,
    speed: Annotated[
        Exact | None, option.SPEED._replace(help="Speed, for forces in N: 300/min, 12.5rad/s.")
    ] = None,
    about: Annotated[
        Exact | None,
        Option(
            "Plane about which moments are taken: 400mm; default: where planes count from.",
            "LENGTH",
            unit="m",
        ),
    ] = None,
    columns: Annotated[option.Names, option.columns_option("rotor", "line,unbalance_kgm,angle")] = (),
    layout: Annotated[str, option.layout_option("rotor")] = "rotor",
    **given: Unpack[Paper],
) -> Question:
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
    >>> page = kurbel.rotor_table([3, 4], radii=0.1, angles=[0, 90], columns="line,unbalance_kgm,angle")
    >>> print(kurbel.typeset(page, "csv"), end="")
    line,unbalance_kgm,angle
    mass_1,0.3,0
    mass_2,0.4,90
    unbalance,0.50000,53.13
    """
    from kurbel.balance.rotors.page import RotorRequest
    from kurbel.balance.rotors.rotor import Rotor

    page = layout_of(layout, ("rotor",), given["layouts"])
    placed = _masses(masses, radii, angles, planes)
    return RotorRequest(
        layout=page,
        rotor=Rotor(placed, Fraction(0) if about is None else _one(about, "about")),
        places=_places(balance_planes, balance_radii, bearings),
        speed=None if speed is None else as_speed(speed),
        planar=planes is None,
        columns=as_names(columns, "line,unbalance_kgm,angle"),
        **sheet_of(given),
    )


def _one(value: Exact, what: str) -> Fraction:
    lengths = as_measures(value, "displacement", what)
    if len(lengths) != 1:
        raise NotationError(f"{what} is a list of {len(lengths)}; give one length")
    return lengths[0]


def _masses(masses: Any, radii: Any, angles: Any, planes: Any) -> "tuple[Mass, ...]":
    from kurbel.balance.rotors.rotor import Mass

    read = as_measures_or_unknown(masses, "mass", "mass")
    count = len(read)
    directions = as_angles_or_unknown(angles)
    lengths = (None,) * count if radii is None else _for_all(as_measures(radii, "length", "radius"), count)
    places = (
        (Fraction(0),) * count if planes is None else as_measures_or_unknown(planes, "displacement", "plane")
    )
    for what, values in (("radii", lengths), ("angles", directions), ("planes", places)):
        if len(values) != count:
            raise ProblemError(
                f"the number of {what} is {len(values)} and that of masses {count}; every mass needs one of"
                " each"
            )
    return tuple(map(Mass, read, lengths, directions, places))


def _for_all(values: Sequence[Fraction], count: int) -> tuple[Fraction, ...]:
    """Return one value as that of all."""
    return (values[0],) * count if len(values) == 1 else tuple(values)


def _places(balance_planes: Any, balance_radii: Any, bearings: Any) -> "Places":
    from kurbel.balance.rotors.rotor import Places

    planes = _planes(balance_planes, "balancing masses")
    radii: tuple[Fraction | None, ...] = (None,) * len(planes)
    if balance_radii is not None:
        radii = _for_all(as_measures(balance_radii, "length", "balance radius"), len(planes))
    if len(radii) != len(planes):
        raise ProblemError(
            f"the number of balance radii is {len(radii)} and that of balance planes {len(planes)}; give one"
            " of each, or one radius for all"
        )
    held = _planes(bearings, "bearings")
    if len(held) == 1:
        raise ProblemError("one bearing was given; the forces are shared by two, --bearings '0;1.8m'")
    return Places(planes, radii, held)


def _planes(given: Any, what: str) -> tuple[Fraction, ...]:
    if given is None:
        return ()
    planes = as_measures(given, "displacement", "plane")
    if len(planes) > MOST_PLANES:
        raise ProblemError(f"{len(planes)} planes of {what} were given; two are enough")
    return planes
