"""What can stand in a table of the arc crank or the parallel crank: one entry each, with its formulas."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import cache
from typing import Any

from kurbel.exact.numerals import Label
from kurbel.kernel import linkage
from kurbel.kernel.linkage import Place
from kurbel.kernel.parallel import coupler
from kurbel.linkage.arc import ArcCrank
from kurbel.linkage.evaluation import STROKE, At
from kurbel.motion.evaluation import OUT, RETURN, STROKES
from kurbel.motion.quantities import newton_metres, newtons
from kurbel.page.quantity import Formula, Quantity, Words, words

DECIMALS, ANGLE_DECIMALS = 4, 3
# What quantities are of that one force calls up.
FORCE = "force"
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
        assert isinstance(at.drive, ArcCrank)
        return kernel(at.place, at.arc) / at.kind.of(at.drive.rocker)

    return call


def _of(kernel: Callable[..., Any]) -> Callable[[At], Any]:
    return lambda at: kernel(at.place, at.arc)


_OUT_PATH: Formulas = {
    "exact": Formula(_path, "{part} $x = B (θ_i - θ)$"),
    LEFT: Formula(_path, "{part} $x = B (θ - θ_i)$"),
}
_RETURN_PATH: Formulas = {
    "exact": Formula(_path, "{part} $x = B (θ - θ_o)$"),
    LEFT: Formula(_path, "{part} $x = B (θ_o - θ)$"),
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


@cache
def parallel_registry() -> Mapping[str, Quantity]:
    """Return every quantity of the parallel crank by its key."""
    return {one.key: one for one in (*_coupler_entries(), *_coupler_forces())}


def page_command(quantity: Quantity) -> str:
    """Return the command whose pages are about the quantity."""
    return "forces" if quantity.of == FORCE else "table"


def _arc_entries() -> Iterator[Quantity]:
    yield from _both(
        "path", "Weg auf dem Bogen|Path along the arc", "$x$", "$x/R$", "R",
        is_arc=True, of=STROKE, names=("path", "x"),
    )  # fmt: skip
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
    formula: Formula | None = None,
    decimals: int = DECIMALS,
    names: tuple[str, ...] = (),
    back: str = "",
    **rest: Any,
) -> Iterator[Quantity]:
    """Yield the quantity on the outstroke and, perhaps under the key `back`, on the return; without a formula
    it is the path."""
    for each, stroke, path in ((key, OUT, _OUT_PATH), (back or f"{key}_return", RETURN, _RETURN_PATH)):
        yield Quantity(
            key=each,
            name=words(name),
            symbol=symbol,
            unit=words(unit),
            decimals=decimals,
            formulas={"exact": formula} if formula else path,
            heading=words(heading),
            spanners=(words(name), STROKES[stroke]),
            part=STROKES[stroke],
            stroke=stroke,
            names=names if stroke == OUT else (),
            **rest,
        )


# Key, name, letter, printed formula, in which direction it is positive, and the kernel's.
_FORCES: tuple[tuple[str, str, str, Label, str, Callable[[Place[Any]], Any]], ...] = (
    (
        "rod_force", "Stangenkraft|Rod force", "S", "$S/F = 1/(cos τ)$",
        "$S$ am Stangenende, auf dem Hingang Druck, auf dem Rückgang Zug"
        "|$S$ at the rod's end, thrust on the outstroke, pull on the return",
        linkage.rod_force,
    ),
    (
        "guide_force", "Schwingenkraft|Rocker force", "N", "$N/F = tan τ$",
        "$N$ längs der Schwinge auf das Stangenende, nach der Seite, auf der in diesem Hub der Kurbelzapfen"
        " läuft"
        "|$N$ along the rocker on the rod's end, towards the side on which the crank pin runs in that stroke",
        linkage.rocker_force,
    ),
    (
        "tangential_force", "Tangentialkraft|Tangential force", "T", "$T/F = c/v = (sin(ζ + τ))/(cos τ)$",
        "$T$ im Drehsinn|$T$ as the crank turns", linkage.tangential_force,
    ),
    (
        "radial_force", "Radialkraft|Radial force", "Z", "$Z/F = (cos(ζ + τ))/(cos τ)$",
        "$Z$ nach der Welle hin|$Z$ towards the shaft", linkage.radial_force,
    ),
)  # fmt: skip
TORQUE = "Drehmoment|Torque"


def _arc_forces() -> Iterator[Quantity]:
    for key, name, letter, printed, direction, kernel in _FORCES:
        symbols = (_TAU,) if key in ("rod_force", "guide_force") else (_ZETA, _TAU)
        formula, said = Formula(_at_place(kernel), printed, symbols), words(direction)
        yield from _both(
            key, name, f"${letter}$", f"${letter}/F$", "$F$", formula, names=(key,), direction=said, of=FORCE
        )
        yield from _both(
            f"{key}_n", name, f"${letter}$", f"${letter}$ in N", "N", formula, 1, back=f"{key}_return_n",
            scale=newtons, needs="force", direction=said, of=FORCE,
        )  # fmt: skip
    torque = Formula(_at_place(linkage.tangential_force), "$M_d/(F R) = T/F$")
    yield from _both("torque", TORQUE, "$M_d$", "$M_d/(F R)$", "$F R$", torque, names=("torque",), of=FORCE)
    yield from _both(
        "torque_nm", TORQUE, "$M_d$", "$M_d$ in N m", "N m", torque, 1, back="torque_return_nm",
        scale=newton_metres, needs="torque", of=FORCE,
    )  # fmt: skip


def _at_place(kernel: Callable[[Place[Any]], Any]) -> Callable[[At], Any]:
    return lambda at: kernel(at.place)


_ALONG = words("längs der Wellenlinie|along the line of shafts")
_ACROSS = words("quer zur Wellenlinie|square to the line of shafts")
_PATH, _SPEED, _GAIN = "Weg|Path", "Geschwindigkeit|Velocity", "Beschleunigung|Acceleration"
# Field of Coupler, direction, name, symbol, heading, value, unit.
_COUPLER: tuple[tuple[str, Words, str, str, str, str, str], ...] = (
    ("path", _ALONG, _PATH, "x", "x/R", "1 - cos φ", "R"),
    ("velocity", _ALONG, _SPEED, "c_x", "c_x/v", "sin φ", "v"),
    ("acceleration", _ALONG, _GAIN, "p_x", "(p_x R)/v^2", "cos φ", "v²/R"),
    ("rise", _ACROSS, _PATH, "y", "y/R", "sin φ", "R"),
    ("rise_velocity", _ACROSS, _SPEED, "c_y", "c_y/v", "cos φ", "v"),
    ("rise_acceleration", _ACROSS, _GAIN, "p_y", "(p_y R)/v^2", "-sin φ", "v²/R"),
)


def _coupler_entries() -> Iterator[Quantity]:
    for field, part, name, symbol, heading, printed, unit in _COUPLER:
        yield Quantity(
            key=f"coupler_{field}",
            name=words(name),
            symbol=f"${symbol}$",
            unit=words(unit),
            decimals=DECIMALS,
            formulas={"exact": Formula(_field(field), f"${heading} = {printed}$")},
            heading=words(f"${heading}$"),
            spanners=(part, words(name)),
            part=part,
        )


def _coupler_forces() -> Iterator[Quantity]:
    printed = {"tangential_force": "sin φ", "radial_force": "cos φ"}
    for key, name, letter, _, direction, kernel in _FORCES:
        if key in printed:
            formula = Formula(_at_place(kernel), f"${letter}/F = {printed[key]}$")
            yield _single(key, name, letter, f"{letter}/F", "$F$", formula, direction=words(direction))
            yield _single(
                f"{key}_n", name, letter, "", "N", formula, 1, direction=words(direction), scale=newtons,
                needs="force",
            )  # fmt: skip
    torque = Formula(_at_place(linkage.tangential_force), "$M_d/(F R) = T/F$")
    yield _single("torque", TORQUE, "M_d", "M_d/(F R)", "$F R$", torque)
    yield _single("torque_nm", TORQUE, "M_d", "", "N m", torque, 1, scale=newton_metres, needs="torque")


def _single(
    key: str, name: str, letter: str, share: str, unit: str, formula: Formula, decimals: int = DECIMALS,
    **rest: Any,
) -> Quantity:  # fmt: skip
    """A force on the crank, over the whole turn: as a share of F, or in its unit."""
    return Quantity(
        key=key,
        name=words(name),
        symbol=f"${letter}$",
        unit=words(unit),
        decimals=decimals,
        formulas={"exact": formula},
        heading=words(f"${share}$" if share else f"${letter}$ in {unit}"),
        spanners=(words(name),),
        of=FORCE,
        **rest,
    )


def _field(name: str) -> Callable[[At], Any]:
    return lambda at: getattr(coupler(at.circle), name)
