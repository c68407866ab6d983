"""What can stand in a table of the straight or offset crank: motion, and the forces of the drive."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from functools import cache
from typing import Any, NamedTuple

from kurbel.drive.at import CRANK_FORCES, At, CrankForce, turns_a_minute
from kurbel.drive.crank import Crank
from kurbel.exact.numerals import Label
from kurbel.kernel.circle import Numeric
from kurbel.motion.entries import Formulas, motion_entries, on_strokes, spanned, speed_entries
from kurbel.motion.evaluation import LOADED, OFFSET, TANGENT, Needs
from kurbel.page.quantity import Formula, Need, Quantity, words


@cache
def registry() -> Mapping[str, Quantity]:
    """Return every quantity by its key, in the order in which `kurbel quantities` lists them."""
    entries = (*motion_entries(), *_force_entries())
    of_strokes = [one for each in entries for one in on_strokes(each)]
    found = {one.key: one for one in (*of_strokes, *speed_entries())}
    # What acts along the slide has pages of its own.
    return {**{key: one for key, one in found.items() if not _of_effort(key)}, **found}


@cache
def effort_keys() -> tuple[str, ...]:
    """Return the keys of what acts along the slide: the effort on the piston, and its parts."""
    return tuple(key for key in registry() if _of_effort(key))


def _of_effort(key: str) -> bool:
    return re.sub(_UNIT, "", key).removesuffix("_return") in EFFORT


class Force(NamedTuple):
    """A force of the drive: name, letter, in which direction it is positive; what is printed of it, also of
    the offset crank and, in closed form, where the rod touches the crank circle, if one force calls it up;
    else what it needs to be known."""

    name: str
    letter: str
    direction: str
    printed: Label = ""
    oblique: Label = ""
    closed: Label = ""
    needs: Need = Needs.MASSES


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
    # What acts along the slide, in its parts.
    "piston_force": Force(
        "Kolbenkraft|Piston force", "F", "$F$ auf den Kolben|$F$ on the piston", needs=Needs.FORCE
    ),
    "inertia_force": Force(
        "Massenkraft|Inertia force", "F_m",
        "$F_m$ der hin- und hergehenden Massen, ohne die Stange"
        "|$F_m$ of the reciprocating masses, without the rod",
    ),
    "weight_force": Force(
        "Gewicht|Weight", "F_G",
        "$F_G$ Gewicht von Kolben und Kreuzkopf längs der Führung"
        "|$F_G$ weight of piston and crosshead along the slide", needs=Needs.WEIGHT,
    ),
    "friction_force": Force(
        "Reibung|Friction", "F_R",
        "$F_R$ Reibung von Kolben und Kreuzkopf, im Totpunkt die des Hubes, der dort beginnt"
        "|$F_R$ friction of piston and crosshead, at a dead centre that of the stroke which begins there",
        needs=Needs.FRICTION,
    ),
    "crosshead_load": Force(
        "Last am Kreuzkopfzapfen|Load at the crosshead pin", "F_B",
        "$F_B$ Summe der Kräfte am Kreuzkopfzapfen, alle in der Richtung des Hubes, beim Hingang zur Welle"
        " hin|$F_B$ sum of the forces at the crosshead pin, all in the direction of the stroke, on the"
        " outstroke towards the shaft", needs=Needs.FORCE,
    ),
}  # fmt: skip


EFFORT = (
    "piston_force", "inertia_force", "weight_force", "friction_force", "crosshead_load", "net_torque",
    "angular_acceleration", "reversing_speed",
)  # fmt: skip
_UNIT = "_nm?$"


def _force_entries() -> Iterator[Quantity]:
    for key, one in FORCES.items():
        shares = _unloaded(key, one.printed, one.oblique, one.closed) if one.printed else {}
        yield from force_entries(key, one, shares, in_newtons(key, shares))
    ratio = "$M_d/(F R) = T/F$"
    torque = _unloaded("tangential_force", ratio, ratio, "F R sqrt((R/L)^2 + 1)")
    yield from torque_entries(torque, in_newtons("tangential_force", torque))
    yield spanned(
        "net_torque_nm", "Drehmoment nach der Zapfenreibung|Torque less the friction of the pins", "$M_R$",
        "$M_R$ in N m", "N m", 1, {LOADED: Formula(At.net_torque)}, scale=Crank.newton_metres,
        needs=(Needs.PINS,),
    )  # fmt: skip
    yield spanned(
        "reversing_speed", "Drehzahl des Druckwechsels|Speed of the reversal", "$n_w$",
        '$n_w$ in $"min"^(-1)$', '$"min"^(-1)$', 1, {LOADED: Formula(At.reversal)}, scale=turns_a_minute,
        needs=(Needs.MASSES,), exists=At.reverses,
        direction=words(
            "$n_w$ Drehzahl, bei der $F_B$ dort verschwindet; – bei keiner"
            "|$n_w$ speed at which $F_B$ vanishes there; – at none"
        ),
    )  # fmt: skip
    yield spanned(
        "angular_acceleration", "Winkelbeschleunigung der Welle|Angular acceleration of the shaft", "$α$",
        "$α$ in rad/s²", "rad/s²", 2, {LOADED: Formula(At.shaft_torque)}, scale=Crank.shaft_gain,
        needs=(Needs.SHAFT, Needs.LENGTH),
    )  # fmt: skip


def force_entries(
    key: str, force: Force, shares: Formulas, newton: Formulas, **rest: Any
) -> Iterator[Quantity]:
    """Yield a force as a share of the piston force, if that alone calls it up, and in newtons."""
    name, symbol, said = force.name, f"${force.letter}$", words(force.direction)
    if shares:
        share = f"${force.letter}/F$"
        yield spanned(key, name, symbol, share, "$F$", 4, shares, names=(key,), direction=said, **rest)
    needs = (Needs.FORCE if shares else force.needs,)
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
        needs=(Needs.FORCE, Needs.LENGTH), **rest,
    )  # fmt: skip


def _crank_force(key: str) -> CrankForce:
    # A table of the motion needs none.
    return CRANK_FORCES[key]


def _unloaded(key: str, printed: Label, oblique: Label, closed: Label) -> Formulas:
    def call(at: At) -> Numeric:
        return _crank_force(key).bare(at.circle, at.ratio, at.offset)

    formulas = {"exact": printed, "infinite": "", OFFSET: oblique, TANGENT: closed}
    return {method: Formula(call, text) for method, text in formulas.items()}


def in_newtons(key: str, shares: Formulas) -> Formulas:
    """Return the formulas of the force that acts at the place, with masses too, which no line holds."""

    def call(at: At) -> Numeric:
        force = _crank_force(key)
        return force.on(at.on_shaft if force.on_shaft else at.loaded)

    def acting(share: Formula) -> Formula:
        return share._replace(kernel=lambda at: at.acting(share.kernel(at)))

    return {**{method: acting(one) for method, one in shares.items()}, LOADED: Formula(call)}
