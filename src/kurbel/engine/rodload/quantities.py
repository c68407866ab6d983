"""What a page of the rod's load can show: its extremes, where they lie, and its reversal.

A kernel takes the load of one end of the rod and returns a number of its kind, None where there is none.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import cache, partial
from typing import Any, NamedTuple

from kurbel.engine.cylinder import AnyTurn
from kurbel.engine.quantities import ENGINE_METHODS, engine_registry
from kurbel.engine.rodload.load import PULL, THRUST, AnyRodLoad
from kurbel.exact.numerals import Label
from kurbel.page.quantity import Formula, Quantity, Words, entry, words

# What a number is of: an extreme, its place, a span of the cycle, or a share of an extreme.
FORCE, PLACE, SPAN, SHARE = "force", "place", "span", "share"
DEGREE_DECIMALS = 3
SPAN_DECIMALS = 2


# The forces of CRANK_FORCES that are the load at a place of the rod, and what pages call the places.
ENDS: Mapping[str, tuple[str, Words]] = {
    "slide": ("crosshead_load", words("Kreuzkopfzapfen|Crosshead pin")),
    "crosshead": ("rod_force", words("Stange am Kreuzkopf|Rod at the crosshead")),
    "crank": ("pin_rod_force", words("Stange an der Kurbel|Rod at the crank")),
}
SLIDE = words("am Kreuzkopfzapfen: längs der Führung|at the crosshead pin: along the slide")


def end_entry(end: str) -> Quantity:
    """Return the load at a place, which other drives name otherwise, by the name of the place."""
    force, name = ENDS[end]
    return engine_registry()[force]._replace(name=name, direction=SLIDE)


class _Sign(NamedTuple):
    sign: int
    key: str
    name: str
    symbol: Label


_SIGNS = (
    _Sign(THRUST, "thrust", "Druck|thrust", '$S_"max"$'),
    _Sign(PULL, "pull", "Zug|pull", '$-S_"min"$'),
)


def sign_of(quantity: Quantity) -> int:
    """Return the sign of the extreme that a quantity is of."""
    return next(one.sign for one in _SIGNS if one.key in quantity.key)


@cache
def rod_quantities() -> Mapping[str, Quantity]:
    """Return every quantity of the rod's load by its key."""
    return {one.key: one for one in (*_extremes(), *_spans())}


def _entry(
    key: str, name: str, symbol: Label, unit: Label, of: str, decimals: int, kernel: Callable[[Any], Any],
    **rest: Any,
) -> Quantity:  # fmt: skip
    formulas = dict.fromkeys(ENGINE_METHODS, Formula(kernel))
    return entry(key, name, symbol, unit, decimals, formulas, spanners=(words(name),), of=of, **rest)


def _greatest(sign: int, load: AnyRodLoad) -> Any:
    return load.greatest(sign)


def _degrees(sign: int, load: AnyRodLoad) -> Any:
    return load.degrees(sign)


def _angle(sign: int, load: AnyRodLoad) -> Any:
    return 180 * load.angle(sign)


def _extremes() -> Iterator[Quantity]:
    for sign, key, name, symbol in _SIGNS:
        de, en = name.split("|")
        title = f"größter {de}|Greatest {en}"
        force = _entry(key, title, symbol, "$Q$", FORCE, 4, partial(_greatest, sign))
        yield force
        yield force._replace(
            key=f"{key}_n", unit=words("N"), decimals=1, heading=words(f"{symbol} in N"),
            scale=AnyTurn.force_unit, needs="load",
        )  # fmt: skip
        yield _entry(
            f"phi_{key}", f"größter {de} bei|Greatest {en} at", "$φ$", "°", PLACE, DEGREE_DECIMALS,
            partial(_degrees, sign), minutes=True,
        )  # fmt: skip


def _spans() -> Iterator[Quantity]:
    for sign, key, name, _ in _SIGNS:
        de, en = name.split("|")
        yield _entry(
            f"{key}_angle", f"{de} über|{en[:1].upper()}{en[1:]} over", "", "°", SPAN, SPAN_DECIMALS,
            partial(_angle, sign),
        )  # fmt: skip
    yield _entry(
        "reversal_angle", "Richtungswechsel über|Reversal over", "", "°", SPAN, SPAN_DECIMALS,
        lambda load: 180 * load.reversal(),
    )  # fmt: skip
    yield _entry(
        "reversal_unbroken", "davon am Stück|longest unbroken", "", "°", SPAN, SPAN_DECIMALS,
        lambda load: 180 * load.reversal(unbroken=True),
    )  # fmt: skip
    yield _entry(
        "reversal_share", "Gegenlast, Anteil der größten|Reversed load, share of the greatest", "", "%",
        SHARE, SPAN_DECIMALS, lambda load: 100 * load.reversed_share(),
    )  # fmt: skip
