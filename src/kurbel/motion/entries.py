"""The motion of the straight or offset crank as pages can show it: the piston's and the rod's, and speeds."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from functools import partial
from typing import Any, NamedTuple

from kurbel.drive.at import At, angular_square, angular_velocity, known, rubbing, turn_time, turned
from kurbel.drive.crank import Crank
from kurbel.exact.kind import Kind
from kurbel.exact.numerals import Label
from kurbel.kernel import kinematics, series
from kurbel.kernel.circle import Numeric
from kurbel.kernel.kinematics import rod_slant
from kurbel.motion.evaluation import OFFSET, OUT, REACH, RETURN, STROKES, TANGENT, TURN, Needs
from kurbel.page.quantity import Formula, Need, Quantity, entry, words

Formulas = Mapping[str, Formula]
Kernel = Callable[..., Numeric]
# What has no other value on the return stroke, and no column of its own there.
ON_EITHER_STROKE = "fd"
# What keys say of their unit at their end.
_UNIT = r"_(?:mm|mps2?|radps2?|nm?|stroke|percent)$"

# In printed formulas {±} is the sign that the return stroke changes, {ψ} the same where ψ itself is printed
# (cos ψ knows no sign), {sign} that sign before a whole formula and {turned} the opposite one, {angle} the
# letter of the crank angle; {path}, {velocity}, {acceleration} and {rod_acceleration} are terms of a series.

# What turning of the rod is positive, that of ψ on the outstroke.
OF_ROD = words(
    "Drehung der Stange positiv gegen den Drehsinn der Kurbel"
    "|turning of the rod positive against the sense of the crank"
)


def _motion(kernel: Kernel, first: Kernel, *lines: Label) -> Formulas:
    """Return the formulas by the methods exact, series and infinite, of the offset crank, and by higher
    powers of λ, of which kernel/series.py has the kernel by the name of the exact one; as printed."""

    def exact(at: At) -> Numeric:
        return kernel(at.circle, at.ratio, at.offset)

    kernels = {
        "exact": exact,
        "series": lambda at: first(at.circle, at.ratio),
        "infinite": exact,
        OFFSET: exact,
    }
    *own, further = lines
    formulas = {key: Formula(one, text) for (key, one), text in zip(kernels.items(), own, strict=True)}
    return _by_orders(formulas, kernel.__name__, further)


def _by_orders(first: Formulas, kernel: str, line: Label) -> Formulas:
    """Return the formulas with those by higher powers of λ, the kernel's of this name."""
    return {**first, **{key: Formula(_by_order(kernel, order), line) for key, order in REACH.items()}}


def _by_order(kernel: str, order: int) -> Kernel:
    def call(at: At) -> Numeric:
        # What is asked by other methods needs none of it.
        found: Numeric = getattr(series, kernel)(at.circle, at.ratio, order)
        # Of a negative ratio fd would be negative, too.
        return at.stroke * found if kernel == "rod_versine" else found

    return call


def _driven(acceleration: Formulas, velocity: Formulas) -> Formulas:
    """Return the formulas of an acceleration with what the crank's own adds: the velocity, times α/ω²."""

    def both(even: Kernel, first: Kernel) -> Kernel:
        return lambda at: even(at) if at.gain is None else even(at) + at.gain * first(at)

    return {
        key: one._replace(kernel=both(one.kernel, velocity[key].kernel)) for key, one in acceleration.items()
    }


