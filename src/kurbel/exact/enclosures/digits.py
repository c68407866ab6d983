"""Digits of long columns: those of floats, but for cells whose bound holds a rounding boundary."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from kurbel.exact.bulk import Integers, nearest
from kurbel.exact.enclosures.enclosure import Enclosure

# Up to this share of doubtful cells floats are worth their while.
DOUBTFUL_SHARE = 0.1
# Integers of 64 bits hold a million times as much, should a number be so much greater between two probes.
GREATEST = 2.0**43


def column(value: Callable[[], Any], size: int) -> Enclosure | None:
    """Return a column of so many cells, None where its formula is NotImplemented.

    What is not known of a cell makes its error infinite or no number there.
    """
    # What is divided by nothing or compared with it is read by nobody.
    with np.errstate(all="ignore"):
        made = value()
        if made is NotImplemented:
            return None
        found = Enclosure.of(made)
    return Enclosure(*(np.broadcast_to(part, (size,)) for part in (found.value, found.error)))


def is_worth(probe: Enclosure, places: int) -> bool:
    """Whether cells that are alike would be settled in floats, nearly all of them."""
    unit = 10.0**places
    known = np.isfinite(probe.error) & np.isfinite(probe.value)
    share = 2 * unit * probe.error[known]
    greatest = abs(probe.value[known]).max(initial=0) * unit
    return bool(known.any() and share.max() < DOUBTFUL_SHARE and greatest < GREATEST)


def settled(found: Enclosure, places: int, rounding: str, exactly: Callable[[int], int]) -> Integers:
    """Return the column times 10**places, rounded; `exactly` settles a doubtful cell by its row."""
    with np.errstate(all="ignore"):
        scaled, doubtful = nearest(found.value, places, found.error, half_even=rounding == "half-even")
    for row in doubtful.nonzero()[0].tolist():
        scaled[row] = exactly(row)
    return scaled
