"""What can stand in a table of the straight or offset crank: motion, and the forces of the drive."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from functools import cache
from typing import TYPE_CHECKING, Any, NamedTuple

from kurbel.drive.crank import Crank
from kurbel.exact.numerals import Label
from kurbel.kernel import kinematics
from kurbel.motion.evaluation import LOADED, OFFSET, OUT, RETURN, STROKES, TANGENT, TURN, At
from kurbel.page.quantity import Formula, Quantity, entry, words

if TYPE_CHECKING:
    from kurbel.drive.crank_forces import CrankForce

Formulas = Mapping[str, Formula]
Kernel = Callable[..., Any]
# What keys say of their unit at their end.
_UNIT = re.compile(r"_(?:mm|mps2?|nm?|stroke|percent)$")

# In printed formulas {±} is the sign that the return stroke changes, {ψ} the same where ψ itself is printed
# (cos ψ knows no sign), {angle} the letter of the crank angle.


def _motion(straight: Kernel, series: Kernel, offset: Kernel, *printed: Label) -> Formulas:
    """Return the formulas by the methods exact, series and infinite, and of the offset crank, as printed."""

    def exact(at: At) -> Any:
        return straight(at.circle, at.ratio)

    kernels = {
        "exact": exact,
        "series": lambda at: series(at.circle, at.ratio),
        "infinite": exact,
        OFFSET: lambda at: offset(at.circle, at.ratio, at.offset),
    }
    return {key: Formula(one, text) for (key, one), text in zip(kernels.items(), printed, strict=True)}


PATH = _motion(
    kinematics.piston_path,
    kinematics.piston_path_first_order,
    kinematics.offset_path,
    "$x/R = 1 - cos {angle} {±} (1 - cos ψ)/λ$",
    "$x/R = 1 - cos {angle} {±} 1/2 λ sin^2 {angle}$",
    "$x/R = 1 - cos {angle}$",
    "$x/R = (cos φ_i - cos {angle}) + (cos ψ_i - cos ψ)/λ$",
)
VELOCITY = _motion(
    kinematics.piston_velocity,
    kinematics.piston_velocity_first_order,
    kinematics.offset_velocity,
    "$c/v = sin {angle} {±} (λ sin {angle} cos {angle})/(cos ψ)$",
    "$c/v = sin {angle} {±} 1/2 λ sin 2 {angle}$",
    "$c/v = sin {angle}$",
    "$c/v = sin {angle} + cos {angle} tan ψ$",
)
ACCELERATION = _motion(
    kinematics.piston_acceleration,
    kinematics.piston_acceleration_first_order,
    kinematics.offset_acceleration,
    "$(p R)/v^2 = cos {angle} {±} λ (cos 2 {angle} + λ^2 sin^4 {angle})/(cos^3 ψ)$",
    "$(p R)/v^2 = cos {angle} {±} λ cos 2 {angle}$",
    "$(p R)/v^2 = cos {angle}$",
    "$(p R)/v^2 = cos {angle} - sin {angle} tan ψ + λ (cos^2 {angle})/(cos^3 ψ)$",
)


def _rod_angle(at: At) -> Any:
    return at.numbers.rod_angle(at.circle, at.ratio, at.offset)


# The rod angle enters the first-order formulas nowhere; it is the same arc by every method.
ROD_ANGLE: Formulas = {
    "exact": Formula(_rod_angle),
    "series": Formula(_rod_angle, "$sin ψ = {ψ}λ sin {angle}$"),
    "infinite": Formula(_rod_angle, "$ψ = 0$"),
    OFFSET: Formula(_rod_angle),
    TANGENT: Formula(lambda slant: slant, "arctan(R/L)"),
}


@cache
def registry() -> Mapping[str, Quantity]:
    """Return every quantity by its key, in the order in which `kurbel quantities` lists them."""
    entries = (*_motion_entries(), *_force_entries())
    of_strokes = [one for each in entries for one in on_strokes(each)]
    return {one.key: one for one in (*of_strokes, *_speed_entries())}


def _motion_entries() -> Iterator[Quantity]:
    path, velocity = "Kolbenweg|Piston path", "Kolbengeschwindigkeit|Piston velocity"
    acceleration = "Kolbenbeschleunigung|Piston acceleration"
    yield spanned("x", path, "$x$", "$x/R$", "$R$", 4, PATH, names=("x",), rises=True)
    yield spanned(
        "x_stroke", path, "$x$", "in Teilen des Hubes|in strokes", "Hub|stroke", 4, PATH,
        scale=lambda crank, numbers: 1 / crank.stroke(numbers), names=("s",), rises=True,
    )  # fmt: skip
    yield spanned(
        "x_percent", path, "$x$", "in % des Hubes|in % of stroke", "% des Hubes|% of the stroke", 2, PATH,
        scale=lambda crank, numbers: 100 / crank.stroke(numbers),
    )  # fmt: skip
    yield spanned("x_mm", path, "$x$", "$x$ in mm", "mm", 2, PATH, scale=Crank.millimetres, needs="length")
    yield spanned("c", velocity, "$c$", "$c/v$", "$v$", 4, VELOCITY, names=("c",))
    yield spanned(
        "c_mps", velocity, "$c$", "$c$ in m/s", "m/s", 3, VELOCITY, scale=Crank.pin_velocity, needs="speed"
    )
    yield spanned("p", acceleration, "$p$", "$(p R)/v^2$", "v²/R", 4, ACCELERATION, names=("p",))
    yield spanned(
        "p_mps2", acceleration, "$p$", "$p$ in m/s²", "m/s²", 2, ACCELERATION, scale=Crank.pin_acceleration,
        needs="speed",
    )  # fmt: skip
    yield spanned(
        "psi", "Schubstangenwinkel|Rod angle", "$ψ$", "$ψ$ in °", "°", 3, ROD_ANGLE,
        is_arc=True, bound=60.0, names=("psi", "ψ"),
    )  # fmt: skip


def _speed_entries() -> Iterator[Quantity]:
    """Yield what is one number for the whole turn: its scale."""
    for key, name, head, unit, printed, oblique, scale, needs in (
        (
            "v_mps", "Kurbelzapfengeschwindigkeit|Crank-pin velocity", "v", "m/s", " = (S π n)/60",
            " = (R π n)/30", Crank.pin_velocity, "speed",
        ),
        (
            "c_m_mps", "Mittlere Kolbengeschwindigkeit|Mean piston speed", "c_m", "m/s", " = (S n)/30",
            " = (S n)/30", Crank.mean_velocity, "mean speed",
        ),
        (
            "v_c_m", "Verhältnis der Geschwindigkeiten|Ratio of the velocities", "v:c_m", "", " = π:2",
            " = π R:S", Crank.pin_to_mean, "",
        ),
    ):  # fmt: skip
        one = Formula(lambda at: at.numbers.of(Fraction(1)), f"${head}{printed}$")
        formulas = {
            "exact": one,
            "series": one,
            "infinite": one,
            OFFSET: one._replace(printed=f"${head}{oblique}$"),
        }
        yield spanned(
            key, name, f"${head}$", f"${head}$" + (unit and f" in {unit}"), unit, 3 if unit else 4, formulas,
            stroke=TURN, is_arc=not unit, scale=scale, needs=needs,
        )  # fmt: skip


class Force(NamedTuple):
    """A force of the drive: name, letter, in which direction it is positive; what is printed of it, also of
    the offset crank and, in closed form, where the rod touches the crank circle, if one force calls it up."""

    name: str
    letter: str
    direction: str
    printed: Label = ""
    oblique: Label = ""
    closed: Label = ""


# Where masses count, those at the end show what one force alone does not.
FORCES: Mapping[str, Force] = {
    "rod_force": Force(
        "Stangenkraft|Rod force", "S",
        "$S$ am Kreuzkopf, auf dem Hingang Druck, auf dem Rückgang Zug"
        "|$S$ at the crosshead, thrust on the outstroke, pull on the return",
        "$S/F = 1/(cos ψ)$", "$S/F = 1/(cos ψ)$", "F sqrt((R/L)^2 + 1)",
    ),
    "guide_force": Force(
        "Führungsdruck|Guide force", "N",
        "$N$ auf den Kreuzkopf, nach der Seite, auf der in diesem Hub der Kurbelzapfen läuft"
        "|$N$ on the crosshead, towards the side on which the crank pin runs in that stroke",
        "$N/F = {guide}tan ψ$", "$N/F = tan ψ$", "(F R)/L",
    ),
    "tangential_force": Force(
        "Tangentialkraft|Tangential force", "T", "$T$ im Drehsinn|$T$ as the crank turns",
        "$T/F = sin({angle} {slant} ψ)/(cos ψ)$", "$T/F = sin({angle} + ψ)/(cos ψ)$", "F sqrt((R/L)^2 + 1)",
    ),
    "radial_force": Force(
        "Radialkraft|Radial force", "Z", "$Z$ nach der Welle hin|$Z$ towards the shaft",
        "$Z/F = cos({angle} {slant} ψ)/(cos ψ)$", "$Z/F = cos({angle} + ψ)/(cos ψ)$", "0",
    ),
    "crosshead_pin_force": Force(
        "Kraft am Kreuzkopfzapfen|Crosshead-pin force", "B",
        "$B$ Betrag am Kreuzkopfzapfen|$B$ magnitude at the crosshead pin",
    ),
    "crank_pin_force": Force(
        "Kraft am Kurbelzapfen|Crank-pin force", "K",
        "$K$ Betrag am Kurbelzapfen|$K$ magnitude at the crank pin",
    ),
    "bearing_along": Force(
        "Lagerkraft längs|Bearing force along", "H_x",
        "$H_x$ auf das Hauptlager, in der Richtung des Hubes"
        "|$H_x$ on the main bearing, in the direction of the stroke",
    ),
    "bearing_across": Force(
        "Lagerkraft quer|Bearing force across", "H_y",
        "$H_y$ auf das Hauptlager, nach der Seite des Kurbelzapfens"
        "|$H_y$ on the main bearing, towards the side of the crank pin",
    ),
    "bearing_force": Force(
        "Lagerkraft|Bearing force", "H", "$H$ Betrag am Hauptlager|$H$ magnitude at the main bearing"
    ),
}  # fmt: skip


def _force_entries() -> Iterator[Quantity]:
    for key, one in FORCES.items():
        shares = _unloaded(key, one.printed, one.oblique, one.closed) if one.printed else {}
        yield from force_entries(key, one, shares, _in_newtons(key, shares))
    ratio = "$M_d/(F R) = T/F$"
    torque = _unloaded("tangential_force", ratio, ratio, "F R sqrt((R/L)^2 + 1)")
    yield from torque_entries(torque, _in_newtons("tangential_force", torque))


def force_entries(
    key: str, force: Force, shares: Formulas, newton: Formulas, **rest: Any
) -> Iterator[Quantity]:
    """Yield a force as a share of the piston force, if that alone calls it up, and in newtons."""
    name, symbol, said = force.name, f"${force.letter}$", words(force.direction)
    if shares:
        share = f"${force.letter}/F$"
        yield spanned(key, name, symbol, share, "$F$", 4, shares, names=(key,), direction=said, **rest)
    needs = "force" if shares else "masses"
    yield spanned(
        f"{key}_n", name, symbol, f"{symbol} in N", "N", 1, newton, scale=Crank.newtons, needs=needs,
        direction=said, **rest,
    )  # fmt: skip


def torque_entries(shares: Formulas, newton: Formulas, **rest: Any) -> Iterator[Quantity]:
    """Yield the torque as a share of F R and in newton metres."""
    name, symbol = "Drehmoment|Torque", "$M_d$"
    yield spanned("torque", name, symbol, "$M_d/(F R)$", "$F R$", 4, shares, names=("torque",), **rest)
    yield spanned(
        "torque_nm", name, symbol, "$M_d$ in N m", "N m", 1, newton, scale=Crank.newton_metres,
        needs="torque", **rest,
    )  # fmt: skip


def _crank_force(key: str) -> CrankForce:
    # A table of the motion needs none.
    from kurbel.drive.crank_forces import CRANK_FORCES

    return CRANK_FORCES[key]


def _unloaded(key: str, printed: Label, oblique: Label, closed: Label) -> Formulas:
    def call(at: At) -> Any:
        return _crank_force(key).bare(at.circle, at.ratio, at.offset)

    formulas = {"exact": printed, "infinite": "", OFFSET: oblique, TANGENT: closed}
    return {method: Formula(call, text) for method, text in formulas.items()}


def _in_newtons(key: str, shares: Formulas) -> Formulas:
    """Return the formulas of the force that acts at the place, with masses too, which no line holds."""

    def call(at: At) -> Any:
        force = _crank_force(key)
        return force.on(at.on_shaft if force.on_shaft else at.loaded)

    def acting(share: Formula) -> Formula:
        return Formula(lambda at: at.acting(share.kernel(at)), share.printed)

    return {**{method: acting(one) for method, one in shares.items()}, LOADED: Formula(call)}


def spanned(
    key: str,
    name: str,
    symbol: Label,
    heading: str,
    unit: str,
    decimals: int,
    formulas: Formulas,
    **rest: Any,
) -> Quantity:  # fmt: skip
    """Return an entry that stands under its name."""
    return entry(key, name, symbol, unit, decimals, formulas, heading, spanners=(words(name),), **rest)


def on_strokes(one: Quantity) -> Iterator[Quantity]:
    """Yield the quantity on the outstroke and, as x_return_mm, on the return."""
    stem = _UNIT.sub("", one.key)
    for key, stroke in ((one.key, OUT), (f"{stem}_return{one.key.removeprefix(stem)}", RETURN)):
        part = STROKES[stroke]
        yield one._replace(
            key=key,
            spanners=(*one.spanners, part),
            part=part,
            stroke=stroke,
            names=one.names if stroke == OUT else (),
        )
