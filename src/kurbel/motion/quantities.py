"""What can stand in a table: each quantity with its symbol, unit, stroke and formulas, and its evaluation.

A quantity is evaluated by one of the kernel's formulas on one of four kinds of number: balls (certified
digits), separation bounds (ties), floats and arrays (bulk).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from fractions import Fraction
from functools import cache
from typing import Any, NamedTuple

from kurbel.drive.crank import Crank
from kurbel.drive.crank_forces import CRANK_FORCES, CrankForce
from kurbel.errors import ProblemError
from kurbel.exact.numerals import Label
from kurbel.kernel import forces, kinematics

Formula = Callable[..., Any]
# What of the crank a quantity needs to be known, and the options that tell it.
NEEDS: Mapping[str, tuple[str, ...]] = {
    "": (),
    "length": ("--stroke",),
    "speed": ("--stroke", "--speed"),
    "force": ("--force",),
    "torque": ("--force", "--stroke"),
    "masses": ("--reciprocating", "--stroke", "--speed"),
    "rod": ("--centre", "--gyration"),
    "inertia": ("--rod-mass", "--stroke", "--speed"),
}
OUT, RETURN = 1, -1
STROKES = {
    OUT: {"de": "Hingang", "en": "Outstroke"},
    RETURN: {"de": "Rückgang", "en": "Return"},
}
# What stands for the connecting rod where its masses count: rod.MODELS.
ROD_MODELS: Mapping[str, Mapping[str, str]] = {
    "exact": {"de": "genau", "en": "exact"},
    "two-mass": {"de": "zwei Massen", "en": "two masses"},
    "railway": {"de": "6/10, 4/10", "en": "6/10, 4/10"},
}


class Method(NamedTuple):
    """A set of formulas, and what a caption calls it."""

    key: str
    name: Mapping[str, str]
    caption: Mapping[str, str]


METHODS = {
    method.key: method
    for method in (
        Method(
            "exact",
            {"de": "genaue Formeln", "en": "exact formulas"},
            {"de": "genaue Formeln", "en": "exact formulas"},
        ),
        Method(
            "series",
            {"de": "Näherung erster Ordnung (Blau 22, 25, 26)", "en": "first order (Blau 22, 25, 26)"},
            {"de": "Näherung erster Ordnung", "en": "first-order formulas"},
        ),
        Method(
            "infinite",
            {"de": "Schubstange unendlich lang", "en": "rod of infinite length"},
            {"de": "unendlich lange Schubstange", "en": "infinitely long rod"},
        ),
    )
}

# The gain of a page that shows two methods: exact minus first order, from unrounded values.
DIFFERENCE = "difference"


class Numbers(NamedTuple):
    """A kind of number: how an exact rational becomes one, its π, and the rod angle in degrees on it.

    Separation bounds have neither π nor arcs.
    """

    of: Callable[[Fraction], Any]
    pi: Any = None
    rod_angle: Formula | None = None


Scale = Callable[[Crank, Numbers], Any]


class Quantity(NamedTuple):
    """An entry of the registry. `formulas` are by method and take (circle, λ, e/R or None).

    On the return stroke λ and e are negative (the lower sign of the books). `scale` turns the kernel's unit
    into the quantity's; `arc` means the rod angle, which each kind of number finds in its own way. Where the
    rod's masses count, `model` says what stands for it, and formulas take (circle, λ, masses, e/R or None).
    `loaded` is what a force becomes where the crank has moving masses.
    """

    key: str
    name: Mapping[str, str]
    symbol: Label
    heading: Mapping[str, Label]
    unit: Mapping[str, str]
    stroke: int
    formulas: Mapping[str, Formula]
    decimals: int
    scale: Scale
    needs: str = ""
    arc: bool = False
    model: str = ""
    loaded: CrankForce | None = None

    @property
    def is_force(self) -> bool:
        return self.loaded is not None or self.unit["en"] == "F"

    @property
    def part(self) -> Mapping[str, str]:
        """What sets it apart from others of its name: the stroke, or what stands for the rod."""
        return ROD_MODELS[self.model] if self.model else STROKES[self.stroke]

    def available(self, crank: Crank) -> bool:
        known = {
            "length": crank.radius is not None,
            "speed": crank.speed is not None,
            "force": crank.force is not None or crank.moving is not None,
            "torque": crank.radius is not None and (crank.force is not None or crank.moving is not None),
            "masses": crank.moving is not None,
            "rod": crank.rod is not None,
            "inertia": crank.rod is not None and crank.rod.mass is not None and crank.speed is not None,
        }
        return known.get(self.needs, True)

    def formula(self, method: str, crank: Crank, numbers: Numbers) -> Formula:
        if crank.offset and method != "exact":
            raise ProblemError(f'method "{method}" has no formulas for an offset crank; use exact')
        if method not in self.formulas and method != DIFFERENCE and not self.arc:
            raise ProblemError(f'method "{method}" has no formula for {self.key}; use exact')
        if method == DIFFERENCE:
            exact, series = self.formulas["exact"], self.formulas["series"]
            return lambda circle, ratio, offset: exact(circle, ratio, offset) - series(circle, ratio, offset)
        if self.model:
            return self._of_rod(method, crank, numbers)
        if not self.arc:
            return self.formulas[method]
        assert numbers.rod_angle is not None
        return numbers.rod_angle

    def _of_rod(self, method: str, crank: Crank, numbers: Numbers) -> Formula:
        assert crank.rod is not None
        formula, masses = self.formulas[method], crank.rod.masses(self.model, numbers.of)
        return lambda circle, ratio, offset: formula(circle, ratio, masses, offset)

    def transcendental(self, crank: Crank) -> bool:
        """Whether no value can lie on a rounding boundary, for it is an arc or a multiple of π.

        An arc: sin ψ = λ(sin φ - e/R) relates at most two sines of rational angles and a rational number.
        Such relations exist only for ψ = 0 and ±30°, which are whole degrees, and as cos 36° - cos 72° = 1/2,
        which would need λ = 1 (Conway and Jones, Acta Arithmetica 30, 1976, theorem 7).
        """
        by_speed = self.needs in ("speed", "inertia")
        return self.arc or (by_speed and crank.speed is not None and crank.speed.turns)


def value(quantity: Quantity, method: str, crank: Crank, circle: Any, numbers: Numbers) -> Any:
    """Return the quantity in its unit, on the kind of number that circle and `numbers` are of."""
    ratio = numbers.of(quantity.stroke * (Fraction(0) if method == "infinite" else crank.ratio))
    offset = numbers.of(quantity.stroke * crank.offset) if crank.offset else None
    if quantity.loaded is not None and crank.moving is not None:
        force = _loaded(quantity.loaded, crank, circle, ratio, offset, numbers)
        return force * quantity.scale(crank, numbers)
    formula = quantity.formula(method, crank, numbers)
    return formula(circle, ratio, offset) * quantity.scale(crank, numbers)


def _loaded(force: CrankForce, crank: Crank, circle: Any, ratio: Any, offset: Any, numbers: Numbers) -> Any:
    """Return a force in newtons, of the piston force and of the moving masses."""
    assert crank.moving is not None
    weights = crank.moving.weights(numbers.of, pin_acceleration(crank, numbers))
    return force.loaded(circle, ratio, weights, offset, numbers.of(crank.force or Fraction(0)))


def certified(
    quantity: Quantity,
    method: str,
    crank: Crank,
    angle: Fraction,
    decimals: int,
    rounding: str = "half-away",
) -> int:
    """Return the quantity times 10**decimals at an exact angle in degrees, rounded correctly."""
    from kurbel.exact import certify

    def as_ball() -> Any:
        circle = certify.ball_circle(angle)
        return value(quantity, method, crank, circle, numbers_of_balls())

    def tie_bits(boundary: Fraction) -> float:
        return _tie_bits(quantity, method, crank, angle, boundary)

    if _weighs(quantity, method, crank, angle):
        # Turns a second bring the factor π² to what the masses add to an algebraic number.
        ties: certify.TieBits | None = certify.NEVER_TIES
    else:
        ties = certify.NEVER_TIES if quantity.transcendental(crank) else tie_bits
    return certify.rounded(as_ball, decimals, rounding, ties)


def _weighs(quantity: Quantity, method: str, crank: Crank, angle: Fraction) -> bool:
    """Whether the masses may have a part in the force that has the factor π²."""
    if quantity.loaded is None or crank.moving is None or crank.speed is None or not crank.speed.turns:
        return False
    from kurbel.exact import certify
    from kurbel.exact.separation import Separation

    alone = replace(crank, force=None)

    def part() -> Any:
        return value(quantity, method, alone, certify.ball_circle(angle), Numbers(certify.ball))

    bound = value(quantity, method, alone, _bounds(angle), Numbers(Separation.rational))
    return not certify.vanishes(part, float(bound.bits()))


def numbers_of_balls() -> Numbers:
    """Return balls at the precision in force."""
    from kurbel.exact import certify

    return Numbers(certify.ball, certify.pi(), certify.rod_angle)


def _tie_bits(quantity: Quantity, method: str, crank: Crank, angle: Fraction, boundary: Fraction) -> float:
    from kurbel.exact.separation import Separation

    bound = value(quantity, method, crank, _bounds(angle), Numbers(Separation.rational))
    return float((bound - Separation.rational(boundary)).bits())


def _bounds(angle: Fraction) -> Any:
    from kurbel.exact.separation import circle_separation
    from kurbel.kernel.circle import Circle

    return Circle(*circle_separation(angle))


def _straight_or_offset(straight: Callable[..., Any], offset: Callable[..., Any]) -> Formula:
    return lambda circle, ratio, e: straight(circle, ratio) if e is None else offset(circle, ratio, e)


def _straight(formula: Callable[..., Any]) -> Formula:
    return lambda circle, ratio, e: formula(circle, ratio)


def _formulas(exact: Formula, series: Callable[..., Any]) -> Mapping[str, Formula]:
    return {"exact": exact, "series": _straight(series), "infinite": exact}


PATH = _formulas(
    _straight_or_offset(kinematics.piston_path, kinematics.offset_path), kinematics.piston_path_first_order
)
VELOCITY = _formulas(
    _straight_or_offset(kinematics.piston_velocity, kinematics.offset_velocity),
    kinematics.piston_velocity_first_order,
)
ACCELERATION = _formulas(
    _straight_or_offset(kinematics.piston_acceleration, kinematics.offset_acceleration),
    kinematics.piston_acceleration_first_order,
)


def _forces(formula: Formula) -> Mapping[str, Formula]:
    return {"exact": formula, "infinite": formula}


def _one(crank: Crank, numbers: Numbers) -> Any:
    return numbers.of(Fraction(1))


def _share_of_stroke(share: int) -> Scale:
    def scale(crank: Crank, numbers: Numbers) -> Any:
        if not crank.offset:
            return numbers.of(Fraction(share, 2))
        return share / kinematics.stroke(numbers.of(crank.ratio), numbers.of(crank.offset))

    return scale


def _radius(crank: Crank) -> Fraction:
    assert crank.radius is not None
    return crank.radius


def _millimetres(crank: Crank, numbers: Numbers) -> Any:
    return numbers.of(1000 * _radius(crank))


def pin_velocity(crank: Crank, numbers: Numbers) -> Any:
    """Return v = R ω of the crank pin in m/s; bounds, which know no π, leave it out."""
    speed = crank.speed
    assert speed is not None
    if not speed.turns:
        return numbers.of(_radius(crank) * speed.value)
    rational = numbers.of(2 * _radius(crank) * speed.value)
    return rational if numbers.pi is None else rational * numbers.pi


def pin_acceleration(crank: Crank, numbers: Numbers) -> Any:
    """v²/R of the crank pin in m/s²."""
    velocity = pin_velocity(crank, numbers)
    return velocity * velocity / numbers.of(_radius(crank))


def _force(crank: Crank) -> Fraction:
    """What makes newtons of a unit force; forces of moving masses are in newtons as they are."""
    if crank.moving is not None:
        return Fraction(1)
    assert crank.force is not None
    return crank.force


def _newtons(crank: Crank, numbers: Numbers) -> Any:
    return numbers.of(_force(crank))


def _newton_metres(crank: Crank, numbers: Numbers) -> Any:
    return numbers.of(_force(crank) * _radius(crank))


def greatest_load(crank: Crank) -> Fraction:
    """Return a bound of the forces in newtons that piston force and moving masses call up, but for the rod's
    slant: without the factor (2π)² where the speed counts turns."""
    moving, speed = crank.moving, crank.speed
    assert moving is not None
    assert speed is not None
    pin, crosshead, couple = moving.joined
    masses = abs(pin) + crosshead + abs(Fraction(couple)) + moving.reciprocating + abs(moving.rotating)
    factor = 40 if speed.turns else 1
    return (crank.force or Fraction(0)) + masses * _radius(crank) * speed.value**2 * factor


_PATH_NAME = {"de": "Kolbenweg", "en": "Piston path"}
_VELOCITY_NAME = {"de": "Kolbengeschwindigkeit", "en": "Piston velocity"}
_ACCELERATION_NAME = {"de": "Kolbenbeschleunigung", "en": "Piston acceleration"}
_ROD_NAME = {"de": "Schubstangenwinkel", "en": "Rod angle"}
# Key, name, letter, formula of the forces that one piston force F calls up; the torque is in units of F R.
_FORCES: tuple[tuple[str, dict[str, str], str, Formula], ...] = (
    ("rod_force", {"de": "Stangenkraft", "en": "Rod force"}, "S", forces.rod_force),
    ("guide_force", {"de": "Führungsdruck", "en": "Guide force"}, "N", forces.guide_force),
    ("tangential_force", {"de": "Tangentialkraft", "en": "Tangential force"}, "T", forces.tangential_force),
    ("radial_force", {"de": "Radialkraft", "en": "Radial force"}, "Z", forces.radial_force),
)

# Where masses count, what one force alone does not show.
_PIN_FORCES: tuple[tuple[str, dict[str, str], str], ...] = (
    ("crosshead_pin_force", {"de": "Kraft am Kreuzkopfzapfen", "en": "Crosshead-pin force"}, "B"),
    ("crank_pin_force", {"de": "Kraft am Kurbelzapfen", "en": "Crank-pin force"}, "K"),
    ("bearing_along", {"de": "Lagerkraft längs", "en": "Bearing force along"}, "H_x"),
    ("bearing_across", {"de": "Lagerkraft quer", "en": "Bearing force across"}, "H_y"),
    ("bearing_force", {"de": "Lagerkraft", "en": "Bearing force"}, "H"),
)


def _both_strokes(
    key: str, name: Mapping[str, str], heading: str, unit: Mapping[str, str] | str, **rest: Any
) -> list[Quantity]:
    """The quantity on the outstroke and on the return stroke: x_mm and x_return_mm."""
    stem, _, rest_of_key = key.partition("_")
    back = f"{stem}_return_{rest_of_key}" if rest_of_key else f"{stem}_return"
    symbol = "$ψ$" if stem == "psi" else f"${stem}$"
    return _strokes(key, back, symbol, name, heading, unit, **rest)


def _strokes(
    key: str,
    back: str,
    symbol: Label,
    name: Mapping[str, str],
    heading: str,
    unit: Mapping[str, str] | str,
    **rest: Any,
) -> list[Quantity]:
    units = {"de": unit, "en": unit} if isinstance(unit, str) else unit
    de, _, en = heading.partition("|")
    headings = {"de": de, "en": en or de}
    return [
        Quantity(each, name, symbol, headings, units, stroke, **rest)
        for each, stroke in ((key, OUT), (back, RETURN))
    ]


@cache
def registry() -> Mapping[str, Quantity]:
    """Return every quantity by its key, in the order in which `kurbel quantities` lists them."""
    share = {"de": "Hub", "en": "stroke"}
    percent = {"de": "% des Hubes", "en": "% of the stroke"}
    path = {"name": _PATH_NAME, "formulas": PATH}
    velocity = {"name": _VELOCITY_NAME, "formulas": VELOCITY}
    acceleration = {"name": _ACCELERATION_NAME, "formulas": ACCELERATION}
    # The rod angle enters the first-order formulas nowhere; it is the same arc by every method.
    rod = {"name": _ROD_NAME, "formulas": {}, "arc": True}
    length, speed = {"needs": "length"}, {"needs": "speed"}
    rows: list[tuple[str, Label, Any, int, Scale, dict[str, Any]]] = [
        ("x", "$x/R$", "R", 4, _one, path),
        ("x_stroke", "in Teilen des Hubes|in strokes", share, 4, _share_of_stroke(1), path),
        ("x_percent", "in % des Hubes|in % of stroke", percent, 2, _share_of_stroke(100), path),
        ("x_mm", "$x$ in mm", "mm", 2, _millimetres, path | length),
        ("c", "$c/v$", "v", 4, _one, velocity),
        ("c_mps", "$c$ in m/s", "m/s", 3, pin_velocity, velocity | speed),
        ("p", "$(p R)/v^2$", "v²/R", 4, _one, acceleration),
        ("p_mps2", "$p$ in m/s²", "m/s²", 2, pin_acceleration, acceleration | speed),
        ("psi", "$ψ$ in °", "°", 3, _one, rod),
    ]
    entries = [
        quantity
        for key, heading, unit, decimals, scale, rest in rows
        for quantity in _both_strokes(key, heading=heading, unit=unit, decimals=decimals, scale=scale, **rest)
    ]
    return {entry.key: entry for entry in (*entries, *_force_entries())}


def _force_entries() -> Iterator[Quantity]:
    for key, name, letter, formula in _FORCES:
        symbol, rest = f"${letter}$", {"formulas": _forces(formula)}
        loaded = CRANK_FORCES[key]
        yield from _strokes(
            key, f"{key}_return", symbol, name, f"${letter}/F$", "F", decimals=4, scale=_one, **rest
        )
        yield from _strokes(
            f"{key}_n", f"{key}_return_n", symbol, name, f"${letter}$ in N", "N",
            decimals=1, scale=_newtons, needs="force", loaded=loaded, **rest,
        )  # fmt: skip
    for key, name, letter in _PIN_FORCES:
        yield from _strokes(
            f"{key}_n", f"{key}_return_n", f"${letter}$", name, f"${letter}$ in N", "N", decimals=1,
            scale=_newtons, needs="masses", loaded=CRANK_FORCES[key], formulas={},
        )  # fmt: skip
    name, rest = {"de": "Drehmoment", "en": "Torque"}, {"formulas": _forces(forces.tangential_force)}
    yield from _strokes(
        "torque", "torque_return", "$M_d$", name, "$M_d/(F R)$", "F R", decimals=4, scale=_one, **rest
    )
    yield from _strokes(
        "torque_nm", "torque_return_nm", "$M_d$", name, "$M_d$ in N m", "N m",
        decimals=1, scale=_newton_metres, needs="torque", loaded=CRANK_FORCES["tangential_force"], **rest,
    )  # fmt: skip
