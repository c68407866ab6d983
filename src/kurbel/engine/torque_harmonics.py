"""What a table of the harmonics of the torque can show: each quantity with its symbol, evaluation and digits.

T = P + Σ (a_k cos kφ + b_k sin kφ) = P + Σ c_k cos(kφ + ψ_k): a kernel takes where a harmonic is asked for,
an `At`, and returns a number of its turn's kind, or a fraction. Its digits are certified in balls, or as many
as an indicator card supports.

Engines and a layout become a table of the harmonics of their tangential force.

One page has those of a cylinder and of the engine; the excitation has those of every cylinder.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, cached_property, lru_cache
from math import atan2, degrees, hypot
from typing import TYPE_CHECKING, Any, NamedTuple, cast

import flint

from kurbel.balancing.harmonics import MOST_ORDERS, ORDER
from kurbel.balancing.vector import Vector
from kurbel.drive.at import known
from kurbel.engine.captions import caption
from kurbel.engine.cylinder import AnyTurn, Member, members_of
from kurbel.engine.digits import CLEAN, ERROR, FLOAT_ERROR, Estimate, certified, error_number, supported
from kurbel.engine.engine_page import LoadAxis, errors_beside
from kurbel.engine.engine_quantities import ENGINE_METHODS, Needs
from kurbel.engine.fourier import NOTHING_BITS, PARTS, Floats, Spectrum, Wave, spectrum_of, star_of
from kurbel.engine.loads.ideal import Steam
from kurbel.engine.notes import from_dead_centre, notes
from kurbel.engine.request import EngineRequest
from kurbel.errors import ProblemError
from kurbel.exact.certify import NEVER_TIES, at_bits
from kurbel.exact.numerals import Label, Number, nearest
from kurbel.exact.real import EXACT_ZERO
from kurbel.kernel.circle import Numeric
from kurbel.kernel.harmonics import Star
from kurbel.page.axes import Axis, ColumnAxis, ListAxis, Place, RatioAxis, UnletteredAxis
from kurbel.page.quantity import Column, Formula, Need, Of, Quantity, Texts, entry, words
from kurbel.page.subject import Subject
from kurbel.page.table import Field, Note, Value
from kurbel.reading.notation import plain
from kurbel.reading.units import Speed

if TYPE_CHECKING:
    from kurbel.engine.card.force import CardTurn

HARMONICS = Texts("engine", "harmonics")


# Steps of orders beside one at which the cards' differences are looked at: one alone may vanish by chance.
BESIDE = (-1, 0, 1)


class At(NamedTuple):
    """A harmonic of a cylinder or of the engine."""

    spectrum: Spectrum
    member: Member
    order: Fraction
    speed: Speed | None = None

    @property
    def turn(self) -> AnyTurn:
        return self.spectrum.turn

    @property
    def wave(self) -> Wave | None:
        """The harmonic, None where it is proved to be nothing.

        What is not told from nothing with very many bits is 0.
        """
        wave = self._wave()
        if wave is None or isinstance(wave.cosine, float) or not any(one.contains(0) for one in wave):
            return wave
        nothing = self._nothing(self.spectrum, self.member, self.order)
        return Wave(*(one * 0 if none else one for one, none in zip(wave, nothing, strict=True)))

    def _wave(self) -> Wave | None:
        part = self.member.part
        if part is None:
            return self.spectrum.engine(self.order)
        if not self.spectrum.has(part, self.order):
            return None
        return self.spectrum.cylinder(part, self.order).turned(Star.ray(self.order * 180 * self.member.start))

    @staticmethod
    @lru_cache(maxsize=512)
    def _nothing(spectrum: Spectrum, member: Member, order: Fraction) -> tuple[bool, ...]:
        """Whether the cosine and the sine are as good as nothing."""
        with at_bits(NOTHING_BITS):
            wave = At(spectrum, member, order)._wave()
            return tuple(one.contains(0) for one in wave or ())


def amplitude(at: At) -> Numeric:
    """Return c_k."""
    wave = known(at.wave)
    square: Numeric = wave.cosine * wave.cosine + wave.sine * wave.sine
    return square**0.5 if square else square


def phase(at: At) -> Numeric:
    """Return ψ_k in radians, above -π and up to π, of a harmonic that is one."""
    wave = known(at.wave)
    across, along = -wave.sine, wave.cosine
    if isinstance(along, float):
        return atan2(across, along)
    return (1 - along.sgn()) / 2 * flint.arb.pi() if across == 0 else flint.arb.atan2(across, along)


def star(at: At) -> Star:
    """Return the sum of e^(ikα) over the cranks of an engine whose cylinders are alike."""
    return star_of(at.turn, 0, at.order) if at.member.part is None else Star.ray(Fraction(0))


def frequency(at: At) -> Numeric:
    """Return k n in turns a second."""
    speed = known(at.speed)
    return at.order * speed.value if speed.turns else at.turn.of(at.order * speed.value / 2) / at.turn.pi


def angular(at: At) -> Numeric:
    """Return k ω in radians a second."""
    speed = known(at.speed)
    return at.turn.of(2 * at.order * speed.value) * at.turn.pi if speed.turns else at.order * speed.value


# What is no length: of nothing there is no phase.
PHASES = ("phase", "phase_rad")


# What quantities need to be known, beside what those of turns do.
STAR = Need(
    lambda asked: asked.alike and len(asked.first.parts[0].starts) > 1,
    words="several cranks with cylinders alike",
)
SPEED = Need(lambda asked: asked.speed is not None, words="--speed")


@cache
def registry() -> Mapping[str, Quantity]:
    """Return every quantity by its key."""
    return {one.key: one for one in _entries()}


def _entries() -> Iterator[Quantity]:
    for key, name, letter, kernel in (
        ("cosine", "Kosinusglied der Harmonischen|Cosine term of the harmonic", "a_k",
         lambda at: known(at.wave).cosine),
        ("sine", "Sinusglied der Harmonischen|Sine term of the harmonic", "b_k",
         lambda at: known(at.wave).sine),
        ("amplitude", "Amplitude der Harmonischen|Amplitude of the harmonic", "c_k", amplitude),
    ):  # fmt: skip
        of_force = _entry(key, name, f"${letter}$", "$Q$", 5, kernel)
        yield of_force
        yield of_force._replace(
            key=f"{key}_nm", unit=words("N m"), decimals=2, heading=words(f"{of_force.symbol} in N m"),
            scale=AnyTurn.torque_unit, needs=(Needs.TORQUE,),
        )  # fmt: skip
    name = "Phase der Harmonischen|Phase of the harmonic"
    yield _entry("phase", name, "$ψ_k$", "°", 2, phase, scale=lambda turn: 180 / turn.pi)
    yield _entry("phase_rad", name, "$ψ_k$", "rad", 5, phase)
    yield _entry(
        "star", "Summe des Kurbelsterns|Sum of the star of cranks", "$s_k$", "", 4, star, needs=(STAR,),
    )  # fmt: skip
    yield _entry(
        "frequency", "Frequenz der Harmonischen|Frequency of the harmonic", "$k n$", "Hz", None,
        frequency, needs=(SPEED,),
    )  # fmt: skip
    yield _entry(
        "omega_k", "Kreisfrequenz der Harmonischen|Angular frequency of the harmonic", "$k ω$", "rad/s",
        None, angular, needs=(SPEED,),
    )  # fmt: skip


def value(quantity: Quantity, at: At) -> Numeric:
    """Return the quantity in its unit, on the kind of number of the turn, or a fraction."""
    found: Numeric = quantity.formulas[at.turn.method].kernel(at)
    return found * quantity.scale(at.turn) if quantity.scale else found


def _entry(
    key: str, name: str, symbol: Label, unit: Label, decimals: int | None, kernel: Callable[[At], object],
    **rest: Any,
) -> Quantity:  # fmt: skip
    formulas = dict.fromkeys(ENGINE_METHODS, Formula(kernel))
    return entry(key, name, symbol, unit, decimals, formulas, of=Of.ORDER, **rest)


def number_of(column: Column, at: At, rounding: str) -> Number | None:
    """Return the printed number; None of the phase of nothing."""
    needs, is_phase = column.quantity.needs, column.quantity.key in PHASES
    if STAR in needs:
        return Vector(star(at)).length().number(column.places, rounding)
    if SPEED not in needs:
        if at.wave is None:
            return None if is_phase else EXACT_ZERO
        if is_phase and all(one == 0 for one in at.wave):
            return None
        if isinstance(at.spectrum, Floats):
            best, error = estimate(column, at)
            return supported(float(best), error, column.places, rounding, is_phase)
    return certified(lambda: value(column.quantity, at), column, rounding, NEVER_TIES)


def estimate(column: Column, at: At) -> Estimate:
    """Return a value from a card and how far it may be off."""
    turn, best = cast("CardTurn", at.turn), float(value(column.quantity, at))
    off = _off(at, turn)
    if column.quantity.key in PHASES:
        wave = at.wave or Wave(0.0, 0.0)
        away = off / max(hypot(*wave), off)
        return Estimate(best, degrees(away) if column.quantity.key == "phase" else away)
    unit = float(column.quantity.scale(turn)) if column.quantity.scale else 1.0
    return Estimate(best, unit * off + FLOAT_ERROR * (abs(best) + 1))


def _off(at: At, turn: CardTurn) -> float:
    """How far the harmonic, as a vector, may be off in Q."""
    shown = max(_apart(at, half, turn) for half in turn.coarser)
    # What twice the points do not bring nearer to the truth is noise, half of which both have in common.
    noisy = 2 if turn.gain < CLEAN else 1
    cranks = sum(len(part.starts) for part in turn.engine.parts) if at.member.part is None else 1
    summed = _between(at, Floats(turn, PARTS // 2))
    return noisy * shown / turn.gain + turn.step * cranks + summed


def _apart(at: At, half: CardTurn, turn: CardTurn) -> float:
    """How far the coarser card's harmonics are away, at this order and those beside it."""
    step, other = Fraction(2, turn.cycle), _spectrum(half)
    orders = [order for index in BESIDE if (order := at.order + index * step) > 0]
    return max(_between(at._replace(order=order), other) for order in orders)


