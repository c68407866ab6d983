"""A quantity of the crank drive at a crank angle, on any kind of number, and its certified digits.

A quantity is evaluated by one of the kernel's formulas on one of four kinds of number: balls (certified
digits), separation bounds (ties), floats and arrays (bulk). A page is computed in balls outright; of long
columns in floats the doubtful cells are settled in balls.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any, NamedTuple

from kurbel.drive.at import At, begun, known, sign_of, way_at
from kurbel.drive.crank import Crank
from kurbel.drive.moved import Drive
from kurbel.errors import ProblemError
from kurbel.exact.kind import Kind, settled
from kurbel.kernel.circle import Numeric
from kurbel.page.quantity import Column, Need, Quantity, Words, words

# Below this many cells balls are done before NumPy is imported.
PAGE_CELLS = 20_000
# Integers of 64 bits have no more digits.
MOST_DECIMALS = 18


class Needs:
    """What a quantity needs to be known of the crank."""

    LENGTH = Need(lambda crank: crank.radius is not None, ("--stroke",))
    SPEED = Need(lambda crank: crank.speed is not None, ("--stroke", "--speed"))
    # The same of another course in π.
    MEAN_SPEED, TIME = Need(SPEED.is_known, SPEED.options), Need(SPEED.is_known, SPEED.options)
    FORCE = Need(lambda crank: crank.pushed, ("--force",))
    MASSES = Need(lambda crank: crank.moving is not None, ("--reciprocating", "--stroke", "--speed"))
    WEIGHT = Need(lambda crank: crank.weighed, ("--slope", *MASSES.options))
    FRICTION = Need(lambda crank: crank.has_friction, ("--friction",))
    PINS = Need(lambda crank: crank.pinned, ("--pin-friction", "--crank-pin", "--stroke"))
    SHAFT = Need(lambda crank: crank.effort is not None and crank.effort.shaft is not None, ("--inertia",))
    ROD = Need(lambda crank: crank.rod is not None, ("--centre", "--gyration"))
    INERTIA = Need(
        lambda crank: None not in (crank.rod and crank.rod.mass, crank.speed),
        ("--rod-mass", "--stroke", "--speed"),
    )
    # Where the centre of mass is that of the crosshead, it rests at moments in which the rod turns.
    ARM = Need(
        lambda crank: crank.rod is not None and crank.rod.centre < 1, ("--centre above 0", "--gyration")
    )
    FINITE = Need(lambda crank: crank.rod_length is not None, ("a finite rod",))
    EVEN = Need(lambda crank: not crank.acceleration, ("a crank that turns evenly",))


# What a quantity is of: a stroke, or the turn, of which it is one number.
OUT, RETURN, TURN = 1, -1, 0
STROKES = {OUT: words("Hingang|Outstroke"), RETURN: words("Rückgang|Return")}


class Method(NamedTuple):
    """A set of formulas, and what a caption calls it."""

    key: str
    name: Words
    caption: Words


_EXACT = words("genaue Formeln|exact formulas")
METHODS = {
    one.key: one
    for one in (
        Method("exact", _EXACT, _EXACT),
        Method(
            "series", words("Näherung erster Ordnung (Blau 22, 25, 26)|first order (Blau 22, 25, 26)"),
            words("Näherung erster Ordnung|first-order formulas"),
        ),
        Method(
            "infinite", words("Schubstange unendlich lang|rod of infinite length"),
            words("unendlich lange Schubstange|infinitely long rod"),
        ),
    )
}  # fmt: skip
# Series of higher order than the books', and the powers of λ that they reach.
REACH = {f"series-{order}": order for order in (3, 5, 7, 9)}
_ORDINALS = {
    3: ("dritter", "third"),
    5: ("fünfter", "fifth"),
    7: ("siebter", "seventh"),
    9: ("neunter", "ninth"),
}
ORDERS = {
    key: Method(
        key,
        words(f"Näherung {_ORDINALS[order][0]} Ordnung|{_ORDINALS[order][1]} order"),
        words(f"Näherung {_ORDINALS[order][0]} Ordnung|{_ORDINALS[order][1]}-order formulas"),
    )
    for key, order in REACH.items()
}
# The gain of a page that shows two methods: exact minus first order, from unrounded values.
DIFFERENCE = "difference"
# What stands for the connecting rod where its masses count: MODELS of drive/rod.py.
ROD_MODELS: Mapping[str, Words] = {
    "exact": words("genau|exact"),
    "two-mass": words("zwei Massen|two masses"),
    "railway": words("6/10, 4/10"),
}
# Further formulas of a quantity: of the offset crank, of a drive with moving masses,
OFFSET, LOADED = "offset", "loaded"
# and in the position in which the rod touches the crank circle, as a closed form.
TANGENT = "tangent"


def is_known(quantity: Quantity, crank: Crank) -> bool:
    """Whether what the quantity needs is known of the crank."""
    return all(need.is_known(crank) for need in quantity.needs)


def unknown(quantity: Quantity) -> str:
    """Return the sentence that refuses a quantity of which too little is known."""
    return (
        f"column {quantity.key} is in {quantity.plain_unit('en')} and needs {' and '.join(quantity.options)}"
    )


def is_transcendental(quantity: Quantity, crank: Crank) -> bool:
    """Whether it is an arc or has the factor π, as v = S π n/60, so that algebra knows nothing of its course.

    No arc is a tie: sin ψ = λ(sin φ - e/R) relates at most two sines of rational angles and a rational
    number. Such relations exist only for ψ = 0 and ±30°, which are whole degrees, and as
    cos 36° - cos 72° = 1/2, which would need λ = 1 (Conway and Jones, Acta Arithmetica 30, 1976, theorem 7).
    """
    if Needs.TIME in quantity.needs:
        return not known(crank.speed).turns or begun(crank, quantity.stroke) is None
    if quantity.in_degrees or quantity.scale is Crank.pin_to_mean:
        return True
    timed = {Needs.SPEED, Needs.MEAN_SPEED, Needs.INERTIA}.intersection(quantity.needs)
    return bool(timed) and known(crank.speed).turns is not (Needs.MEAN_SPEED in timed)


def value(
    quantity: Quantity,
    method: str,
    drive: Drive,
    circle: Any,
    numbers: Kind,
    degrees: Numeric | None = None,
    way: int | None = None,
) -> Numeric:
    """Return the quantity of a drive in its unit, on the kind of number that circle and `numbers` are of.

    The circle is that of φ, on the return of φ less 180°. A time takes the angle in `degrees`, friction which
    `way` the piston goes, where it rests.
    """
    at = drive.at(quantity.stroke, circle, numbers, method, quantity.of)
    at.degrees, at.way = degrees, way
    return _value_at(quantity, method, at)


def _value_at(quantity: Quantity, method: str, at: At) -> Numeric:
    """Return the quantity at a place; of floats NaN where there is no such number."""
    if quantity.exists is None or at.numbers.of is not float:
        return _scaled_at(quantity, method, at)
    import numpy as np

    exists = quantity.exists(at)
    with np.errstate(divide="ignore", invalid="ignore"):
        if np.ndim(exists):
            found: Any = _scaled_at(quantity, method, at)
            return np.where(exists > 0, found, np.nan)
        return _scaled_at(quantity, method, at) if exists > 0 else np.nan


def _scaled_at(quantity: Quantity, method: str, at: At) -> Numeric:
    found = kernel_of(quantity, method, at.drive)(at)
    return found * quantity.scale(at.crank, at.numbers) if quantity.scale else found


class Places:
    """The places of a drive at an angle, which its quantities share; each is made once for each precision."""

    def __init__(self, drive: Drive, angle: Fraction) -> None:
        self.drive, self.angle = drive, angle
        self._made: dict[tuple[object, ...], At] = {}
        self._ways: dict[int, int] = {}

    def at(self, quantity: Quantity, method: str, numbers: Kind) -> At:
        """Return the place on the stroke of a quantity, on a kind of number."""
        # Formulas with few roots may be those of what is asked.
        key = (quantity.stroke, method, id(numbers), quantity.of if numbers.bounded else None)
        # A place holds its kind of number, so that no other has its id.
        if key not in self._made:
            circle = numbers.circle(self.angle)
            made = self.drive.at(quantity.stroke, circle, numbers, method, quantity.of)
            made.way, made.degrees = self._way(quantity.stroke), self.angle
            self._made[key] = made
        return self._made[key]

    def _way(self, stroke: int) -> int | None:
        if not self.drive.crank.has_friction:
            return None
        if stroke not in self._ways:
            self._ways[stroke] = way_at(self.drive.crank, stroke, self.angle)
        return self._ways[stroke]


def method_named(key: str) -> Method:
    """Return a method by its key, also one of higher order."""
    return ORDERS[key] if key in REACH else METHODS[key]


def series_of(order: int) -> str:
    """Return the method by powers of λ up to this one; even powers add nothing, the first is the books'."""
    odd = order - 1 + order % 2
    return f"series-{odd}" if odd > 1 else "series"


