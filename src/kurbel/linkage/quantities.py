"""What can stand in a table of the arc crank or the parallel crank: symbols, names, units and digits."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from functools import cache
from typing import NamedTuple

from kurbel.exact.numerals import Label
from kurbel.linkage.arc import MOTIONS, ArcCrank, certified, certified_coupler
from kurbel.motion.evaluation import OUT, RETURN, STROKES

# From the drive, the crank angle in degrees, the decimals and the rounding to the scaled digits; the parallel
# crank is the same whatever its lengths.
Digits = Callable[[ArcCrank | None, Fraction, int, str], int]


class LinkageQuantity(NamedTuple):
    """An entry of a registry. `motion` is its key in the kernel, `part` the stroke or the direction.

    `spanners` stand above its heading, outermost first.
    """

    key: str
    motion: str
    name: Mapping[str, str]
    part: Mapping[str, str]
    spanners: tuple[Mapping[str, str], ...]
    symbol: Label
    heading: Label
    unit: str
    decimals: int
    digits: Digits
    stroke: int = OUT

    def full_name(self, lang: str) -> str:
        return f"{self.name[lang]}, {self.part[lang]}"


# Key in MOTIONS, symbol, heading, name.
_ARC: tuple[tuple[str, Label, Label, str], ...] = (
    ("path", "$x$", "$x/R$", "Weg auf dem Bogen|Path along the arc"),
    ("velocity", "$c$", "$c/v$", "Geschwindigkeit|Velocity"),
    ("acceleration", "$p$", "$(p R)/v^2$", "Beschleunigung|Acceleration"),
    ("rocker", "$θ$", "$θ$ in °", "Schwingenwinkel|Rocker angle"),
    ("rod", "$ψ$", "$ψ$ in °", "Schubstangenwinkel|Rod angle"),
    ("slant", "$τ$", "$τ$ in °", "Stange gegen Bogen|Rod against arc"),
    ("chord", "$q$", "$q/R$", "Sehne des Weges|Chord of the path"),
    ("slide_path", "$x_s$", "$x_s/R$", "Weg längs der Schubrichtung|Path along the slide"),
    ("rise", "$y_s$", "$y_s/R$", "Weg quer zur Schubrichtung|Path across the slide"),
    ("turn", "$ϑ$", "$ϑ$ in °", "Drehung der Schwinge|Turn of the rocker"),
    (
        "turn_velocity", "$ω_B$", "$ω_B/ω$",
        "Winkelgeschwindigkeit der Schwinge|Angular velocity of the rocker",
    ),
    (
        "turn_acceleration", "$ε_B$", "$ε_B/ω^2$",
        "Winkelbeschleunigung der Schwinge|Angular acceleration of the rocker",
    ),
    ("rod_velocity", "$ω_L$", "$ω_L/ω$", "Winkelgeschwindigkeit der Stange|Angular velocity of the rod"),
    (
        "rod_acceleration", "$ε_L$", "$ε_L/ω^2$",
        "Winkelbeschleunigung der Stange|Angular acceleration of the rod",
    ),
)  # fmt: skip
_ALONG = "längs der Wellenlinie|along the line of shafts"
_ACROSS = "quer zur Wellenlinie|square to the line of shafts"
# Field of Coupler, symbol, heading, unit, name, direction.
_COUPLER: tuple[tuple[str, Label, Label, str, str, str], ...] = (
    ("path", "$x$", "$x/R$", "R", "Weg|Path", _ALONG),
    ("velocity", "$c_x$", "$c_x/v$", "v", "Geschwindigkeit|Velocity", _ALONG),
    ("acceleration", "$p_x$", "$(p_x R)/v^2$", "v²/R", "Beschleunigung|Acceleration", _ALONG),
    ("rise", "$y$", "$y/R$", "R", "Weg|Path", _ACROSS),
    ("rise_velocity", "$c_y$", "$c_y/v$", "v", "Geschwindigkeit|Velocity", _ACROSS),
    ("rise_acceleration", "$p_y$", "$(p_y R)/v^2$", "v²/R", "Beschleunigung|Acceleration", _ACROSS),
)
DECIMALS, ANGLE_DECIMALS = 4, 3


@cache
def arc_registry() -> Mapping[str, LinkageQuantity]:
    """Return every quantity of the arc crank by its key, the return stroke's beside the outstroke's."""
    return {one.key: one for one in _arc_quantities()}


@cache
def parallel_registry() -> Mapping[str, LinkageQuantity]:
    """Return every quantity of the parallel crank by its key."""
    return {one.key: one for one in map(_coupler_quantity, _COUPLER)}


def _arc_quantities() -> Iterator[LinkageQuantity]:
    for motion, symbol, heading, names in _ARC:
        unit, name = MOTIONS[motion].unit, _both(names)
        decimals = ANGLE_DECIMALS if unit == "°" else DECIMALS
        for key, stroke in ((motion, OUT), (f"{motion}_return", RETURN)):
            part = STROKES[stroke]
            yield LinkageQuantity(
                key, motion, name, part, (name, part), symbol, heading, unit, decimals,
                _arc_digits(motion, stroke), stroke,
            )  # fmt: skip


def _arc_digits(motion: str, stroke: int) -> Digits:
    def digits(crank: ArcCrank | None, angle: Fraction, decimals: int, rounding: str) -> int:
        assert crank is not None
        return certified(motion, crank, stroke, angle, decimals, rounding)

    return digits


def _coupler_quantity(row: tuple[str, Label, Label, str, str, str]) -> LinkageQuantity:
    motion, symbol, heading, unit, names, direction = row
    name, part = _both(names), _both(direction)
    return LinkageQuantity(
        f"coupler_{motion}", motion, name, part, (part, name), symbol, heading, unit, DECIMALS,
        lambda crank, angle, decimals, rounding: certified_coupler(motion, angle, decimals, rounding),
    )  # fmt: skip


def _both(text: str) -> Mapping[str, str]:
    return dict(zip(("de", "en"), text.split("|"), strict=True))
