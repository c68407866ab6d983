"""The figures of a flywheel: what pages call them, and what holds between them.

These are products of powers, and the greatest and the least speed. All in SI units: energies in J, angular
velocities ω in 1/s; a cycle has so many `turns`, a second so many `cycles`. Rims are thin: their mass lies at
the mean diameter. Discs are solid and of one thickness.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cache
from typing import NamedTuple, TypeAlias

from kurbel.errors import ProblemError
from kurbel.exact.numerals import Label, number_text
from kurbel.exact.real import Product, Term
from kurbel.page.quantity import Formula, Need, Quantity, entry, with_symbol

Values: TypeAlias = Mapping[str, Product]
_ONE, _TWO, _HALF = Product.of(1), Product.of(2), Product.of(Fraction(1, 2))
_SQUARE, _ROOT = Fraction(2), Fraction(1, 2)


class Shown(NamedTuple):
    """A figure, the power of it that is shown, and what makes the unit of that of the SI's."""

    figure: str
    scale: Product = Product.of(1)
    power: int = 1

    def of(self, value: Product) -> Product:
        return self.scale * value ** Fraction(self.power)


_MINUTE, _MPA = Product.of(30, -1), Product.of(Fraction(1, 10**6))


_MM, _CM2 = Product.of(1000), Product.of(10_000)


_PER_MINUTE = '$"min"^(-1)$'


# At a crank angle of a diagram, and of either sign.
ACCELERATION = "angular_acceleration"


# The options that give figures.
_WHEEL, _POWER = ("--swing", "--speed", "--delta"), ("--power", "--speed")
_RIM, _DISC, _MASS = ("--rim-diameter", "--density"), ("--disc-diameter", "--density"), ("--radius",)
_SECTION, _CYCLES, _MOTOR = (*_RIM, "--rim-section"), ("--work", "--strokes"), ("--power", "--efficiency")
_RUN_UP = ("--run-up-torque", "--run-up-time", "--inertia", "--speed")
Row = tuple[str, str, Label, str, Shown, tuple[str, ...]]


