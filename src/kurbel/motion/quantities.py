"""What can stand in a table of the straight or offset crank: motion, and the forces of the drive."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from functools import cache
from typing import Any

from kurbel.drive.crank import Crank
from kurbel.drive.crank_forces import CRANK_FORCES
from kurbel.exact.certify import Kind
from kurbel.exact.numerals import Label
from kurbel.kernel import forces, kinematics
from kurbel.motion.evaluation import (
    LOADED,
    OFFSET,
    OUT,
    RETURN,
    STROKES,
    TANGENT,
    At,
    pin_acceleration,
    pin_velocity,
)
from kurbel.page.quantity import Formula, Quantity, words

Formulas = Mapping[str, Formula]
Scale = Callable[[Crank, Kind], Any]
# What keys say of their unit at their end.
_UNIT = re.compile(r"_(?:mm|mps2?|nm?|stroke|percent)$")

# In printed formulas {±} is the sign that the return stroke changes, {ψ} the same where ψ itself is printed
# (cos ψ knows no sign), {angle} the letter of the crank angle.


def _motion(
    straight: Callable[..., Any],
    offset: Callable[..., Any],
    series: Callable[..., Any],
    printed: Mapping[str, Label],
) -> Formulas:
    def exact(at: At) -> Any:
        return straight(at.circle, at.ratio)

    return {
        "exact": Formula(exact, printed["exact"]),
        "series": Formula(lambda at: series(at.circle, at.ratio), printed["series"]),
        "infinite": Formula(exact, printed["infinite"]),
        OFFSET: Formula(lambda at: offset(at.circle, at.ratio, at.offset), printed[OFFSET]),
    }


PATH = _motion(
    kinematics.piston_path,
    kinematics.offset_path,
    kinematics.piston_path_first_order,
    {
        "exact": "$x/R = 1 - cos {angle} {±} (1 - cos ψ)/λ$",
        "series": "$x/R = 1 - cos {angle} {±} 1/2 λ sin^2 {angle}$",
        "infinite": "$x/R = 1 - cos {angle}$",
        OFFSET: "$x/R = (cos φ_i - cos {angle}) + (cos ψ_i - cos ψ)/λ$",
    },
)
VELOCITY = _motion(
    kinematics.piston_velocity,
    kinematics.offset_velocity,
    kinematics.piston_velocity_first_order,
    {
        "exact": "$c/v = sin {angle} {±} (λ sin {angle} cos {angle})/(cos ψ)$",
        "series": "$c/v = sin {angle} {±} 1/2 λ sin 2 {angle}$",
        "infinite": "$c/v = sin {angle}$",
        OFFSET: "$c/v = sin {angle} + cos {angle} tan ψ$",
    },
)
ACCELERATION = _motion(
    kinematics.piston_acceleration,
    kinematics.offset_acceleration,
    kinematics.piston_acceleration_first_order,
    {
        "exact": "$(p R)/v^2 = cos {angle} {±} λ (cos 2 {angle} + λ^2 sin^4 {angle})/(cos^3 ψ)$",
        "series": "$(p R)/v^2 = cos {angle} {±} λ cos 2 {angle}$",
        "infinite": "$(p R)/v^2 = cos {angle}$",
        OFFSET: "$(p R)/v^2 = cos {angle} - sin {angle} tan ψ + λ (cos^2 {angle})/(cos^3 ψ)$",
    },
)


def _rod_angle(at: At) -> Any:
    assert at.numbers.rod_angle is not None
    return at.numbers.rod_angle(at.circle, at.ratio, at.offset)


# The rod angle enters the first-order formulas nowhere; it is the same arc by every method.
ROD_ANGLE: Formulas = {
    "exact": Formula(_rod_angle),
    "series": Formula(_rod_angle, "$sin ψ = {ψ}λ sin {angle}$"),
    "infinite": Formula(_rod_angle, "$ψ = 0$"),
    OFFSET: Formula(_rod_angle),
    TANGENT: Formula(lambda slant: slant, "arctan(R/L)"),
}


def _share_of_stroke(share: int) -> Scale:
    def scale(crank: Crank, numbers: Kind) -> Any:
        if not crank.offset:
            return numbers.of(Fraction(share, 2))
        return share / kinematics.stroke(numbers.of(crank.ratio), numbers.of(crank.offset))

    return scale


def _millimetres(crank: Crank, numbers: Kind) -> Any:
    assert crank.radius is not None
    return numbers.of(1000 * crank.radius)


def newtons(crank: Crank, numbers: Kind) -> Any:
    """What makes newtons of a unit force; forces of moving masses are in newtons as they are."""
    if crank.moving is not None:
        return numbers.of(Fraction(1))
    assert crank.force is not None
    return numbers.of(crank.force.first)


def newton_metres(crank: Crank, numbers: Kind) -> Any:
    assert crank.radius is not None
    return newtons(crank, numbers) * numbers.of(crank.radius)


@cache
def registry() -> Mapping[str, Quantity]:
    """Return every quantity by its key, in the order in which `kurbel quantities` lists them."""
    return {entry.key: entry for entry in (*_motion_entries(), *_force_entries())}


def _motion_entries() -> Iterator[Quantity]:
    path, velocity, acceleration = (
        "Kolbenweg|Piston path",
        "Kolbengeschwindigkeit|Piston velocity",
        ("Kolbenbeschleunigung|Piston acceleration"),
    )
    yield from _both("x", path, "$x$", "$x/R$", "$R$", 4, PATH, names=("x",))
    yield from _both(
        "x_stroke", path, "$x$", "in Teilen des Hubes|in strokes", "Hub|stroke", 4, PATH,
        scale=_share_of_stroke(1), names=("s",),
    )  # fmt: skip
    yield from _both(
        "x_percent", path, "$x$", "in % des Hubes|in % of stroke", "% des Hubes|% of the stroke", 2, PATH,
        scale=_share_of_stroke(100),
    )  # fmt: skip
    yield from _both("x_mm", path, "$x$", "$x$ in mm", "mm", 2, PATH, scale=_millimetres, needs="length")
    yield from _both("c", velocity, "$c$", "$c/v$", "$v$", 4, VELOCITY, names=("c",))
    yield from _both(
        "c_mps", velocity, "$c$", "$c$ in m/s", "m/s", 3, VELOCITY, scale=pin_velocity, needs="speed"
    )
    yield from _both("p", acceleration, "$p$", "$(p R)/v^2$", "v²/R", 4, ACCELERATION, names=("p",))
    yield from _both(
        "p_mps2", acceleration, "$p$", "$p$ in m/s²", "m/s²", 2, ACCELERATION, scale=pin_acceleration,
        needs="speed",
    )  # fmt: skip
    yield from _both(
        "psi", "Schubstangenwinkel|Rod angle", "$ψ$", "$ψ$ in °", "°", 3, ROD_ANGLE,
        is_arc=True, bound=60.0, names=("psi", "ψ"),
    )  # fmt: skip


# The forces that one piston force F calls up: key, name, letter, printed formula, that of the offset crank,
# the closed form where the rod touches the crank circle, kernel, and in which direction it is positive.
_FORCES: tuple[tuple[str, str, str, Label, Label, Label, Callable[..., Any], str], ...] = (
    (
        "rod_force", "Stangenkraft|Rod force", "S", "$S/F = 1/(cos ψ)$", "$S/F = 1/(cos ψ)$",
        "F sqrt((R/L)^2 + 1)",
        forces.rod_force,
        "$S$ am Kreuzkopf, auf dem Hingang Druck, auf dem Rückgang Zug"
        "|$S$ at the crosshead, thrust on the outstroke, pull on the return",
    ),
    (
        "guide_force", "Führungsdruck|Guide force", "N", "$N/F = {guide}tan ψ$", "$N/F = tan ψ$",
        "(F R)/L",
        forces.guide_force,
        "$N$ auf den Kreuzkopf, nach der Seite, auf der in diesem Hub der Kurbelzapfen läuft"
        "|$N$ on the crosshead, towards the side on which the crank pin runs in that stroke",
    ),
    (
        "tangential_force", "Tangentialkraft|Tangential force", "T",
        "$T/F = sin({angle} {slant} ψ)/(cos ψ)$", "$T/F = sin({angle} + ψ)/(cos ψ)$",
        "F sqrt((R/L)^2 + 1)",
        forces.tangential_force, "$T$ im Drehsinn|$T$ as the crank turns",
    ),
    (
        "radial_force", "Radialkraft|Radial force", "Z",
        "$Z/F = cos({angle} {slant} ψ)/(cos ψ)$", "$Z/F = cos({angle} + ψ)/(cos ψ)$", "0",
        forces.radial_force, "$Z$ nach der Welle hin|$Z$ towards the shaft",
    ),
)  # fmt: skip
# Where masses count, what one force alone does not show.
_PIN_FORCES = (
    (
        "crosshead_pin_force", "Kraft am Kreuzkopfzapfen|Crosshead-pin force", "B",
        "$B$ Betrag am Kreuzkopfzapfen|$B$ magnitude at the crosshead pin",
    ),
    (
        "crank_pin_force", "Kraft am Kurbelzapfen|Crank-pin force", "K",
        "$K$ Betrag am Kurbelzapfen|$K$ magnitude at the crank pin",
    ),
    (
        "bearing_along", "Lagerkraft längs|Bearing force along", "H_x",
        "$H_x$ auf das Hauptlager, in der Richtung des Hubes"
        "|$H_x$ on the main bearing, in the direction of the stroke",
    ),
    (
        "bearing_across", "Lagerkraft quer|Bearing force across", "H_y",
        "$H_y$ auf das Hauptlager, nach der Seite des Kurbelzapfens"
        "|$H_y$ on the main bearing, towards the side of the crank pin",
    ),
    (
        "bearing_force", "Lagerkraft|Bearing force", "H",
        "$H$ Betrag am Hauptlager|$H$ magnitude at the main bearing",
    ),
)  # fmt: skip


def _force_entries() -> Iterator[Quantity]:
    for key, name, letter, printed, oblique, closed, kernel, direction in _FORCES:
        unloaded = _unloaded(kernel, printed, oblique, closed)
        yield from _both(
            key, name, f"${letter}$", f"${letter}/F$", "$F$", 4, unloaded, names=(key,),
            direction=words(direction),
        )  # fmt: skip
        yield from _in_newtons(key, name, letter, "force", unloaded, direction)
    for key, name, letter, direction in _PIN_FORCES:
        yield from _in_newtons(key, name, letter, "masses", {}, direction)
    name = "Drehmoment|Torque"
    torque = _unloaded(
        forces.tangential_force, "$M_d/(F R) = T/F$", "$M_d/(F R) = T/F$", "F R sqrt((R/L)^2 + 1)"
    )
    yield from _both("torque", name, "$M_d$", "$M_d/(F R)$", "$F R$", 4, torque, names=("torque",))
    yield from _both(
        "torque_nm", name, "$M_d$", "$M_d$ in N m", "N m", 1,
        {**_acting(torque), **_loaded("tangential_force")}, scale=newton_metres, needs="torque",
    )  # fmt: skip


def _in_newtons(
    key: str, name: str, letter: str, needs: str, formulas: dict[str, Formula], direction: str
) -> Iterator[Quantity]:
    return _both(
        f"{key}_n", name, f"${letter}$", f"${letter}$ in N", "N", 1, {**_acting(formulas), **_loaded(key)},
        scale=newtons, needs=needs, direction=words(direction),
    )  # fmt: skip


def _acting(formulas: Formulas) -> Formulas:
    """Return the formulas in the first piston force, of the force that acts at the place."""
    return {key: Formula(_at_place(one.kernel), one.printed) for key, one in formulas.items()}


def _at_place(kernel: Callable[[At], Any]) -> Callable[[At], Any]:
    return lambda at: at.acting(kernel(at))


def _unloaded(
    kernel: Callable[..., Any], printed: Label, oblique: Label, closed: Label
) -> dict[str, Formula]:
    def call(at: At) -> Any:
        return kernel(at.circle, at.ratio, at.offset)

    formulas = {"exact": printed, "infinite": "", OFFSET: oblique, TANGENT: closed}
    return {key: Formula(call, text) for key, text in formulas.items()}


def _loaded(key: str) -> dict[str, Formula]:
    """The force in newtons, of the piston force and of the moving masses, which no line holds."""
    force = CRANK_FORCES[key]

    def call(at: At) -> Any:
        crank, of = at.crank, at.numbers.of
        assert crank.moving is not None
        weights = crank.moving.weights(of, pin_acceleration(crank, at.numbers))
        net = at.acting(of(crank.force.first if crank.force else Fraction(0)))
        return force.loaded(at.circle, at.ratio, weights, at.offset, net)

    return {LOADED: Formula(call)}


def entry(
    key: str,
    name: str,
    symbol: Label,
    heading: str,
    unit: str,
    decimals: int,
    formulas: Formulas,
    **rest: Any,
) -> Quantity:
    """Return an entry, whose texts are "German|English", under its name."""
    return Quantity(
        key=key,
        name=words(name),
        symbol=symbol,
        unit=words(unit),
        decimals=decimals,
        formulas=formulas,
        heading=words(heading),
        spanners=(words(name),),
        **rest,
    )


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


def _both(*said: Any, **rest: Any) -> Iterator[Quantity]:
    return on_strokes(entry(*said, **rest))
