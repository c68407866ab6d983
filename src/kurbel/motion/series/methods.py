"""Series of higher order than the books', as methods."""

from __future__ import annotations

from kurbel.motion.evaluation import REACH, Method
from kurbel.page.quantity import words

_ORDINALS = {
    3: ("dritter", "third"),
    5: ("fünfter", "fifth"),
    7: ("siebter", "seventh"),
    9: ("neunter", "ninth"),
}
ORDERS = {
    key: Method(
        key,
        words(f"Näherung {_ORDINALS[order][0]} Ordnung|{_ORDINALS[order][1]} order"),
        words(f"Näherung {_ORDINALS[order][0]} Ordnung|{_ORDINALS[order][1]}-order formulas"),
    )
    for key, order in REACH.items()
}


def series_of(order: int) -> str:
    """Return the method by powers of λ up to this one; even powers add nothing, the first is the books'."""
    odd = order - 1 + order % 2
    return f"series-{odd}" if odd > 1 else "series"