_ROWS: tuple[Row, ...] = (
    ("power", "Leistung|Power", "$N$", "W", Shown("power"), _POWER),
    ("motor_power", "Leistung des Motors|Power of the motor", "$N_M$", "W", Shown("motor"), _MOTOR),
    ("strokes", "Arbeitsspiele|Cycles", "$z$", _PER_MINUTE, Shown("cycles", Product.of(60)), _CYCLES),
    ("work", "Arbeit eines Spiels|Work of a cycle", "$W$", "J", Shown("work"), _POWER),
    ("mean_torque", "mittleres Drehmoment|Mean torque", "$M_m$", "N m", Shown("mean_torque"), _POWER),
    ("energy_fluctuation", "Anteil des Arbeitsüberschusses|Coefficient of fluctuation of energy", "$(ΔW)/W$",
     "", Shown("energy_fluctuation"), ("--energy-fluctuation", *_POWER)),
    ("swing", "Arbeitsüberschuss|Energy swing", "$ΔW$", "J", Shown("swing"), _WHEEL),
    ("speed", "Drehzahl|Speed", "$n$", _PER_MINUTE, Shown("omega", _MINUTE), _WHEEL),
    ("omega", "Winkelgeschwindigkeit|Angular velocity", "$ω$", "rad/s", Shown("omega"), _WHEEL),
    ("delta", "Ungleichförmigkeitsgrad|Coefficient of fluctuation of speed", "$δ$", "", Shown("delta"),
     _WHEEL),
    ("steadiness", "Gleichförmigkeit|Coefficient of steadiness", "$1/δ$", "", Shown("delta", power=-1),
     _WHEEL),
    ("greatest_speed", "größte Drehzahl|Greatest speed", '$n_"max"$', _PER_MINUTE,
     Shown("omega_max", _MINUTE), _WHEEL),
    ("least_speed", "kleinste Drehzahl|Least speed", '$n_"min"$', _PER_MINUTE,
     Shown("omega_min", _MINUTE), _WHEEL),
    ("speed_drop", "Drehzahlabfall|Drop of speed", '$n_"max" - n_"min"$', _PER_MINUTE,
     Shown("drop", _MINUTE), _WHEEL),
    ("omega_max", "größte Winkelgeschwindigkeit|Greatest angular velocity", '$ω_"max"$', "rad/s",
     Shown("omega_max"), _WHEEL),
    ("omega_min", "kleinste Winkelgeschwindigkeit|Least angular velocity", '$ω_"min"$', "rad/s",
     Shown("omega_min"), _WHEEL),
    ("inertia", "Trägheitsmoment|Moment of inertia", "$J$", "kg m²", Shown("inertia"), _WHEEL),
    ("stored", "Bewegungsenergie|Kinetic energy", "$J ω^2/2$", "J", Shown("stored"), _WHEEL),
    ("run_up_torque", "Drehmoment des Anlaufs|Torque of running up", "$M_a$", "N m", Shown("run_up_torque"),
     _RUN_UP),
    ("run_up_time", "Zeit des Anlaufs|Time of running up", "$t_a$", "s", Shown("run_up_time"), _RUN_UP),
    ("run_up_turns", "Umdrehungen des Anlaufs|Turns of running up", "$u_a$", "", Shown("run_up_turns"),
     _RUN_UP),
    ("run_up_acceleration", "Winkelbeschleunigung des Anlaufs|Angular acceleration of running up", "$ε_a$",
     "rad/s²", Shown("run_up_acceleration"), _RUN_UP),
    ("run_up_energy", "Arbeit des Anlaufs|Energy of running up", "$W_a$", "J", Shown("stored"), _RUN_UP),
    ("slip_energy", "Verlust der Kupplung|Loss of the clutch", "$W_k$", "J", Shown("stored"), _RUN_UP),
    ("mass", "Masse|Mass", "$m$", "kg", Shown("mass"), _MASS),
    ("radius", "Trägheitshalbmesser|Radius of gyration", "$k$", "m", Shown("radius"), _MASS),
    ("rim_share", "Anteil des Kranzes|Share of the rim", "$J_R/J$", "", Shown("rim_share"),
     _RIM),
    ("rim_inertia", "Trägheitsmoment des Kranzes|Moment of inertia of the rim", "$J_R$", "kg m²",
     Shown("rim_inertia"), _RIM),
    ("rim_diameter", "mittlerer Durchmesser des Kranzes|Mean diameter of the rim", "$D$", "m",
     Shown("rim_diameter"), _RIM),
    ("rim_speed", "Geschwindigkeit des Kranzes|Speed of the rim", "$v$", "m/s", Shown("rim_speed"), _RIM),
    ("hoop_stress", "Ringspannung|Hoop stress", "$σ$", "MPa", Shown("hoop_stress", _MPA), _RIM),
    ("rim_mass", "Masse des Kranzes|Mass of the rim", "$m_R$", "kg", Shown("rim_mass"), _RIM),
    ("section", "Querschnitt des Kranzes|Section of the rim", "$A$", "cm²", Shown("section", _CM2), _RIM),
    ("breadth", "Breite des Kranzes|Breadth of the rim", "$b$", "mm", Shown("breadth", _MM), _SECTION),
    ("thickness", "Dicke des Kranzes|Thickness of the rim", "$t$", "mm", Shown("thickness", _MM), _SECTION),
    ("disc_diameter", "Durchmesser der Scheibe|Diameter of the disc", "$D$", "m", Shown("disc_diameter"),
     _DISC),
    ("disc_thickness", "Dicke der Scheibe|Thickness of the disc", "$t$", "mm",
     Shown("disc_thickness", _MM), _DISC),
    ("disc_stress", "größte Spannung der Scheibe|Greatest stress of the disc", "$σ$", "MPa",
     Shown("disc_stress", _MPA), ("--poisson", "--density", "--speed")),
)  # fmt: skip


SHOWN: Mapping[str, Shown] = {row[0]: row[4] for row in _ROWS}


@cache
def registry() -> Mapping[str, Quantity]:
    """Return every quantity by its key, in the order of the page; a kernel call takes the figure."""
    entries = (
        entry(
            key, name, symbol, unit, None, {"exact": Formula(shown.of)},
            needs=(_figured(key, options),),
        )
        for key, name, symbol, unit, shown, options in _ROWS
    )  # fmt: skip
    own = (*entries, _acceleration())
    return {one.key: one._replace(heading=with_symbol(one)) for one in own}