def typed(method: str | None) -> str:
    """Return a method as --method names it."""
    return "series" if method in REACH else method or "exact"


def kernel_of(quantity: Quantity, method: str, drive: Drive) -> Callable[[At], Numeric]:
    """Return the kernel's formula by a method; raise ProblemError if there is none."""
    formulas, crank = quantity.formulas, drive.crank
    if drive is not crank:
        # Without a crosshead there is one method.
        return formulas[LOADED if crank.loaded and LOADED in formulas else "exact"].kernel
    if crank.offset and method != "exact":
        raise ProblemError(f'method "{typed(method)}" has no formulas for an offset crank; use exact')
    if method == DIFFERENCE and Needs.TIME in quantity.needs:
        return lambda at: at.numbers.of(Fraction(0))
    if method == DIFFERENCE:
        exact, series = (kernel_of(quantity, one, drive) for one in ("exact", "series"))
        return lambda at: exact(at) - series(replace(at, first_order=True))
    if crank.loaded and LOADED in formulas:
        return formulas[LOADED].kernel
    if method not in formulas:
        raise ProblemError(f'method "{typed(method)}" has no formula for {quantity.key}; use exact')
    if crank.offset and OFFSET not in formulas:
        raise ProblemError(f"{quantity.key} has no formula for an offset crank; leave the offset out")
    return formulas[OFFSET if crank.offset else method].kernel