PATH = _motion(
    kinematics.piston_path,
    kinematics.piston_path_first_order,
    "$x/R = 1 - cos {angle} {±} (1 - cos ψ)/λ$",
    "$x/R = 1 - cos {angle} {±} 1/2 λ sin^2 {angle}$",
    "$x/R = 1 - cos {angle}$",
    "$x/R = (cos φ_i - cos {angle}) + (cos ψ_i - cos ψ)/λ$",
    "$x/R = 1 - cos {angle} {±} ({path})$",
)
VELOCITY = _motion(
    kinematics.piston_velocity,
    kinematics.piston_velocity_first_order,
    "$c/v = sin {angle} {±} (λ sin {angle} cos {angle})/(cos ψ)$",
    "$c/v = sin {angle} {±} 1/2 λ sin 2 {angle}$",
    "$c/v = sin {angle}$",
    "$c/v = sin {angle} + cos {angle} tan ψ$",
    "$c/v = sin {angle} {±} λ sin {angle} cos {angle} ({velocity})$",
)
ACCELERATION = _driven(
    _motion(
        kinematics.piston_acceleration,
        kinematics.piston_acceleration_first_order,
        "$(p R)/v^2 = cos {angle} {±} λ (cos 2 {angle} + λ^2 sin^4 {angle})/(cos^3 ψ)$",
        "$(p R)/v^2 = cos {angle} {±} λ cos 2 {angle}$",
        "$(p R)/v^2 = cos {angle}$",
        "$(p R)/v^2 = cos {angle} - sin {angle} tan ψ + λ (cos^2 {angle})/(cos^3 ψ)$",
        "$(p R)/v^2 = cos {angle} {±} ({acceleration})$",
    ),
    VELOCITY,
)


ROD_VERSINE = _by_orders(
    {
        "exact": Formula(
            lambda at: at.stroke * kinematics.rod_versine(at.circle, at.ratio),
            "$overline(f d)/R = (1 - cos ψ)/λ$",
        ),
        "series": Formula(_by_order("rod_versine", 1), "$overline(f d)/R = 1/2 λ sin^2 {angle}$"),
        "infinite": Formula(lambda at: at.numbers.of(Fraction(0)), "$overline(f d) = 0$"),
    },
    "rod_versine",
    "$overline(f d)/R = {path}$",
)


def _rod_angle(at: At) -> Numeric:
    return at.numbers.rod_angle(at.circle, at.ratio, at.offset)


ROD_VELOCITY = _motion(
    kinematics.rod_velocity,
    kinematics.rod_velocity_first_order,
    "$ω_L/ω = {sign}(λ cos {angle})/(cos ψ)$",
    "$ω_L/ω = {sign}λ cos {angle}$",
    "$ω_L = 0$",
    "$ω_L/ω = (λ cos {angle})/(cos ψ)$",
    "$ω_L/ω = {sign}λ cos {angle} ({velocity})$",
)
ROD_ACCELERATION = _driven(
    _motion(
        kinematics.rod_acceleration,
        kinematics.rod_acceleration_first_order,
        "$ε_L/ω^2 = {turned}(λ (1 - λ^2) sin {angle})/(cos^3 ψ)$",
        "$ε_L/ω^2 = {turned}λ sin {angle}$",
        "$ε_L = 0$",
        "$ε_L/ω^2 = (ω_L^2/ω^2 sin ψ - λ sin {angle})/(cos ψ)$",
        "$ε_L/ω^2 = {turned}λ sin {angle} ({rod_acceleration})$",
    ),
    ROD_VELOCITY,
)


# The rod angle enters the first-order formulas nowhere; it is the same arc by every method.
ROD_ANGLE: Formulas = {
    "exact": Formula(_rod_angle),
    **dict.fromkeys(("series", *REACH), Formula(_rod_angle, "$sin ψ = {ψ}λ sin {angle}$")),
    "infinite": Formula(_rod_angle, "$ψ = 0$"),
    OFFSET: Formula(_rod_angle),
    TANGENT: Formula(lambda slant: slant, "arctan(R/L)"),
}


def _velocity(at: At) -> Numeric:
    return kinematics.piston_velocity(at.circle, at.ratio, at.offset)


def _rod_velocity(at: At) -> Numeric:
    return kinematics.rod_velocity(at.circle, at.ratio, at.offset)


def _along_rod(at: At) -> Numeric:
    return _velocity(at) * rod_slant(at.circle, at.ratio, at.offset).cosine


def _slowest(at: At) -> Numeric:
    lifted: Numeric = at.ratio * rod_slant(at.circle, at.ratio, at.offset).sine
    return _velocity(at) * lifted / _rod_velocity(at)


# All points of the rod have one velocity along it, the slowest no other.
ROD_ALONG = dict.fromkeys(("exact", OFFSET), Formula(_along_rod, "$c_L = c cos ψ$"))
SLOWEST = dict.fromkeys(("exact", OFFSET), Formula(_slowest, "$s_L = (c sin ψ)/ω_L$"))
OF_ALONG = words("$c_L$ die kleinste Geschwindigkeit ihrer Punkte|$c_L$ the least velocity of its points")
OF_SLOWEST = words(
    "$s_L$ vom Kreuzkopf zum Kurbelzapfen; – in allen Punkten dieselbe"
    "|$s_L$ from the crosshead to the crank pin; – the same in all points"
)


