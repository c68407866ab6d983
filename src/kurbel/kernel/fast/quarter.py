"""The choice of the quarter turn without a branch: what kernel/circle.py does of one angle, as a formula."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from kurbel.kernel.fast.trace import Traced

# Added to a number below 2**51 it leaves the nearest whole number, half to even, in the last bits.
WHOLE = float(3 << 51)


class Sign:
    """1 or -1, of which a product is the other number with its sign turned or not."""

    def __init__(self, turned: Traced) -> None:
        self.turned = turned

    def __mul__(self, other: Traced) -> Traced:
        bits = f"float64({other.name}).view(int64) ^ {self.turned.name}"
        return other.tape.number(f"int64({bits}).view(float64)")


def unrounded(degrees: Traced, parts: Callable[[Traced], Any]) -> Any:
    """Return the turns of sine, cosine and versine, the part that the sine takes and that of the others.

    `parts` gives sine and versine within ±45°, unrounded. The bits are those of `kernel.circle`.
    """
    tape = degrees.tape
    with tape.law():
        raised = degrees / 90 + WHOLE
        sine, versine = parts(degrees - 90 * (raised - WHOLE))
        # Rows of QUARTERS in kernel/circle.py, by the last two bits of the number of quarters.
        bits = tape.number(f"float64({raised.name}).view(int64)")
        odd = tape.number(f"{bits.name} & 1 != 0")
        back, not_back, falls = (_sign(bits, change) for change in ("", " ^ 2", " + 1"))
        one = back * tape.number("1.0 + 0.0")
        of_sine, of_cosine = _chosen(odd, one, 0.0), _chosen(odd, 0.0, one)
    return (
        [(of_sine, falls), (of_cosine, not_back), (1 - of_cosine, back)],
        sine._make(_chosen(odd, *either) for either in zip(versine, sine, strict=True)),
        sine._make(_chosen(odd, *either) for either in zip(sine, versine, strict=True)),
    )


def _sign(bits: Traced, change: str) -> Sign:
    """Return -1 where the second last bit is set, once the bits are changed."""
    return Sign(bits.tape.number(f"(({bits.name}{change}) & 2) << 62"))


def _chosen(condition: Traced, one: Any, other: Any) -> Traced:
    tape = condition.tape
    return tape.number(f"({tape.name(one)} if {condition.name} else {tape.name(other)})")