def _figured(key: str, options: tuple[str, ...]) -> Need:
    return Need(lambda asked: asked.wheels[0].knows(key), options)


def _acceleration() -> Quantity:
    """The angular acceleration by the excess torque at a crank angle, of which a kernel call makes it."""
    name = "Winkelbeschleunigung|Angular acceleration"
    formula = Formula(lambda torque, inertia, kind: torque(kind) / inertia.on(kind))
    needs = Need(
        lambda asked: asked.angle is not None and asked.wheels[0].knows("inertia"),
        ("--torque", "--angle", "--inertia"),
    )
    return entry(ACCELERATION, name, "$α$", "rad/s²", None, {"exact": formula}, needs=(needs,))


class Rule(NamedTuple):
    """How one of the figures follows from others."""

    of: str
    needs: tuple[str, ...]
    value: Callable[[Values], Product]


def _law(constant: Product, **powers: int) -> Term:
    """Return what is 1 where the product of these powers is the constant."""
    return Term(_ONE / constant, {name: Fraction(power) for name, power in powers.items()})


def _rules(law: Term) -> Iterator[Rule]:
    """Yield how each figure follows from the others."""
    for of in law.powers:
        told = law.solved_for(of)

        def value(values: Values, told: Term = told) -> Product:
            for name in told.powers:
                told = told.put(name, Term(values[name]))
            return told.known

        yield Rule(of, (*told.powers,), value)


LAWS: Sequence[Term] = (
    _law(_ONE, swing=1, inertia=-1, omega=-2, delta=-1),
    _law(_ONE, drop=1, omega=-1, delta=-1),
    _law(_ONE, inertia=1, mass=-1, radius=-2),
    _law(_ONE, swing=1, energy_fluctuation=-1, work=-1),
    _law(_ONE, power=1, work=-1, cycles=-1),
    _law(_ONE, power=1, motor=-1, efficiency=-1),
    _law(Product.of(2, 1), omega=1, cycles=-1, turns=-1),
    _law(_ONE, power=1, mean_torque=-1, omega=-1),
    _law(Product.of(2, 1), work=1, mean_torque=-1, turns=-1),
    _law(_HALF, stored=1, inertia=-1, omega=-2),
    # From rest under a constant torque: ω = ε t, M = J ε, 2π u = ½ ω t. A clutch between a shaft that keeps ω
    # and the flywheel loses what this takes up: ∫ M (ω - ε t) dt = ½ J ω².
    _law(_ONE, omega=1, run_up_acceleration=-1, run_up_time=-1),
    _law(_ONE, run_up_torque=1, inertia=-1, run_up_acceleration=-1),
    _law(Product.of(4, 1), omega=1, run_up_time=1, run_up_turns=-1),
    # The rim: v = ½ ω D, σ = ρ v², m = ρ A π D, A = b t, J = m (D/2)².
    _law(_HALF, rim_speed=1, omega=-1, rim_diameter=-1),
    _law(_ONE, hoop_stress=1, density=-1, rim_speed=-2),
    _law(Product.of(1, 1), rim_mass=1, density=-1, section=-1, rim_diameter=-1),
    _law(_ONE, section=1, breadth=-1, thickness=-1),
    _law(_ONE, breadth=1, thickness=-1, proportion=-1),
    _law(_ONE, section=1, proportion=-1, thickness=-2),
    _law(_ONE, breadth=1, breadth_share=-1, rim_diameter=-1),
    _law(_ONE, thickness=1, thickness_share=-1, rim_diameter=-1),
    _law(Product.of(Fraction(1, 4)), rim_inertia=1, rim_mass=-1, rim_diameter=-2),
    _law(_ONE, rim_inertia=1, inertia=-1, rim_share=-1),
    # Of these without ω: J_R/J ΔW = m v² δ.
    _law(_ONE, swing=1, rim_share=1, rim_mass=-1, rim_speed=-2, delta=-1),
)


# J = ½ m (D/2)², m = ρ π/4 D² t; in the middle of a disc without a hole σ = (3 + ν)/8 ρ (ω D/2)² (Stodola).
OF_DISC: Sequence[Term] = (
    _law(Product.of(Fraction(1, 8)), inertia=1, mass=-1, disc_diameter=-2),
    _law(Product.of(Fraction(1, 4), 1), mass=1, density=-1, disc_diameter=-2, disc_thickness=-1),
    _law(_ONE, disc_thickness=1, disc_share=-1, disc_diameter=-1),
    _law(Product.of(Fraction(1, 4)), disc_stress=1, disc_bulge=-1, density=-1, omega=-2, disc_diameter=-2),
)


