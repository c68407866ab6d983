"""The forces that crank drives without a crosshead have in common: one entry each, in F and in newtons."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any

from kurbel.exact.numerals import Label
from kurbel.kernel import linkage
from kurbel.kernel.linkage import Place
from kurbel.motion import quantities
from kurbel.motion.entries import Formulas
from kurbel.motion.quantities import Force
from kurbel.page.quantity import Formula, Quantity

DECIMALS = 4
# What quantities are of that one force calls up.
FORCE = "force"


FORCES: Mapping[str, Force] = {
    **{key: one for key, one in quantities.FORCES.items() if key not in quantities.EFFORT},
    "rod_force": Force(
        "Stangenkraft|Rod force", "S",
        "$S$ am Stangenende, auf dem Hingang Druck, auf dem Rückgang Zug"
        "|$S$ at the rod's end, thrust on the outstroke, pull on the return",
    ),
    "guide_force": Force(
        "Schwingenkraft|Rocker force", "N",
        "$N$ längs der Schwinge auf das Stangenende, nach der Seite, auf der in diesem Hub der Kurbelzapfen"
        " läuft"
        "|$N$ along the rocker on the rod's end, towards the side on which the crank pin runs in that stroke",
    ),
    "crosshead_pin_force": Force(
        "Kraft am Schwingenzapfen|Rocker-pin force", "G",
        "$G$ Betrag am Zapfen von Stange und Schwinge|$G$ magnitude at the pin of rod and rocker",
    ),
}  # fmt: skip
_KERNELS: Mapping[str, Callable[[Place[Any]], Any]] = {
    "rod_force": linkage.rod_force,
    "guide_force": linkage.rocker_force,
    "tangential_force": linkage.tangential_force,
    "radial_force": linkage.radial_force,
}


def force_formula(key: str, printed: Label, symbols: tuple[Label, ...] = ()) -> Formula:
    """Return the formula of a force as a page prints it."""
    kernel = _KERNELS[key]
    return Formula(lambda at: kernel(at.place), printed, symbols)


def force_entries(printed: Mapping[str, Formula], masses: bool = False) -> Iterator[Quantity]:
    """Yield the forces with these formulas as shares of F and in newtons, and the torque that they make.

    A drive that may have moving `masses` has also the forces that these alone show.
    """
    newton = quantities.in_newtons if masses else _alone
    for key in {**printed, **(FORCES if masses else {})}:
        shares = {"exact": printed[key]} if key in printed else {}
        yield from quantities.force_entries(key, FORCES[key], shares, newton(key, shares), of=FORCE)
    torque = {"exact": force_formula("tangential_force", "$M_d/(F R) = T/F$")}
    yield from quantities.torque_entries(torque, newton("tangential_force", torque), of=FORCE)


def _alone(key: str, shares: Formulas) -> Formulas:
    return shares
