"""What can stand in a table of the arc crank: one entry each, with its formulas."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import cache
from typing import Any

from kurbel.exact.numerals import Label
from kurbel.kernel import linkage
from kurbel.linkage.arc.crank import STROKE
from kurbel.linkage.linkage import At
from kurbel.linkage.quantities import DECIMALS, force_entries, force_formula
from kurbel.motion.evaluation import OUT, RETURN
from kurbel.motion.quantities import on_strokes, spanned
from kurbel.page.quantity import Formula, Quantity

ANGLE_DECIMALS = 3
# A further formula, as it is printed where the pivot lies on the left of the end's way.
LEFT = "left"
Formulas = Mapping[str, Formula]

# In printed formulas {±} is the sign of the stroke, {β±} that of the stroke and the side of the pivot.
_ZETA, _TAU = "$ζ = φ - θ$", "$τ = ψ + θ$"


def _half_arc(at: At, half_sine: Any) -> Any:
    return 2 * at.kind.arc(half_sine)


def _turned(at: At) -> Any:
    return _half_arc(at, linkage.path_half_sine(at.place, at.arc))


def _path(at: At) -> Any:
    return _turned(at) * at.kind.pi / 180 / at.arc.curvature


def _rocker(at: At) -> Any:
    return _half_arc(at, linkage.rocker_half_sine(at.arc)) - _turned(at)


def _slant(at: At) -> Any:
    return at.kind.arc(at.place.slant)


def _by_rocker(kernel: Callable[..., Any]) -> Callable[[At], Any]:
    def call(at: At) -> Any:
        return kernel(at.place, at.arc) / at.kind.of(at.drive.rocker)

    return call


def _of(kernel: Callable[..., Any]) -> Callable[[At], Any]:
    return lambda at: kernel(at.place, at.arc)


_PATHS: Mapping[int, Formulas] = {
    OUT: {
        "exact": Formula(_path, "{part} $x = B (θ_i - θ)$"),
        LEFT: Formula(_path, "{part} $x = B (θ - θ_i)$"),
    },
    RETURN: {
        "exact": Formula(_path, "{part} $x = B (θ - θ_o)$"),
        LEFT: Formula(_path, "{part} $x = B (θ_o - θ)$"),
    },
}
_VELOCITY = Formula(_of(linkage.velocity), "$c/v = (sin(ζ + τ))/(cos τ)$", (_ZETA, _TAU))
_ACCELERATION = Formula(
    _of(linkage.acceleration),
    "$(p R)/v^2 = cos ζ {±} λ (cos^2 ζ)/(cos^3 τ) - (sin ζ {β±} β c^2/v^2) tan τ$",
    (_ZETA, _TAU, "$λ = R/L$", "$β = R/B$"),
)


@cache
def arc_registry() -> Mapping[str, Quantity]:
    """Return every quantity of the arc crank by its key, the return stroke's beside the outstroke's."""
    return {one.key: one for one in (*_arc_entries(), *_arc_forces())}


def _arc_entries() -> Iterator[Quantity]:
    for one in _both(
        "path", "Weg auf dem Bogen|Path along the arc", "$x$", "$x/R$", "R", Formula(_path),
        is_arc=True, of=STROKE, names=("path", "x"),
    ):  # fmt: skip
        yield one._replace(formulas=_PATHS[one.stroke])
    yield from _both(
        "velocity", "Geschwindigkeit|Velocity", "$c$", "$c/v$", "v", _VELOCITY, names=("velocity", "c")
    )
    yield from _both(
        "acceleration", "Beschleunigung|Acceleration", "$p$", "$(p R)/v^2$", "v²/R", _ACCELERATION,
        names=("acceleration", "p"),
    )  # fmt: skip
    yield from _angle(
        "rocker", "Schwingenwinkel|Rocker angle", "$θ$", Formula(_rocker), names=("rocker", "θ")
    )
    yield from _angle(
        "rod", "Schubstangenwinkel|Rod angle", "$ψ$", Formula(lambda at: _slant(at) - _rocker(at))
    )
    yield from _angle("slant", "Stange gegen Bogen|Rod against arc", "$τ$", Formula(_slant, "", (_TAU,)))
    for key, name, symbol, kernel in (
        ("chord", "Sehne des Weges|Chord of the path", "q", linkage.chord),
        ("slide_path", "Weg längs der Schubrichtung|Path along the slide", "x_s", linkage.slide_path),
        ("rise", "Weg quer zur Schubrichtung|Path across the slide", "y_s", linkage.rise),
    ):
        yield from _both(key, name, f"${symbol}$", f"${symbol}/R$", "R", Formula(_of(kernel)), of=STROKE)
    yield from _angle(
        "turn", "Drehung der Schwinge|Turn of the rocker", "$ϑ$", Formula(lambda at: abs(_turned(at)))
    )
    for key, name, symbol, unit, turning in (
        (
            "turn_velocity", "Winkelgeschwindigkeit der Schwinge|Angular velocity of the rocker", "ω_B", "ω",
            _by_rocker(linkage.velocity),
        ),
        (
            "turn_acceleration", "Winkelbeschleunigung der Schwinge|Angular acceleration of the rocker",
            "ε_B", "ω²", _by_rocker(linkage.acceleration),
        ),
        (
            "rod_velocity", "Winkelgeschwindigkeit der Stange|Angular velocity of the rod", "ω_L", "ω",
            _of(linkage.rod_velocity),
        ),
        (
            "rod_acceleration", "Winkelbeschleunigung der Stange|Angular acceleration of the rod",
            "ε_L", "ω²", _of(linkage.rod_acceleration),
        ),
    ):  # fmt: skip
        heading = f"${symbol}/{unit.replace('²', '^2')}$"
        yield from _both(key, name, f"${symbol}$", heading, unit, Formula(turning))


def _angle(key: str, name: str, symbol: Label, formula: Formula, **rest: Any) -> Iterator[Quantity]:
    return _both(
        key, name, symbol, f"{symbol} in °", "°", formula, decimals=ANGLE_DECIMALS, is_arc=True, **rest
    )


def _both(
    key: str,
    name: str,
    symbol: Label,
    heading: Label,
    unit: str,
    formula: Formula,
    decimals: int = DECIMALS,
    **rest: Any,
) -> Iterator[Quantity]:
    return on_strokes(spanned(key, name, symbol, heading, unit, decimals, {"exact": formula}, **rest))


def _arc_forces() -> Iterator[Quantity]:
    printed = {
        "rod_force": force_formula("rod_force", "$S/F = 1/(cos τ)$", (_TAU,)),
        "guide_force": force_formula("guide_force", "$N/F = tan τ$", (_TAU,)),
        "tangential_force": force_formula(
            "tangential_force", "$T/F = c/v = (sin(ζ + τ))/(cos τ)$", (_ZETA, _TAU)
        ),
        "radial_force": force_formula("radial_force", "$Z/F = (cos(ζ + τ))/(cos τ)$", (_ZETA, _TAU)),
    }
    for one in force_entries(printed):
        yield from on_strokes(one)
