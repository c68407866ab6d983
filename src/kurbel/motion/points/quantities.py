"""What can stand in a table of points of the rod: an entry each."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache
from typing import Any, NamedTuple

from kurbel.drive.crank import Crank
from kurbel.exact.kind import Kind
from kurbel.exact.numerals import Label
from kurbel.kernel import coupler as kernel
from kurbel.kernel.coupler import Point, Reach, Rod, Vector
from kurbel.motion.evaluation import OFFSET
from kurbel.page.quantity import Formula, Quantity, entry, words

# What quantities are of that tell a direction, or the amount of a vector.
DIRECTION, AMOUNT = "direction", "amount"


class At(NamedTuple):
    """What a kernel call takes: the rod, the point, the reach of one beside its axis, the kind of number, and
    α/ω² of a crank that is itself accelerated."""

    rod: Rod[Any]
    point: Point[Any]
    reach: Reach[Any] | None
    kind: Kind
    gain: Any = None


Vectorial = Callable[[At], Vector[Any]]


def path(at: At) -> Vector[Any]:
    return kernel.path(at.rod, at.point, at.reach)


def velocity(at: At) -> Vector[Any]:
    return kernel.velocity(at.rod, at.point)


def acceleration(at: At) -> Vector[Any]:
    even = kernel.acceleration(at.rod, at.point)
    if at.gain is None:
        return even
    # What the crank's own acceleration adds is along the velocity.
    along, across = velocity(at)
    return Vector(even.along + at.gain * along, even.across + at.gain * across)


ALONG, ACROSS = words("längs|along"), words("quer|across")
_AMOUNT, _DIRECTION = words("Betrag|magnitude"), words("Richtung|direction")


class _Kind(NamedTuple):
    """A vector of the point: its key, name, letters along and across, unit and its heading, what makes the
    other unit of it, and its formulas along and across, of the straight and of the offset crank; those of a
    point beside the axis have a further term."""

    key: str
    name: str
    letters: tuple[str, str]
    unit: str
    share: str
    measured: str
    decimals: int
    scale: Callable[..., Any]
    of: Vectorial
    along: tuple[str, str, str, str]
    across: tuple[str, str, str, str]


_VECTORS = (
    _Kind(
        "path", "Weg|Path", ("ξ", "η"), "R", "{}/R", "mm", 2, Crank.millimetres, path,
        (
            "ξ/R = (1 - s) x/R + s (1 - cos φ)", " - t sin φ",
            "ξ/R = (1 - s) x/R + s (cos φ_i - cos φ)", " - t (sin φ - sin φ_i)",
        ),
        ("η/R = s sin φ", " + t (cos ψ)/λ", "η/R = (1 - s) e/R + s sin φ", " + t (cos ψ)/λ"),
    ),
    _Kind(
        "velocity", "Geschwindigkeit|Velocity", ("c_ξ", "c_η"), "v", "{}/v", "m/s", 3, Crank.pin_velocity,
        velocity,
        2 * ("c_ξ/v = (1 - s) c/v + s sin φ", " - t cos φ"),
        2 * ("c_η/v = s cos φ", " + t (sin φ - c/v)"),
    ),
    _Kind(
        "acceleration", "Beschleunigung|Acceleration", ("p_ξ", "p_η"), "v^2/R", "({} R)/v^2", "m/s²", 2,
        Crank.pin_acceleration, acceleration,
        2 * ("(p_ξ R)/v^2 = (1 - s) (p R)/v^2 + s cos φ", " + t sin φ"),
        2 * ("(p_η R)/v^2 = -s sin φ", " + t (cos φ - (p R)/v^2)"),
    ),
)  # fmt: skip
# What the keys of formulas have at their end that are printed of points beside the axis.
BESIDE = " beside"
DECIMALS, ANGLE_DECIMALS = 4, 3
_ENDINGS = {"mm": "mm", "m/s": "mps", "m/s²": "mps2"}


@cache
def points_registry() -> Mapping[str, Quantity]:
    """Return every quantity of a point of the rod by its key."""
    found: list[Quantity] = []
    for one in _VECTORS:
        found += _components(one)
        if one.key != "path":
            found += _amounts(one)
    return {one.key: one for one in found}


def vector_of(quantity: Quantity) -> Vectorial:
    """Return the vector that a quantity is a part of, its amount or its direction."""
    return next(one.of for one in _VECTORS if quantity.key.startswith(one.key))


def parts_of(quantity: Quantity) -> tuple[str, ...]:
    """Return the parts of its vector that a quantity takes."""
    part = next((one for one in Vector._fields if f"_{one}" in quantity.key), None)
    return Vector._fields if part is None else (part,)


def _components(one: _Kind) -> list[Quantity]:
    found = []
    for part, direction, letter, printed in zip(
        Vector._fields, (ALONG, ACROSS), one.letters, (one.along, one.across), strict=True
    ):
        formulas = _formulas(_part(one.of, part), printed)
        found += _in_units(one, f"{one.key}_{part}", letter, formulas, direction)
    return found


def _part(vector: Vectorial, part: str) -> Callable[[At], Any]:
    return lambda at: getattr(vector(at), part)


def _amounts(one: _Kind) -> list[Quantity]:
    along, across = one.letters
    # The crosshead's own have no index.
    letter, turn = f"{along[0]}_P", f"γ_{along[0]}"

    def whole(at: At) -> Any:
        return kernel.amount(one.of(at))

    def direction(at: At) -> Any:
        from kurbel.motion.points.direction import of_floats

        return of_floats(one.of(at))

    printed = f"{letter} = sqrt({along}^2 + {across}^2)"
    towards = f"tan {turn} = -{across}/{along}"
    found = _in_units(one, one.key, letter, _formulas(whole, 2 * (printed, "")), _AMOUNT, of=AMOUNT)
    angle = entry(
        f"{one.key}_direction", one.name, f"${turn}$", "°", ANGLE_DECIMALS,
        _formulas(direction, 2 * (towards, "")), f"${turn}$ in °",
        spanners=(words(one.name),), part=_DIRECTION, of=DIRECTION,
    )  # fmt: skip
    return [*found, angle]


def _formulas(call: Callable[[At], Any], printed: tuple[str, str, str, str]) -> Mapping[str, Formula]:
    """Return the formulas of the straight and of the offset crank, with and without their further term."""
    straight, further, offset, more = printed
    return {
        "exact": Formula(call, f"${straight}$"),
        OFFSET: Formula(call, f"${offset}$"),
        "exact" + BESIDE: Formula(call, f"${straight}{further}$"),
        OFFSET + BESIDE: Formula(call, f"${offset}{more}$"),
    }


def _in_units(
    one: _Kind, key: str, letter: str, formulas: Mapping[str, Formula], part: Mapping[str, str], of: str = ""
) -> list[Quantity]:
    symbol, spanners = f"${letter}$", (words(one.name),)
    share: Label = f"${one.share.format(letter)}$"
    needs = "length" if one.measured == "mm" else "speed"
    return [
        entry(
            key, one.name, symbol, f"${one.unit}$", DECIMALS, formulas, share,
            spanners=spanners, part=part, of=of,
        ),
        entry(
            f"{key}_{_ENDINGS[one.measured]}", one.name, symbol, one.measured, one.decimals, formulas,
            f"{symbol} in {one.measured}", spanners=spanners, part=part, of=of, scale=one.scale, needs=needs,
        ),
    ]  # fmt: skip
