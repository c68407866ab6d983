"""The formulas behind the steps of worked examples.

A formula takes the numbers of its part and a kind of number; `exact` are the coefficients of equations.
Blau's are of the first order in λ = R/L. Sources: Blau, eq. (22) and (26), examples 31 to 35; the exercise
"Kräfte am Kurbeltrieb"; Weisbach-Herrmann, §§ 149 and 150 (example_steam.py).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any, NamedTuple

from kurbel.exact.certify import pi
from kurbel.examples import steam as example_steam
from kurbel.examples.kinds import Formula, Given, Kind, exact_root
from kurbel.kernel.beam import approximate_lean, approximate_path
from kurbel.kernel.circle import root


class Formulas(NamedTuple):
    """What the templates of an example can name: steps, exact numbers, conditions of lines.

    `transcendental` are steps of which no value is a tie; angles need not be named.
    """

    steps: Mapping[str, Formula]
    exact: Mapping[str, Callable[[Given], Fraction]]
    conditions: Mapping[str, Callable[[Given], bool]]
    transcendental: frozenset[str] = frozenset()


class Position(NamedTuple):
    """λ and the crank angle, in one kind of number."""

    ratio: Any
    cosine: Any
    sine: Any


def _share(place: Position) -> Any:
    """½ λ sin² α, with which the rod's slant adds to the path."""
    return place.ratio * place.sine * place.sine / 2


def _path(place: Position) -> Any:
    """x/R by eq. (22), upper sign."""
    return 1 - place.cosine + _share(place)


MOTION: Mapping[str, Callable[[Position], Any]] = {
    "cosine": lambda place: place.cosine,
    "cosine_again": lambda place: place.cosine,
    "turned": lambda place: -place.cosine,
    "versine": lambda place: 1 - place.cosine,
    "sine": lambda place: place.sine,
    "square": lambda place: place.sine * place.sine,
    "share": _share,
    "sum": lambda place: 1 + _share(place),
    "path": _path,
    "stroke": lambda place: _path(place) / 2,
}
RATIOS: Mapping[str, Callable[[Given], Fraction]] = {
    "ratio": lambda given: given["ratio"],
    "half": lambda given: given["ratio"] / 2,
    "rod": lambda given: 1 / given["ratio"],
    "half_rod": lambda given: 1 / given["ratio"] / 2,
    "quarter_rod": lambda given: 1 / given["ratio"] / 4,
    "quarter_square": lambda given: (1 / given["ratio"] / 4) ** 2,
    "start": lambda given: 1 + given["ratio"],
    "sixth": lambda given: (1 + given["ratio"]) / 6,
    "rod_sixth": lambda given: (1 / given["ratio"] + 1) / 6,
}


def _moved(position: Callable[[Given, Kind], Position]) -> dict[str, Formula]:
    """Return the formulas of the motion at a position."""

    def at(formula: Callable[[Position], Any]) -> Formula:
        return lambda given, kind: formula(position(given, kind))

    return {key: at(formula) for key, formula in MOTION.items()}


def _at_angle(given: Given, kind: Kind) -> Position:
    circle = kind.circle(given["angle"])
    return Position(kind.of(given["ratio"]), circle.cosine, circle.sine)


PATH = Formulas(_moved(_at_angle), RATIOS, {})