def motion_entries() -> Iterator[Quantity]:
    """Yield what moves on the outstroke, in the order in which `kurbel quantities` lists it."""
    yield from _piston_entries()
    yield from _rod_entries()
    yield from _clock_entries()
    yield from _rubbing_entries()
    # Another quantity is one more entry here.


def _piston_entries() -> Iterator[Quantity]:
    path, velocity = "Kolbenweg|Piston path", "Kolbengeschwindigkeit|Piston velocity"
    acceleration = "Kolbenbeschleunigung|Piston acceleration"
    whole = headed("x", path, "x", "R", PATH, names=("x",), rises=True)
    yield whole
    yield spanned(
        "x_stroke", path, "$x$", "in Teilen des Hubes|in strokes", "Hub|stroke", 4, PATH,
        scale=lambda crank, numbers: 1 / crank.way(numbers), names=("s",), rises=True,
    )  # fmt: skip
    yield spanned(
        "x_percent", path, "$x$", "in % des Hubes|in % of stroke", "% des Hubes|% of the stroke", 2, PATH,
        scale=lambda crank, numbers: 100 / crank.way(numbers),
    )  # fmt: skip
    yield measured(whole)
    yield from _rod_versine_entries()
    yield from in_units("c", velocity, "c", "v", VELOCITY, names=("c",))
    yield from in_units("p", acceleration, "p", "v²/R", ACCELERATION, names=("p",))


def _rod_versine_entries() -> Iterator[Quantity]:
    """Yield what the rod's slant adds to the path of the outstroke, and takes from that of the return."""
    name, symbol = "Fehlerglied|Obliquity of the rod", "$overline(f d)$"
    yield from in_units("fd", name, "overline(f d)", "R", ROD_VERSINE, names=("fd",))
    for key, head, unit, decimals, times in (
        ("fd_stroke", "in Teilen des Hubes|in strokes", "Hub|stroke", 4, 1),
        ("fd_percent", "in % des Hubes|in % of stroke", "% des Hubes|% of the stroke", 2, 100),
    ):
        scale = partial(_of_stroke, times)
        yield spanned(key, name, symbol, head, unit, decimals, ROD_VERSINE, scale=scale)


def _of_stroke(times: int, crank: Crank, numbers: Kind) -> Numeric:
    return times / crank.way(numbers)


def _rod_entries() -> Iterator[Quantity]:
    yield spanned(
        "psi", "Schubstangenwinkel|Rod angle", "$ψ$", "$ψ$ in °", "°", 3, ROD_ANGLE,
        bound=60.0, names=("psi", "ψ"),
    )  # fmt: skip
    for key, name, letter, unit, formulas in (
        (
            "rod_velocity", "Winkelgeschwindigkeit der Stange|Angular velocity of the rod", "ω_L", "ω",
            ROD_VELOCITY,
        ),
        (
            "rod_acceleration", "Winkelbeschleunigung der Stange|Angular acceleration of the rod", "ε_L",
            "ω²", ROD_ACCELERATION,
        ),
    ):  # fmt: skip
        share = f"${letter}/{unit.replace('²', '^2')}$"
        one = spanned(key, name, f"${letter}$", share, unit, 4, formulas, names=(key,), direction=OF_ROD)
        yield from (one, measured(one))


def _clock_entries() -> Iterator[Quantity]:
    """Yield the time of an evenly turning crank since the dead centre where the stroke begins."""

    def since(at: At) -> Numeric:
        degrees = at.numbers.of(at.degrees) if isinstance(at.degrees, Fraction) else at.degrees
        return turned(at.crank, at.stroke, degrees, at.numbers)

    methods = ("exact", "series", *REACH, "infinite")
    formulas = dict.fromkeys(methods, Formula(since, "$t = {angle}/ω$"))
    yield spanned(
        "time", "Zeit seit dem Totpunkt|Time since the dead centre", "$t$", "$t$ in s", "s", 5,
        {**formulas, OFFSET: Formula(since, "$t = ({angle} - φ_i)/ω$")}, scale=turn_time, needs=(Needs.TIME,),
    )  # fmt: skip


