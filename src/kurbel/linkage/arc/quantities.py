"""What can stand in a table of the arc crank: one entry each, with its formulas."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import cache
from typing import Any

from kurbel.drive.at import At, angular_square, angular_velocity
from kurbel.drive.crank import Crank
from kurbel.kernel import linkage
from kurbel.linkage.arc.rocker import STROKE
from kurbel.linkage.quantities import DECIMALS, force_entries, force_formula
from kurbel.motion.entries import OF_ROD, on_strokes, spanned
from kurbel.page.quantity import Formula, Quantity, words

ANGLE_DECIMALS = 3
# A further formula, as it is printed where the pivot lies on the left of the end's way.
LEFT = "left"
Formulas = Mapping[str, Formula]
OF_TURN = words(
    "Drehung der Schwinge positiv in der Richtung des Hubes"
    "|turning of the rocker positive in the direction of the stroke"
)

# In printed formulas {±} is the sign of the stroke, {β±} that of the stroke and the side of the pivot.
_ZETA, _TAU = "$ζ = φ - θ$", "$τ = ψ + θ$"


def _turned(at: At) -> Any:
    return 2 * at.numbers.arc(linkage.path_half_sine(at.place, at.arc))


def _path(at: At) -> Any:
    return _turned(at) * at.numbers.pi / 180 / at.arc.curvature


def _rocker(at: At) -> Any:
    return 2 * at.numbers.arc(linkage.rocker_half_sine(at.arc)) - _turned(at)


def _slant(at: At) -> Any:
    return at.numbers.arc(at.place.slant)


def _of(kernel: Callable[..., Any], *said: Any) -> Formula:
    return Formula(lambda at: kernel(at.place, at.arc), *said)


def _by_rocker(kernel: Callable[..., Any]) -> Formula:
    return Formula(lambda at: kernel(at.place, at.arc) / at.numbers.of(at.drive.rocker))


_PATHS: dict[str, Formulas] = {
    "path": {
        "exact": Formula(_path, "{part} $x = B (θ_i - θ)$"),
        LEFT: Formula(_path, "{part} $x = B (θ - θ_i)$"),
    },
    "path_return": {
        "exact": Formula(_path, "{part} $x = B (θ - θ_o)$"),
        LEFT: Formula(_path, "{part} $x = B (θ_o - θ)$"),
    },
}
_PATHS |= {f"{key}_mm": formulas for key, formulas in _PATHS.items()}
_VELOCITY = _of(linkage.velocity, "$c/v = (sin(ζ + τ))/(cos τ)$", (_ZETA, _TAU))
_ACCELERATION = _of(
    linkage.acceleration,
    "$(p R)/v^2 = cos ζ {±} λ (cos^2 ζ)/(cos^3 τ) - (sin ζ {β±} β c^2/v^2) tan τ$",
    (_ZETA, _TAU, "$λ = R/L$", "$β = R/B$"),
)


@cache
def arc_registry() -> Mapping[str, Quantity]:
    """Return every quantity of the arc crank by its key, the return stroke's beside the outstroke's."""
    entries = (one for each in (*_arc_entries(), *_arc_forces()) for one in on_strokes(each))
    return {one.key: one._replace(formulas=_PATHS.get(one.key, one.formulas)) for one in entries}


def _arc_entries() -> Iterator[Quantity]:
    yield _entry(
        "path", "Weg auf dem Bogen|Path along the arc", "x", "R", Formula(_path),
        of=STROKE, names=("path", "x"), rises=True,
    )  # fmt: skip
    yield _sized(
        "path_mm", "Weg auf dem Bogen|Path along the arc", "x", "mm", Formula(_path), Crank.millimetres,
        needs="length", of=STROKE,
    )  # fmt: skip
    yield _entry("velocity", "Geschwindigkeit|Velocity", "c", "v", _VELOCITY, names=("velocity", "c"))
    yield _sized("velocity_mps", "Geschwindigkeit|Velocity", "c", "m/s", _VELOCITY, Crank.pin_velocity)
    yield _sized(
        "acceleration_mps2", "Beschleunigung|Acceleration", "p", "m/s²", _ACCELERATION, Crank.pin_acceleration
    )
    yield _entry(
        "acceleration", "Beschleunigung|Acceleration", "p", "v²/R", _ACCELERATION, "$(p R)/v^2$",
        names=("acceleration", "p"),
    )  # fmt: skip
    yield _entry(
        "rocker",
        "Schwingenwinkel|Rocker angle",
        "θ",
        "°",
        Formula(_rocker),
        names=("rocker", "θ"),
        rises=True,
    )
    yield _entry(
        "rod", "Schubstangenwinkel|Rod angle", "ψ", "°", Formula(lambda at: _slant(at) - _rocker(at))
    )
    yield _entry("slant", "Stange gegen Bogen|Rod against arc", "τ", "°", Formula(_slant, "", (_TAU,)))
    for key, name, letter, kernel in (
        ("chord", "Sehne des Weges|Chord of the path", "q", linkage.chord),
        ("slide_path", "Weg längs der Schubrichtung|Path along the slide", "x_s", linkage.slide_path),
        ("rise", "Weg quer zur Schubrichtung|Path across the slide", "y_s", linkage.rise),
    ):
        yield _entry(key, name, letter, "R", _of(kernel), of=STROKE)
    yield _entry(
        "turn", "Drehung der Schwinge|Turn of the rocker", "ϑ", "°", Formula(lambda at: abs(_turned(at)))
    )
    for key, name, letter, velocity, acceleration, said in (
        (
            "turn", "der Schwinge|of the rocker", "B",
            _by_rocker(linkage.velocity), _by_rocker(linkage.acceleration), OF_TURN,
        ),
        (
            "rod", "der Stange|of the rod", "L",
            _of(linkage.rod_velocity), _of(linkage.rod_acceleration), OF_ROD,
        ),
    ):  # fmt: skip
        de, en = name.split("|")
        speed = f"Winkelgeschwindigkeit {de}|Angular velocity {en}"
        yield _entry(
            f"{key}_velocity", speed, f"ω_{letter}", "ω", velocity, names=(f"{key}_velocity",), direction=said
        )
        gain = f"Winkelbeschleunigung {de}|Angular acceleration {en}"
        yield _entry(
            f"{key}_acceleration", gain, f"ε_{letter}", "ω²", acceleration,
            names=(f"{key}_acceleration",), direction=said,
        )  # fmt: skip
        turning, twice = angular_velocity, angular_square
        yield _sized(
            f"{key}_velocity_radps", speed, f"ω_{letter}", "rad/s", velocity, turning, direction=said
        )
        yield _sized(
            f"{key}_acceleration_radps2", gain, f"ε_{letter}", "rad/s²", acceleration, twice, direction=said
        )


def _entry(
    key: str, name: str, letter: str, unit: str, formula: Formula, heading: str = "", **rest: Any
) -> Quantity:
    """An entry, headed by letter and unit unless another head is given."""
    symbol = f"${letter}$"
    decimals = ANGLE_DECIMALS if unit == "°" else DECIMALS
    if unit != "°":
        # The unit is a quantity of the drive.
        own = unit.replace("²", "^2")
        heading, unit = heading or f"${letter}/{own}$", f"${own}$"
    return spanned(key, name, symbol, heading, unit, decimals, {"exact": formula}, **rest)


def _sized(
    key: str, name: str, letter: str, unit: str, formula: Formula, scale: Callable[..., Any],
    needs: str = "speed", **rest: Any,
) -> Quantity:  # fmt: skip
    """An entry in a unit that the crank's length or its speed makes."""
    symbol, decimals = f"${letter}$", 2 if unit in ("mm", "m/s²") else 3
    heading, formulas = f"{symbol} in {unit}", {"exact": formula}
    return spanned(
        key, name, symbol, heading, unit, decimals, formulas, scale=scale, needs=needs, **rest
    )  # fmt: skip


def _arc_forces() -> Iterator[Quantity]:
    printed = {
        "rod_force": force_formula("rod_force", "$S/F = 1/(cos τ)$", (_TAU,)),
        "guide_force": force_formula("guide_force", "$N/F = tan τ$", (_TAU,)),
        "tangential_force": force_formula(
            "tangential_force", "$T/F = c/v = (sin(ζ + τ))/(cos τ)$", (_ZETA, _TAU)
        ),
        "radial_force": force_formula("radial_force", "$Z/F = (cos(ζ + τ))/(cos τ)$", (_ZETA, _TAU)),
    }
    return force_entries(printed, masses=True)
