"""What can stand in a table of the beam engine as a crank drive: what an arc crank has, by other names."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

from kurbel.linkage.arc.names import named
from kurbel.linkage.arc.quantities import arc_registry
from kurbel.linkage.beam.captions import NAMES
from kurbel.page.quantity import Quantity

# Of the way of the rod's end, which no piston has.
OF_END = ("chord", "slide_path", "rise")


@cache
def beam_registry() -> Mapping[str, Quantity]:
    """Return every quantity of the beam engine by its key, the return stroke's beside the outstroke's."""
    return {
        key: named(one, NAMES)
        for key, one in arc_registry().items()
        if key.removesuffix("_return") not in OF_END
    }