# ΔW = J ω² δ holds exactly with ω = ½ (ω_max + ω_min) and δ = (ω_max - ω_min)/ω.
_NAMES = {"omega_max": "greatest", "omega": "mean", "omega_min": "least"}


def _above_rest(delta: Product) -> Product:
    """Return 1 - δ/2. Raises ProblemError where it is not above 0."""
    why = "it must be below 2, at which the flywheel would come to rest in every turn"
    return _less(_ONE, delta * _HALF, f"degree of irregularity δ is {figures_of(delta)}; {why}")


def _mean(values: Values) -> Product:
    return values["omega_max"].plus(values["omega_min"]) * _HALF


def _between(values: Values, high: str, low: str) -> Product:
    """Return the difference of two speeds. Raises ProblemError where it is not above 0."""
    one, other = (f"{figures_of(turns_a_minute(values[name]))}/min" for name in (high, low))
    said = f"the {_NAMES[high]} speed is {one} and the {_NAMES[low]} {other}"
    return _less(values[high], values[low], f"{said}; the {_NAMES[high]} must be above the {_NAMES[low]}")


def _fallen(values: Values) -> Product:
    """Return ω_min, at which the flywheel has given up the swing. Raises ProblemError where it rests."""
    inertia, swing = values["inertia"], values["swing"]
    energy = inertia * values["omega_max"] ** _SQUARE * _HALF
    said = f"the flywheel has {figures_of(energy)} J at its greatest speed and is to give up"
    left = _less(energy, swing, f"{said} {figures_of(swing)} J; it would come to rest, give a heavier one")
    return (left * _TWO / inertia) ** _ROOT


def _risen(values: Values) -> Product:
    """Return ω_max, at which it has taken up the swing."""
    energy = values["inertia"] * values["omega_min"] ** _SQUARE * _HALF
    return (energy.plus(values["swing"]) * _TWO / values["inertia"]) ** _ROOT


def _less(one: Product, other: Product, sentence: str) -> Product:
    if not one.exceeds(other):
        raise ProblemError(sentence)
    return one.plus(other, -1)


def _twice(values: Values, high: str, low: str) -> Product:
    """Return δ of the mean and another speed."""
    return _between(values, high, low) * _TWO / values["omega"]


_ENDS = ("omega_max", "omega_min")


_SPEEDS = (
    Rule("omega", ("omega_max", "omega_min"), _mean),
    Rule("delta", ("omega_max", "omega_min"), lambda one: _between(one, *_ENDS) / _mean(one)),
    Rule("delta", ("omega_max", "omega"), lambda one: _twice(one, "omega_max", "omega")),
    Rule("delta", ("omega", "omega_min"), lambda one: _twice(one, "omega", "omega_min")),
    Rule("omega", ("omega_max", "delta"), lambda one: one["omega_max"] / _ONE.plus(one["delta"] * _HALF)),
    Rule("omega", ("omega_min", "delta"), lambda one: one["omega_min"] / _above_rest(one["delta"])),
    Rule("omega_max", ("omega", "delta"), lambda one: one["omega"] * _ONE.plus(one["delta"] * _HALF)),
    Rule("omega_min", ("omega", "delta"), lambda one: one["omega"] * _above_rest(one["delta"])),
    Rule("omega_min", ("omega_max", "swing", "inertia"), _fallen),
    Rule("omega_max", ("omega_min", "swing", "inertia"), _risen),
)


RULES: Sequence[Rule] = (*_SPEEDS, *(rule for law in LAWS for rule in _rules(law)))


# Of a solid disc alone.
DISC_RULES: Sequence[Rule] = tuple(rule for law in OF_DISC for rule in _rules(law))


def turns_a_minute(omega: Product) -> Product:
    """Return n in 1/min of ω in 1/s."""
    return omega * Product.of(30, -1)


def figures_of(product: Product) -> str:
    """Return a number to five figures, for a sentence."""
    return number_text(product.number(None, "half-away"))
