"""The order of a series: the highest power of λ that it keeps of the piston path."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from kurbel.errors import ProblemError
from kurbel.motion.evaluation import REACH
from kurbel.motion.series.methods import series_of
from kurbel.reading.given import as_numbers
from kurbel.reading.notation import plain

HIGHEST = max(REACH.values())


def orders_of(order: Any) -> tuple[int, ...]:
    """Return the orders that are asked for. Raises KurbelError."""
    found = as_numbers(order, "order")
    for one in found:
        if one not in range(1, HIGHEST + 1):
            raise ProblemError(
                f"order {plain(one)} is not the highest power of λ of a series; write a whole number from 1"
                f" to {HIGHEST}"
            )
    return tuple(map(int, found))


def by_order(given: Mapping[str, Any]) -> str:
    """Return the method of one order. Raises ProblemError where no series was asked for, or several."""
    orders = orders_of(given["order"])
    if given["method"] != "series":
        raise ProblemError(
            "--order is the highest power of λ of a series; add --method series, or leave --order out"
        )
    if len(orders) != 1:
        raise ProblemError(
            f"a page is of one order, and {len(orders)} were given; choose one, or see the greatest errors of"
            " several by --layout series-errors"
        )
    return series_of(orders[0])