def _between(at: At, other: Spectrum) -> float:
    """How far another spectrum's harmonic is away."""
    one, two = at.wave, at._replace(spectrum=other).wave
    return hypot(one.cosine - two.cosine, one.sine - two.sine) if one and two else 0.0


@lru_cache(maxsize=16)
def _spectrum(turn: CardTurn) -> Floats:
    return Floats(turn)


WHOLE = "all"
EXCITATION = "excitation"


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class TorqueRequest(EngineRequest):
    """What is asked for: the harmonics of the tangential force up to an order."""

    last_order: int = 6
    speed: Speed | None = None

    def check(self) -> None:
        super().check()
        if self.layout.subject == EXCITATION and not self.columns:
            for column in self.layout.columns:
                if missing := self.missing(self.entry(column.quantity)):
                    raise ProblemError(missing)
        if not isinstance(self.last_order, int) or not 1 <= self.last_order <= MOST_ORDERS:
            raise ProblemError(
                f"orders up to {str(self.last_order)[:20]} were asked for; the last must be a whole number"
                f" from 1 to {MOST_ORDERS}"
            )

    @cached_property
    def orders(self) -> tuple[Fraction, ...]:
        """The orders, in cycles of two turns in steps of ½."""
        step = Fraction(2, self.turn(0, 0, (self.methods or ("exact",))[0]).cycle)
        return tuple(step * index for index in range(1, int(self.last_order / step) + 1))

    @cached_property
    def members(self) -> tuple[Member, ...]:
        """The cylinders that the page is about, one of those that are alike, and after them the engine."""
        every = members_of(self.first)
        if self.layout.subject == EXCITATION:
            return every
        if len(every) == 1:
            return (Member(0),)
        return (*(every[:1] if self.alike else every), Member(0))

    @property
    def alike(self) -> bool:
        return len(self.first.parts) == 1

    @cached_property
    def spectrum(self) -> Callable[[int, int, str], Spectrum]:
        """Return the harmonics of an engine by a method; the latest are kept."""
        return lru_cache(64)(lambda steam, drive, method: spectrum_of(self.turn(steam, drive, method)))

    def at(self, place: Place, method: str) -> At:
        spectrum = self.spectrum(place["expansion"], place["ratio"], method)
        return At(spectrum, self.members[place["cylinder"]], self.orders[place["order"]], self.speed)


