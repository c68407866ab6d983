"""The page of the masses that stand in for a connecting rod: at the pins, or dynamically equivalent."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from typing import NamedTuple

from kurbel.drive.rod import Rod
from kurbel.exact.numerals import Label, Number, figure, given, number_text
from kurbel.exact.real import Product
from kurbel.motion.notes import connecting_rod
from kurbel.page.axes import ColumnAxis, ListAxis, Place
from kurbel.page.quantity import Column, Formula, Need, Quantity, entry, words
from kurbel.page.subject import LEAVE_OUT, Question, Subject
from kurbel.page.table import Field
from kurbel.reading.amounts import amount, unit_of_page

KILOGRAMS = Need(lambda question: question.rod.mass is not None, words="the mass of the rod, --rod-mass")
LENGTHS = Need(lambda question: question.length is not None, words="the length of the rod, --rod")
BOTH = Need(
    lambda question: None not in (question.rod.mass, question.length),
    words="the rod's mass and length, --rod-mass and --rod",
)
TURNED = Need(
    lambda question: None not in (question.rod.mass, question.length, question.acceleration),
    words="the rod's mass, length and angular acceleration, --rod-mass, --rod and --rod-acceleration",
)
MODEL = words("Ersatz der Stange|In place of the rod")


class Point(NamedTuple):
    """A mass as a share of the rod's, at a place in L from the crosshead pin."""

    mass: Fraction
    place: Fraction


def at_pins(rod: Rod) -> tuple[Point, ...]:
    """Return masses at the pins that keep mass and centre of mass. Source: Ensslin, 593."""
    return Point(rod.centre, Fraction(0)), Point(1 - rod.centre, Fraction(1))


def from_crosshead(rod: Rod) -> tuple[Point, ...]:
    """Return two masses that move like the rod, one at the crosshead pin: k²/(a² + k²) there and the other
    k²/a beyond the centre of mass, a from that pin. None where the centre is at the pin. Re-derived."""
    near, square = 1 - rod.centre, rod.gyration_square
    if not near:
        return ()
    whole = near**2 + square
    return Point(square / whole, Fraction(0)), Point(near**2 / whole, near + square / near)


def from_crank(rod: Rod) -> tuple[Point, ...]:
    """Return the same with one at the crank pin."""
    turned = from_crosshead(Rod(1 - rod.centre, rod.gyration_square))
    return tuple(Point(mass, 1 - place) for mass, place in reversed(turned))


def at_three(rod: Rod) -> tuple[Point, ...]:
    """Return masses at the pins and at the centre of mass that move like the rod: k²/(a L), k²/(b L) and the
    rest, which is negative where k² is above a b. None where the centre is at a pin. Re-derived."""
    near, far, square = 1 - rod.centre, rod.centre, rod.gyration_square
    if not near * far:
        return ()
    between = Point(1 - square / (near * far), near)
    return Point(square / near, Fraction(0)), between, Point(square / far, Fraction(1))


MODELS: Mapping[str, tuple[str, Callable[[Rod], tuple[Point, ...]]]] = {
    "pins": ("an den Zapfen|at the pins", at_pins),
    "crosshead": ("eine am Kreuzkopfzapfen|one at the crosshead pin", from_crosshead),
    "crank": ("eine am Kurbelzapfen|one at the crank pin", from_crank),
    "three": ("an Zapfen und Schwerpunkt|at pins and centre of mass", at_three),
}


def lacking(rod: Rod) -> Callable[[tuple[Point, ...]], Fraction]:
    """Return what the moment of inertia of masses about the centre of mass lacks of that of the rod."""
    centre = 1 - rod.centre
    return lambda points: (
        rod.gyration_square - sum((one.mass * (one.place - centre) ** 2 for one in points), Fraction(0))
    )


# A kernel call takes the rod and its points.
def _end(index: int, name: str) -> Callable[[Rod, tuple[Point, ...]], Fraction]:
    return lambda rod, points: Fraction(getattr(points[index], name))


def _middle(rod: Rod, points: tuple[Point, ...]) -> Fraction | None:
    return points[1].mass if len(points) == 3 else None


@cache
def registry() -> Mapping[str, Quantity]:
    """Return every quantity by its key, in shares of the rod's mass and length and in kg and mm."""
    entries = [one for said in _ENTRIES for one in _pair(*said)]
    name = words("Ausgleichsmoment|Correction couple")
    formulas = {"exact": Formula(lambda rod, points: lacking(rod)(points))}
    couple = Quantity("correction_nm", name, "$ΔJ α$", words("N m"), None, formulas, words("$ΔJ α$ in N m"))
    entries.append(couple._replace(spanners=(name,), needs=(TURNED,)))
    return {one.key: one for one in entries}