def certified(
    quantity: Quantity,
    method: str,
    drive: Drive,
    angle: Fraction,
    decimals: int,
    rounding: str = "half-away",
) -> int:
    """Return the quantity times 10**decimals at an exact angle in degrees, rounded correctly.

    The path of an arc crank is an arc with an algebraic sine, hence transcendental or zero (Lindemann). sin ψ
    is p + q cos φ + r sin φ with rational p, q, r and q² + r² < 1; where ψ is a rational number of degrees
    that is one of 0, ±30°, ±45° and ±60° (Conway and Jones, Acta Arithmetica 30, 1976, theorem 7). Rocker and
    rod angles on a boundary are not excluded; `certify.rounded` then raises ProblemError.
    """
    return certified_at(quantity, method, Places(drive, angle), decimals, rounding)


def certified_at(quantity: Quantity, method: str, places: Places, decimals: int, rounding: str) -> int:
    """Return the same at places that quantities share."""

    def at(kind: Kind) -> Numeric:
        return _value_at(quantity, method, places.at(quantity, method, kind))

    return settled(at, decimals, rounding)


def _exists(quantity: Quantity, method: str, places: Places) -> bool:
    """Whether there is such a number at the places."""
    positive = quantity.exists
    return positive is None or sign_of(lambda kind: positive(places.at(quantity, method, kind))) > 0


def columns_in_balls(
    columns: Sequence[Column], drive: Drive, angles: Sequence[Fraction], rounding: str
) -> list[list[int | None]]:
    """Return for each column its values times 10**decimals, rounded correctly, one for each angle.

    Every value is certified by itself: no NumPy, any number of decimals. None is where there is none.
    """
    rows = [
        [
            certified_at(one.quantity, one.method, place, one.places, rounding)
            if _exists(one.quantity, one.method, place)
            else None
            for one in columns
        ]
        for place in (Places(drive, angle) for angle in angles)
    ]
    return [list(column) for column in zip(*rows, strict=True)] if rows else [[] for _ in columns]


def fits_page(columns: Sequence[Column], cranks: Sequence[Crank], angles: Sequence[Fraction]) -> bool:
    """Whether so few cells are done in balls before NumPy is imported; of others motion/bulk.py tells."""
    return len(columns) * len(cranks) * len(angles) <= PAGE_CELLS