def _number(request: TorqueRequest, column: Column, place: Place, times: int) -> Value:
    at = request.at(place, column.method)
    if not column.key.endswith(ERROR):
        return number_of(column, at, request.rounding)
    return error_number(estimate(column, at).error) if at.wave else None


def _beside(request: TorqueRequest, column: Column) -> tuple[Column, ...]:
    return () if {STAR, SPEED}.intersection(column.quantity.needs) else errors_beside(request, column)


class _OrderAxis(UnletteredAxis):
    """The orders, whole ones or halves."""

    def __init__(self, request: TorqueRequest) -> None:
        name = ORDER[request.lang]
        self.decimals = max(int(order.denominator > 1) for order in request.orders)
        super().__init__(
            request.orders,
            Field("order", name, "$k$", "", self.decimals),
            lambda order: nearest(order, self.decimals),
            lambda order: f"$k = {plain(order)}$",
            f"{name} $k$",
        )


def _member_axis(request: TorqueRequest) -> ListAxis:
    lang = request.lang

    def head(member: Member) -> Label:
        return (
            HARMONICS["one"][lang].format(number=member.number) if member.number else HARMONICS["whole"][lang]
        )

    return ListAxis(
        request.members,
        Field("cylinder", HARMONICS["member"][lang]),
        lambda member: Number(member.number, 0) if member.number else WHOLE,
        head,
    )


def _notes(request: TorqueRequest) -> Iterator[Label | Note]:
    lang = request.lang
    regular = from_dead_centre(request, (request.methods or ("exact",))[0])
    yield HARMONICS["sum"][lang].replace("{begin}", HARMONICS["dead_centre" if regular else "slide"][lang])
    if any(STAR in column.quantity.needs for column in request.page_columns):
        yield HARMONICS["star"][lang]
    yield from notes(request)
    yield HARMONICS["zero"][lang]


def _subject(key: str, layout: str) -> Subject[TorqueRequest]:
    names = {"expansion": "epsilon"}
    return Subject(
        key=key,
        layout=layout,
        command="harmonics --quantity torque",
        axes={**_AXES, "column": ColumnAxis},
        axis_keys=tuple(names.get(name, name) for name in _AXES),
        quantities=registry,
        number=_number,
        caption=caption,
        notes=_notes,
        beside=_beside,
        listed=None if key != EXCITATION else tuple,
        letters=True,
        limits={"expansion": Steam},
    )


_AXES: Mapping[str, Callable[[TorqueRequest], Axis]] = {
    "expansion": LoadAxis, "ratio": RatioAxis, "cylinder": _member_axis, "order": _OrderAxis,
}  # fmt: skip


TORQUE = _subject("torque", "torque-harmonics")


EXCITING = _subject(EXCITATION, EXCITATION)