def _rubbing_entries() -> Iterator[Quantity]:
    """Yield how fast pins of given diameters rub, and the velocity of the rod's slowest point."""
    for pin, name, letter, line, kernel in (
        (
            "crosshead_pin", "Gleitgeschwindigkeit am Kreuzkopfzapfen|Rubbing velocity at the crosshead pin",
            "w_B", "$w_B = {{sign}}(d_B ω)/2 {0}$", lambda turning, at: turning(at),
        ),
        (
            "crank_pin", "Gleitgeschwindigkeit am Kurbelzapfen|Rubbing velocity at the crank pin",
            "w_K", "$w_K = (d_K ω)/2 (1 {{±}} {0})$", lambda turning, at: 1 + turning(at),
        ),
    ):  # fmt: skip
        formulas = {
            method: Formula(
                partial(kernel, one.kernel),
                line.format(one.printed.partition(" = ")[2].replace("{sign}", "").strip("$")),
            )
            for method, one in ROD_VELOCITY.items()
        }
        yield spanned(
            f"{pin}_rubbing_mps", name, f"${letter}$", f"${letter}$ in m/s", "m/s", 3, formulas,
            scale=partial(rubbing, pin), needs=(_diameter(pin), Needs.SPEED), direction=OF_ROD,
        )  # fmt: skip
    name = "Geschwindigkeit längs der Stange|Velocity along the rod"
    yield from in_units("rod_along", name, "c_L", "v", ROD_ALONG, direction=OF_ALONG)
    yield spanned(
        "slowest_point", "langsamster Punkt der Stange|Slowest point of the rod", "$s_L$", "$s_L/L$", "$L$",
        4, SLOWEST, direction=OF_SLOWEST, exists=lambda at: _rod_velocity(at) ** 2,
    )  # fmt: skip


def _diameter(pin: str) -> Need:
    return Need(
        lambda crank: crank.diameters and getattr(crank.diameters, pin), (f"--{pin.replace('_', '-')}",)
    )


def speed_entries() -> Iterator[Quantity]:
    """Yield what is one number for the whole turn: its scale."""
    for key, name, head, unit, line, oblique, scale, needs in (
        (
            "v_mps", "Kurbelzapfengeschwindigkeit|Crank-pin velocity", "v", "m/s", " = (S π n)/60",
            " = (R π n)/30", Crank.pin_velocity, (Needs.SPEED,),
        ),
        (
            "c_m_mps", "mittlere Kolbengeschwindigkeit|Mean piston speed", "c_m", "m/s", " = (S n)/30",
            " = (S n)/30", Crank.mean_velocity, (Needs.MEAN_SPEED,),
        ),
        (
            "v_c_m", "Verhältnis der Geschwindigkeiten|Ratio of the velocities", "v:c_m", "", " = π:2",
            " = π R:S", Crank.pin_to_mean, (),
        ),
        (
            "shaft_rubbing_mps", "Gleitgeschwindigkeit der Welle|Rubbing velocity of the shaft", "w_H", "m/s",
            " = (d_H π n)/60", " = (d_H π n)/60", partial(rubbing, "shaft"),
            (_diameter("shaft"), Needs.SPEED),
        ),
    ):  # fmt: skip
        one = Formula(lambda at: at.numbers.of(Fraction(1)), f"${head}{line}$")
        formulas = {
            "exact": one,
            **dict.fromkeys(("series", *REACH), one),
            "infinite": one,
            OFFSET: one._replace(printed=f"${head}{oblique}$"),
        }
        yield spanned(
            key, name, f"${head}$", f"${head}$" + (unit and f" in {unit}"), unit, 3 if unit else 4, formulas,
            stroke=TURN, scale=scale, needs=needs,
        )  # fmt: skip


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


def headed(
    key: str, name: str, letter: str, unit: str, formulas: Formulas | Formula, **rest: Any
) -> Quantity:
    """Return an entry in degrees or in a unit of the drive's own, of which its head is a share."""
    if isinstance(formulas, Formula):
        formulas = {"exact": formulas}
    if unit == "°":
        return spanned(key, name, f"${letter}$", "", unit, 3, formulas, **rest)
    own = unit.replace("²", "^2")
    share = f"({letter} R)/v^2" if unit == "v²/R" else f"{letter}/{own}"
    return spanned(key, name, f"${letter}$", f"${share}$", f"${own}$", 4, formulas, **rest)


