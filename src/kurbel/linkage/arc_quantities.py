"""What can stand in a table of the arc crank: an entry each; and the pages of its rod's inertia."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import cache, partial
from typing import Any

from kurbel.drive.at import At, known
from kurbel.exact.numerals import Label
from kurbel.kernel import linkage
from kurbel.kernel.circle import Numeric
from kurbel.linkage.linkage import (
    LinkageRequest,
    force_entries,
    force_formula,
    in_strokes,
    linkage_subject,
    share_of,
)
from kurbel.linkage.rocker import RockerCrank
from kurbel.motion.entries import OF_ROD, headed, in_units, measured, on_strokes
from kurbel.motion.inertia import inertia_registry
from kurbel.motion.mechanism import mechanism
from kurbel.motion.notes import connecting_rod, size_notes, turns_label
from kurbel.page.quantity import Formula, Of, Quantity, words

# A further formula, as it is printed where the pivot lies on the left of the end's way.
LEFT = "left"
Formulas = Mapping[str, Formula]
OF_TURN = words(
    "Drehung der Schwinge positiv in der Richtung des Hubes"
    "|turning of the rocker positive in the direction of the stroke"
)

# In printed formulas {±} is the sign of the stroke, {β±} that of the stroke and the side of the pivot.
_ZETA, _TAU = "$ζ = φ - θ$", "$τ = ψ + θ$"


def _turned(at: At) -> Numeric:
    return 2 * at.numbers.arc(linkage.path_half_sine(at.place, at.arc))


def _path(at: At) -> Numeric:
    curvature: Numeric = at.arc.curvature
    return _turned(at) * at.numbers.pi / 180 / curvature


def _rocker(at: At) -> Numeric:
    return 2 * at.numbers.arc(linkage.rocker_half_sine(at.arc)) - _turned(at)


def _slant(at: At) -> Numeric:
    return at.numbers.arc(at.place.slant)


def _of(kernel: Callable[..., Numeric], printed: Label = "", symbols: tuple[Label, ...] = ()) -> Formula:
    return Formula(lambda at: kernel(at.place, at.arc), printed, symbols)


def _by_rocker(kernel: Callable[..., Numeric]) -> Formula:
    return Formula(lambda at: kernel(at.place, at.arc) / at.numbers.of(at.drive.rocker))


def _gaining(even: Formula, velocity: Formula) -> Formula:
    """Return the formula of an acceleration, to which comes what the crank's own acceleration adds to it: so
    much of the velocity."""

    def kernel(at: At) -> Numeric:
        found: Numeric = even.kernel(at)
        if at.gain is not None:
            found = found + at.gain * velocity.kernel(at)
        return found

    return even._replace(kernel=kernel)


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
_PATHS |= {
    **{f"{key}_mm": formulas for key, formulas in _PATHS.items()},
    **{f"{key}_stroke": {by: share_of(one) for by, one in own.items()} for key, own in _PATHS.items()},
}
_VELOCITY = _of(linkage.velocity, "$c/v = (sin(ζ + τ))/(cos τ)$", (_ZETA, _TAU))
_ACCELERATION = _gaining(
    _of(
        linkage.acceleration,
        "$(p R)/v^2 = cos ζ {±} λ (cos^2 ζ)/(cos^3 τ) - (sin ζ {β±} β c^2/v^2) tan τ$",
        (_ZETA, _TAU, "$λ = R/L$", "$β = R/B$"),
    ),
    _VELOCITY,
)


@cache
def arc_registry() -> Mapping[str, Quantity]:
    """Return every quantity of the arc crank by its key, the return stroke's beside the outstroke's."""
    entries = (one for each in (*_arc_entries(), *_arc_forces()) for one in on_strokes(each))
    return {one.key: one._replace(formulas=_PATHS.get(one.key, one.formulas)) for one in entries}


def _arc_entries() -> Iterator[Quantity]:
    name = "Weg auf dem Bogen|Path along the arc"
    path = headed("path", name, "x", "R", Formula(_path), of=Of.STROKE, names=("path", "x"), rises=True)
    yield from (path, in_strokes(path), measured(path))
    name = "Geschwindigkeit|Velocity"
    yield from in_units("velocity", name, "c", "v", _VELOCITY, names=("velocity", "c"))
    name, names = "Beschleunigung|Acceleration", ("acceleration", "p")
    gained = headed("acceleration", name, "p", "v²/R", _ACCELERATION, names=names)
    yield from (measured(gained), gained)
    name, names = "Schwingenwinkel|Rocker angle", ("rocker", "θ")
    yield headed("rocker", name, "θ", "°", Formula(_rocker), names=names, rises=True)
    yield headed(
        "rod", "Schubstangenwinkel|Rod angle", "ψ", "°", Formula(lambda at: _slant(at) - _rocker(at))
    )
    yield headed("slant", "Stange gegen Bogen|Rod against arc", "τ", "°", Formula(_slant, "", (_TAU,)))
    for key, name, letter, kernel in (
        ("chord", "Sehne des Weges|Chord of the path", "q", linkage.chord),
        ("slide_path", "Weg längs der Schubrichtung|Path along the slide", "x_s", linkage.slide_path),
        ("rise", "Weg quer zur Schubrichtung|Path across the slide", "y_s", linkage.rise),
    ):
        yield headed(key, name, letter, "R", _of(kernel), of=Of.STROKE)
    yield headed(
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
        gain = f"Winkelbeschleunigung {de}|Angular acceleration {en}"
        own = [
            headed(key, name, letter, unit, formula, names=(key,), direction=said)
            for key, name, letter, unit, formula in (
                (f"{key}_velocity", speed, f"ω_{letter}", "ω", velocity),
                (f"{key}_acceleration", gain, f"ε_{letter}", "ω²", _gaining(acceleration, velocity)),
            )
        ]
        yield from (*own, *map(measured, own))


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


class RockerInertiaRequest(LinkageRequest):
    """What is asked for of these drives with their rods, each called as in its own mechanism."""

    def entry(self, key: str) -> Quantity:
        called: Quantity = _moved(self.drives[0]).named(super().entry(key))
        return called


def _moved(drive: RockerCrank) -> Any:
    return mechanism(drive.mechanism)


def _caption(request: LinkageRequest) -> Label:
    caption: Label = _moved(request.drives[0]).caption(request)
    return caption


def _notes(request: LinkageRequest) -> Iterator[Label]:
    lang, drives = request.lang, request.drives
    yield from size_notes(request.cranks)
    moved = _moved(drives[0])
    yield from dict.fromkeys(turns_label(one.crank.speed) for one in drives if one.crank.speed)
    yield from dict.fromkeys(connecting_rod(known(one.crank.rod), lang, "L", moved.words) for one in drives)
    yield from (moved.dead_centres(drive, lang) for drive in drives)


# Its quantities are listed as those of the slide.
SUBJECT = linkage_subject(
    "rocker inertia",
    layout="inertia-rocker",
    command="inertia --mechanism arc --rocker 6",
    quantities=partial(inertia_registry, False),
    caption=_caption,
    notes=_notes,
    ratios=True,
)._replace(listed=tuple)
