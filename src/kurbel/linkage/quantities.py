"""The kinds of entry that crank drives without a crosshead have in common: motion and forces."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any, NamedTuple

from kurbel.exact.numerals import Label
from kurbel.kernel import linkage
from kurbel.kernel.linkage import Place
from kurbel.motion.quantities import entry, newton_metres, newtons
from kurbel.page.quantity import Formula, Quantity, words

DECIMALS = 4
# What quantities are of that one force calls up.
FORCE = "force"


class Force(NamedTuple):
    """A force that one force F calls up: in which direction it is positive, and the kernel's formula."""

    name: str
    letter: str
    direction: str
    kernel: Callable[[Place[Any]], Any]


FORCES: Mapping[str, Force] = {
    "rod_force": Force(
        "Stangenkraft|Rod force", "S",
        "$S$ am Stangenende, auf dem Hingang Druck, auf dem Rückgang Zug"
        "|$S$ at the rod's end, thrust on the outstroke, pull on the return",
        linkage.rod_force,
    ),
    "guide_force": Force(
        "Schwingenkraft|Rocker force", "N",
        "$N$ längs der Schwinge auf das Stangenende, nach der Seite, auf der in diesem Hub der Kurbelzapfen"
        " läuft"
        "|$N$ along the rocker on the rod's end, towards the side on which the crank pin runs in that stroke",
        linkage.rocker_force,
    ),
    "tangential_force": Force(
        "Tangentialkraft|Tangential force", "T", "$T$ im Drehsinn|$T$ as the crank turns",
        linkage.tangential_force,
    ),
    "radial_force": Force(
        "Radialkraft|Radial force", "Z", "$Z$ nach der Welle hin|$Z$ towards the shaft", linkage.radial_force
    ),
}  # fmt: skip
TORQUE = "Drehmoment|Torque"


def force_formula(key: str, printed: Label, symbols: tuple[Label, ...] = ()) -> Formula:
    """Return the formula of a force as a page prints it."""
    kernel = FORCES[key].kernel
    return Formula(lambda at: kernel(at.place), printed, symbols)


def force_entries(printed: Mapping[str, Formula]) -> Iterator[Quantity]:
    """Yield the forces with these formulas as shares of F and in newtons, and the torque that they make."""
    for key, formula in printed.items():
        name, letter, direction, _ = FORCES[key]
        of: dict[str, Any] = {"direction": words(direction), "of": FORCE}
        formulas = {"exact": formula}
        yield entry(key, name, f"${letter}$", f"${letter}/F$", "$F$", DECIMALS, formulas, names=(key,), **of)
        yield entry(
            f"{key}_n", name, f"${letter}$", f"${letter}$ in N", "N", 1, formulas, scale=newtons,
            needs="force", **of,
        )  # fmt: skip
    torque = {"exact": Formula(lambda at: linkage.tangential_force(at.place), "$M_d/(F R) = T/F$")}
    yield entry(
        "torque", TORQUE, "$M_d$", "$M_d/(F R)$", "$F R$", DECIMALS, torque, names=("torque",), of=FORCE
    )
    yield entry(
        "torque_nm", TORQUE, "$M_d$", "$M_d$ in N m", "N m", 1, torque, scale=newton_metres, needs="torque",
        of=FORCE,
    )  # fmt: skip