def quadratic(constant: Callable[[Given], Fraction]) -> Formulas:
    """Return the formulas of cos² α + L/2R cos α - constant = 0 and of the motion at its first root.

    cos α = (-L/R ± sqrt((L/R)² + 16 constant))/4.
    """

    def radicand(given: Given) -> Fraction:
        return 1 / given["ratio"] ** 2 + 16 * constant(given)

    def solved(sign: int) -> Formula:
        def root_of(given: Given, kind: Kind) -> Any:
            rod, exact = 1 / given["ratio"], exact_root(radicand(given))
            # A ball around -1 reaches where no angle has such a cosine.
            if exact is not None:
                return kind.of((sign * exact - rod) / 4)
            return (sign * kind.root(radicand(given)) - kind.of(rod)) / 4

        return root_of

    cosine, other = solved(1), solved(-1)

    def position(given: Given, kind: Kind) -> Position:
        here = cosine(given, kind)
        return Position(kind.of(given["ratio"]), here, root((1 - here) * (1 + here)))

    def two_roots(given: Given) -> bool:
        """Whether the other root is -1 or more: sqrt(radicand) <= 4 - L/R."""
        room = 4 - 1 / given["ratio"]
        return room >= 0 and radicand(given) <= room * room

    steps: dict[str, Formula] = {
        "half_rod": lambda given, kind: kind.of(1 / given["ratio"] / 2),
        "root": lambda given, kind: kind.root(radicand(given)),
        "quarter_root": lambda given, kind: kind.root(radicand(given)) / 4,
        "numerator": lambda given, kind: 4 * cosine(given, kind),
        "other": other,
        "alpha": lambda given, kind: _degrees(cosine(given, kind)),
        "other_alpha": lambda given, kind: _degrees(other(given, kind)),
    }
    exact = {"constant": constant, "radicand": radicand}
    return Formulas(
        _moved(position) | steps,
        {**RATIOS, **exact, "quarter_radicand": lambda given: radicand(given) / 16},
        {"one_root": lambda given: not two_roots(given), "two_roots": two_roots},
    )


def _degrees(cosine: Any) -> Any:
    return _arc(cosine.acos())


def _arc(radians: Any) -> Any:
    """Return degrees."""
    return radians * 180 / pi()


# p = 0; p = +(1 + λ)/6; p = -(1 + λ)/6, in v²/R.
ZERO = quadratic(lambda given: Fraction(1, 2))
SIXTH = quadratic(lambda given: (1 / given["ratio"] + 7) / 12)
RETARDED = quadratic(lambda given: (5 - 1 / given["ratio"]) / 12)


def _secant(given: Given, kind: Kind) -> Any:
    """sqrt((r/l)² + 1), what the rod carries of the piston force. Source: the exercise, eq. (5)."""
    return kind.root(given["ratio"] ** 2 + 1)


SQUARE = Formulas(
    {
        "alpha": lambda given, kind: _arc(kind.of(given["ratio"]).atan()),
        "rod": _secant,
        "rod_n": lambda given, kind: _secant(given, kind) * kind.of(given["force"]),
        "guide": lambda given, kind: kind.of(given["ratio"]),
        "guide_n": lambda given, kind: kind.of(given["ratio"] * given["force"]),
        "torque": _secant,
        "torque_n": lambda given, kind: _secant(given, kind) * kind.of(given["force"]),
    },
    RATIOS,
    {"numbers": lambda given: "ratio" in given, "newtons": lambda given: "force" in given},
)


def _lean(side: int) -> Formula:
    """μ (side 1) or ν (side -1) in radians. Source: § 149."""
    return lambda given, kind: kind.of(approximate_lean(given["beam"], side * given["ratio"]))


MU, NU = _lean(1), _lean(-1)


def _distance(side: int) -> Formula:
    """180° ± (ν - μ)."""
    return lambda given, kind: 180 + side * _arc(NU(given, kind) - MU(given, kind))


def _beam_path(lean: Formula) -> Formula:
    return lambda given, kind: approximate_path((lean(given, kind) / 2).sin())


BEAM = Formulas(
    {
        "mu_radians": MU,
        "nu_radians": NU,
        "mu": lambda given, kind: _arc(MU(given, kind)),
        "nu": lambda given, kind: _arc(NU(given, kind)),
        "distance_1": _distance(1),
        "distance_2": _distance(-1),
        "path_1": _beam_path(MU),
        "path_2": _beam_path(NU),
    },
    RATIOS,
    {},
    frozenset(("path_1", "path_2")),
)

STEAM = Formulas(
    example_steam.STEPS,
    {
        **RATIOS,
        "eps": lambda given: given["eps"],
        "back": lambda given: given["back"],
        "loss": lambda given: given["eps"] * given["back"],
        "double": lambda given: 2 * given["ratio"],
    },
    {
        "best_back": example_steam.is_best,
        "other_back": lambda given: not example_steam.is_best(given),
    },
    frozenset(example_steam.STEPS),
)

FORMULAS: Mapping[str, Formulas] = {
    "path": PATH,
    "zero": ZERO,
    "sixth": SIXTH,
    "retarded": RETARDED,
    "square": SQUARE,
    "beam": BEAM,
    "steam": STEAM,
}