_ENTRIES: tuple[tuple[str, str, str, Need, Callable[..., Fraction | None]], ...] = (
    ("crosshead_mass", "Masse am Kreuzkopf|Mass at the crosshead", "m_B", KILOGRAMS, _end(0, "mass")),
    ("crosshead_place", "Masse am Kreuzkopf|Mass at the crosshead", "x_B", LENGTHS, _end(0, "place")),
    ("centre_mass", "Masse im Schwerpunkt|Mass at the centre", "m_S", KILOGRAMS, _middle),
    ("crank_mass", "Masse an der Kurbel|Mass at the crank", "m_A", KILOGRAMS, _end(-1, "mass")),
    ("crank_place", "Masse an der Kurbel|Mass at the crank", "x_A", LENGTHS, _end(-1, "place")),
    ("lacking_inertia", "fehlendes Trägheitsmoment|Moment of inertia lacking", "ΔJ", BOTH,
     lambda rod, points: lacking(rod)(points)),
)  # fmt: skip
_SHARES = {KILOGRAMS: "M", LENGTHS: "L", BOTH: "M L^2"}
_UNITS = {KILOGRAMS: ("kg", "kg"), LENGTHS: ("mm", "mm"), BOTH: ("kgm2", "kg m²")}


def _pair(
    key: str, name: str, letter: str, kind: Need, kernel: Callable[..., Fraction | None]
) -> Iterator[Quantity]:
    share, (suffix, unit) = _SHARES[kind], _UNITS[kind]
    formulas = {"exact": Formula(kernel)}
    heading = f"${letter}/{share}$" if " " not in share else f"${letter}/({share})$"
    spanners = (words(name),)
    own = entry(key, name, f"${letter}$", share.replace("^2", "²"), 4, formulas, heading, spanners=spanners)
    yield own
    yield own._replace(
        key=f"{key}_{suffix}",
        unit=words(unit),
        decimals=None,
        heading=words(f"${letter}$ in {unit}"),
        needs=(kind,),
    )


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class RodMassesRequest(Question):
    """What is asked for: the masses that stand in for a rod, of so many metres between its pins or None."""

    rod: Rod
    length: Fraction | None = None
    acceleration: Fraction | None = None

    no_column = "there is no column beside the axes; add one, such as crosshead_mass"
    advice = LEAVE_OUT

    def unit(self, quantity: Quantity) -> Fraction:
        """Return what a share of the rod is in the unit of a quantity."""
        mass, length = self.rod.mass or Fraction(1), self.length or Fraction(1)
        inertia, turned = mass * length**2, self.acceleration or Fraction(0)
        units = {KILOGRAMS: mass, LENGTHS: 1000 * length, BOTH: inertia, TURNED: inertia * turned}
        return next((units[need] for need in quantity.needs), Fraction(1))


def _number(question: RodMassesRequest, column: Column, place: Place, times: int) -> Number | None:
    _, model = [*MODELS.values()][place["model"]]
    points, quantity = model(question.rod), column.quantity
    found = quantity.formulas["exact"].kernel(question.rod, points) if points else None
    if found is None:
        return None
    return given(times * found * question.unit(quantity), column.decimals, question.rounding)


def _model_axis(question: RodMassesRequest, models: Sequence[str] = tuple(MODELS)) -> ListAxis:
    field = Field("model", MODEL[question.lang])
    return ListAxis(models, field, str, lambda key: words(MODELS[key][0])[question.lang], "")


def _notes(question: RodMassesRequest) -> Iterator[Label]:
    lang = question.lang
    yield connecting_rod(question.rod, lang)
    if question.length is not None:
        yield ", ".join(_sizes(question, question.length))
    if question.acceleration is not None:
        yield f'$α = {figure(question.acceleration)} "rad"/"s"^2$'


def _sizes(question: RodMassesRequest, length: Fraction) -> Iterator[Label]:
    """Yield the rod's length, its radius of gyration and, of a known mass, its moment of inertia."""
    rod, rounding = question.rod, question.rounding
    square = Product.of(rod.gyration_square * length**2)
    yield f"$L = {amount(length, 'mm')}$"
    times, unit = unit_of_page("mm")
    gyration = square ** Fraction(1, 2) * Product.of(1000 * times)
    yield f"$k = {number_text(gyration.number(None, rounding))} {unit}$"
    if rod.mass is not None:
        times, unit = unit_of_page("kg m²")
        inertia = square * Product.of(rod.mass * times)
        # Of metric pages the unit is set in two words.
        label = unit if times != 1 else '"kg" "m"^2'
        yield f"$J_S = M k^2 = {number_text(inertia.number(None, rounding))} {label}$"


SUBJECT = Subject(
    key="rod masses",
    layout="rod-masses",
    command="inertia --layout rod-masses",
    axes={"model": _model_axis, "column": ColumnAxis},
    axis_keys=("model",),
    quantities=registry,
    number=_number,
    notes=_notes,
    letters=True,
)
# Ensslin's two masses alone.
PINS = SUBJECT._replace(
    key="pin masses",
    layout="ensslin-masses",
    command="inertia --layout ensslin-masses",
    axes={"model": lambda question: _model_axis(question, ["pins"]), "column": ColumnAxis},
    listed=tuple,
)
