"""The functions of `import kurbel` about harmonics and the balance of engines."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction

from kurbel.page.folders import LANGUAGES
from kurbel.page.layouts import layout_of
from kurbel.page.table import Table
from kurbel.reading import notation
from kurbel.reading.choices import choose
from kurbel.reading.given import (
    Exact,
    as_angle,
    as_fraction,
    as_names,
    as_ratio,
    as_share,
    read_each,
    read_values,
)


def make_harmonics_table(
    ratios: Exact | Iterable[Exact] | None = None,
    *,
    quantity: str = "",
    orders: int = 6,
    method: str = "exact",
    layout: str = "harmonics",
    digits: int | None = None,
    rounding: str = "half-away",
    lang: str = "de",
    label: str = "",
) -> Table:
    """Return the page of the harmonics of the piston's motion, as `kurbel harmonics` prints it.

    `quantity` is "x", "c" or "p" (default), `orders` the last order. Raises KurbelError.

    >>> from kurbel import typeset
    >>> print(typeset(make_harmonics_table("1:5", orders=4), "csv"), end="")
    order,ratio,value
    1,1:5,1.000000
    2,1:5,0.202038
    4,1:5,-0.002062
    """
    from kurbel.balance.harmonics_page import HarmonicsRequest
    from kurbel.page.build import build

    page = layout_of(layout, ("harmonics",))
    return build(
        HarmonicsRequest(
            layout=page,
            ratios=tuple(read_values(page.ratios if ratios is None else ratios, notation.ratios, as_ratio)),
            quantity=quantity,
            last_order=orders,
            method=method,
            digits=digits,
            rounding=rounding,
            lang=choose(lang, LANGUAGES, "language"),
            label=label,
        )
    )


def make_balance_table(
    engine: str | None = None,
    ratios: Exact | Iterable[Exact] | None = None,
    *,
    cranks: Exact | Iterable[Exact] = (),
    positions: Exact | Iterable[Exact] = (),
    banks: Exact | Iterable[Exact] = (),
    share: Exact = 0,
    orders: int = 2,
    method: str = "exact",
    layout: str = "balance",
    columns: str | Iterable[str] = (),
    digits: int | None = None,
    rounding: str = "half-away",
    lang: str = "de",
    label: str = "",
) -> Table:
    """Return the page of the free forces and moments of an engine, as `kurbel balance` prints it.

    The engine is one that has a name, "inline-4" by default, or has these `cranks` and `banks` in degrees
    and `positions` in a unit of your own; `share` is that of each reciprocating mass which counterweights
    balance, `orders` the last order. Raises KurbelError.

    >>> from kurbel import typeset
    >>> page = make_balance_table("inline-4", "1:5", columns="residual,order,along,across")
    >>> print(typeset(page, "csv"), end="")
    residual,order,along,across
    force,1,0,0
    force,2,0.8082,0
    moment,1,0,0
    moment,2,0,0
    """
    from kurbel.balance.request import BalanceRequest, arranged
    from kurbel.page.build import build

    page = layout_of(layout, ("balance",))
    name, arrangement = arranged(
        engine,
        _read(cranks, notation.crank_angles, as_angle),
        _read(positions, _positions, as_fraction),
        _read(banks, notation.crank_angles, as_angle),
        as_share(share),
    )
    return build(
        BalanceRequest(
            layout=page,
            arrangement=arrangement,
            ratios=tuple(read_values(page.ratios if ratios is None else ratios, notation.ratios, as_ratio)),
            engine=name,
            last_order=orders,
            method=method,
            digits=digits,
            rounding=rounding,
            lang=choose(lang, LANGUAGES, "language"),
            columns=as_names(columns),
            label=label,
        )
    )


def _read(
    given: Exact | Iterable[Exact],
    listed: Callable[[str], Sequence[Fraction]],
    one: Callable[[Exact], Fraction],
) -> Sequence[Fraction]:
    return listed(given) if isinstance(given, str) else read_each(given, one)


def _positions(text: str) -> tuple[Fraction, ...]:
    return notation.each_number([text], "position")
