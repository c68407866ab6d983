"""What a flywheel's page can show; each entry is one of the figures of relations.py in a unit of its own."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from functools import cache
from typing import NamedTuple

from kurbel.exact.numerals import Label
from kurbel.exact.product import Product
from kurbel.page.quantity import Formula, Quantity, entry


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
# By what a figure needs, the options that give it.
NEEDS: Mapping[str, tuple[str, ...]] = {
    "wheel": ("--swing", "--speed", "--delta"),
    "power": ("--power", "--speed"),
    "cycles": ("--work", "--strokes"),
    "motor": ("--power", "--efficiency"),
    "fluctuation": ("--energy-fluctuation", "--power", "--speed"),
    "mass": ("--radius",),
    "rim": ("--rim-diameter", "--density"),
    "section": ("--rim-diameter", "--density", "--rim-section"),
    "disc": ("--disc-diameter", "--density"),
    "diagram": ("--torque",),
}
Row = tuple[str, str, Label, str, Shown, str]
_ROWS: tuple[Row, ...] = (
    ("power", "Leistung|Power", "$N$", "W", Shown("power"), "power"),
    ("motor_power", "Leistung des Motors|Power of the motor", "$N_M$", "W", Shown("motor"), "motor"),
    ("strokes", "Arbeitsspiele|Cycles", "$z$", _PER_MINUTE, Shown("cycles", Product.of(60)), "cycles"),
    ("work", "Arbeit eines Spiels|Work of a cycle", "$W$", "J", Shown("work"), "power"),
    ("mean_torque", "mittleres Drehmoment|Mean torque", "$M_m$", "N m", Shown("mean_torque"), "power"),
    ("energy_fluctuation", "Anteil des Arbeitsüberschusses|Coefficient of fluctuation of energy", "$(ΔW)/W$",
     "", Shown("energy_fluctuation"), "fluctuation"),
    ("swing", "Arbeitsüberschuss|Energy swing", "$ΔW$", "J", Shown("swing"), "wheel"),
    ("speed", "Drehzahl|Speed", "$n$", _PER_MINUTE, Shown("omega", _MINUTE), "wheel"),
    ("omega", "Winkelgeschwindigkeit|Angular velocity", "$ω$", "rad/s", Shown("omega"), "wheel"),
    ("delta", "Ungleichförmigkeitsgrad|Coefficient of fluctuation of speed", "$δ$", "", Shown("delta"),
     "wheel"),
    ("steadiness", "Gleichförmigkeit|Coefficient of steadiness", "$1/δ$", "", Shown("delta", power=-1),
     "wheel"),
    ("greatest_speed", "größte Drehzahl|Greatest speed", '$n_"max"$', _PER_MINUTE,
     Shown("omega_max", _MINUTE), "wheel"),
    ("least_speed", "kleinste Drehzahl|Least speed", '$n_"min"$', _PER_MINUTE,
     Shown("omega_min", _MINUTE), "wheel"),
    ("omega_max", "größte Winkelgeschwindigkeit|Greatest angular velocity", '$ω_"max"$', "rad/s",
     Shown("omega_max"), "wheel"),
    ("omega_min", "kleinste Winkelgeschwindigkeit|Least angular velocity", '$ω_"min"$', "rad/s",
     Shown("omega_min"), "wheel"),
    ("inertia", "Trägheitsmoment|Moment of inertia", "$J$", "kg m²", Shown("inertia"), "wheel"),
    ("stored", "Bewegungsenergie|Kinetic energy", "$J ω^2/2$", "J", Shown("stored"), "wheel"),
    ("mass", "Masse|Mass", "$m$", "kg", Shown("mass"), "mass"),
    ("radius", "Trägheitshalbmesser|Radius of gyration", "$k$", "m", Shown("radius"), "mass"),
    ("rim_share", "Anteil des Kranzes|Share of the rim", "$J_R/J$", "", Shown("rim_share"),
     "rim"),
    ("rim_inertia", "Trägheitsmoment des Kranzes|Moment of inertia of the rim", "$J_R$", "kg m²",
     Shown("rim_inertia"), "rim"),
    ("rim_diameter", "mittlerer Durchmesser des Kranzes|Mean diameter of the rim", "$D$", "m",
     Shown("rim_diameter"), "rim"),
    ("rim_speed", "Geschwindigkeit des Kranzes|Speed of the rim", "$v$", "m/s", Shown("rim_speed"), "rim"),
    ("hoop_stress", "Ringspannung|Hoop stress", "$σ$", "MPa", Shown("hoop_stress", _MPA), "rim"),
    ("rim_mass", "Masse des Kranzes|Mass of the rim", "$m_R$", "kg", Shown("rim_mass"), "rim"),
    ("section", "Querschnitt des Kranzes|Section of the rim", "$A$", "cm²", Shown("section", _CM2), "rim"),
    ("breadth", "Breite des Kranzes|Breadth of the rim", "$b$", "mm", Shown("breadth", _MM), "section"),
    ("thickness", "Dicke des Kranzes|Thickness of the rim", "$t$", "mm", Shown("thickness", _MM), "section"),
    ("disc_diameter", "Durchmesser der Scheibe|Diameter of the disc", "$D$", "m", Shown("disc_diameter"),
     "disc"),
    ("disc_thickness", "Dicke der Scheibe|Thickness of the disc", "$t$", "mm",
     Shown("disc_thickness", _MM), "disc"),
)  # fmt: skip
SHOWN: Mapping[str, Shown] = {row[0]: row[4] for row in _ROWS}


@cache
def registry() -> Mapping[str, Quantity]:
    """Return every quantity by its key, in the order of the page; a kernel call takes the figure."""
    return {
        key: entry(
            key, name, symbol, unit, None, {"exact": Formula(shown.of)}, _heading(name, symbol), needs=needs
        )
        for key, name, symbol, unit, shown, needs in _ROWS
    }


def _heading(name: str, symbol: Label) -> str:
    return "|".join(f"{one} {symbol}" for one in name.split("|"))