class Measure(NamedTuple):
    """What the crank's size or speed, or the mass of its rod, makes of a unit of the drive's own."""

    unit: str
    decimals: int
    scale: Callable[[Crank, Kind], Numeric]
    needs: tuple[Need, ...]


def _rod_newtons(crank: Crank, kind: Kind) -> Numeric:
    return kind.of(known(known(crank.rod).mass)) * crank.pin_acceleration(kind)


def _rod_moment(crank: Crank, kind: Kind) -> Numeric:
    return kind.of(known(crank.radius)) * _rod_newtons(crank, kind)


def _rod_couple(crank: Crank, kind: Kind) -> Numeric:
    return kind.of(known(crank.rod_length)) * _rod_newtons(crank, kind)


def _rod_millimetres(crank: Crank, kind: Kind) -> Numeric:
    return kind.of(1000 * known(crank.rod_length))


_MEASURES: Mapping[str, Measure] = {
    "R": Measure("mm", 2, Crank.millimetres, (Needs.LENGTH,)),
    "L": Measure("mm", 2, _rod_millimetres, (Needs.LENGTH, Needs.FINITE)),
    "v": Measure("m/s", 3, Crank.pin_velocity, (Needs.SPEED,)),
    "v²/R": Measure("m/s²", 2, Crank.pin_acceleration, (Needs.SPEED,)),
    "R ω²": Measure("m/s²", 2, Crank.pin_acceleration, (Needs.SPEED,)),
    "ω": Measure("rad/s", 3, angular_velocity, (Needs.SPEED,)),
    "ω²": Measure("rad/s²", 3, angular_square, (Needs.SPEED,)),
    "M R ω²": Measure("N", 1, _rod_newtons, (Needs.INERTIA,)),
    "M R² ω²": Measure("N m", 1, _rod_moment, (Needs.INERTIA,)),
    "M R L ω²": Measure("N m", 1, _rod_couple, (Needs.INERTIA, Needs.FINITE)),
}
_IN_KEYS = str.maketrans({"/": "p", "²": "2", " ": "", "N": "n"})


def measure_of(unit: Label) -> Measure:
    """Return what is made of a unit of the drive's own."""
    return _MEASURES[unit.strip("$").replace("^2", "²")]


def measured(share: Quantity) -> Quantity:
    """Return a quantity in the unit that the crank makes of its own: x_mm of x.

    Its head says the unit, or, where that is the part, what stands above.
    """
    own = measure_of(share.unit["en"])
    said, parted = words(f"{share.symbol} in {own.unit}"), share.heading is share.part
    return share._replace(
        key=f"{share.key}_{own.unit.translate(_IN_KEYS)}",
        unit=words(own.unit),
        heading=share.heading if parted else said,
        spanners=(share.name, said) if parted else share.spanners,
        decimals=own.decimals,
        scale=own.scale,
        # With the mass of the rod the rest of it is known.
        needs=(*own.needs, *(one for one in share.needs if one is not Needs.ROD)),
        names=(),
        rises=False,
    )


def in_units(*said: Any, **rest: Any) -> Iterator[Quantity]:
    """Yield a quantity in the drive's own unit, as `headed` takes it, and in that which the crank makes."""
    one = headed(*said, **rest)
    yield from (one, measured(one))


def on_return(key: str) -> str:
    """Return the key on the return stroke: x_return_mm of x_mm."""
    stem = re.sub(_UNIT, "", key)
    return f"{stem}_return{key.removeprefix(stem)}"


def on_strokes(one: Quantity) -> Iterator[Quantity]:
    """Yield the quantity on the outstroke and, as x_return_mm, on the return."""
    if re.sub(_UNIT, "", one.key) == ON_EITHER_STROKE:
        yield one
        return
    for key, stroke in ((one.key, OUT), (on_return(one.key), RETURN)):
        part = STROKES[stroke]
        yield one._replace(
            key=key,
            spanners=(*one.spanners, part),
            part=part,
            stroke=stroke,
            names=one.names if stroke == OUT else (),
        )
