"""The size of a drawing on its page."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Annotated, Any, TypedDict

from kurbel.commands.options import Option
from kurbel.errors import ProblemError
from kurbel.reading.given import Exact, as_length, as_number

if TYPE_CHECKING:
    from kurbel.plot.style import Size

# In mm.
LEAST, MOST = 20, 1000


class Sized(TypedDict, total=False):
    """How large a drawing is."""

    width: Annotated[
        Exact | None,
        Option(
            "Width of the drawing in mm, or with a unit: 85, 3.5in; default 120 mm, or less where it needs"
            " less. Type and lines keep their size.",
            "LENGTH", unit="mm", last=True,
        ),
    ]  # fmt: skip
    height: Annotated[
        Exact | None,
        Option("Height likewise; default: what it needs.", "LENGTH", unit="mm", last=True),
    ]


def page_size(given: Mapping[str, Any]) -> "Size":
    """Return the size that options give, or leave to the drawing. Raises ProblemError beyond the limits."""
    from kurbel.plot.style import USUAL, Size

    width, height = (_millimetres(given[name], name) for name in ("width", "height"))
    if width is None and height is None:
        return USUAL
    return Size(width or USUAL.width, height, width is not None)


def _millimetres(value: Exact | None, name: str) -> float | None:
    from kurbel.reading.units import is_measure

    if value is None:
        return None
    measured = isinstance(value, str) and is_measure(value)
    found = 1000 * as_length(value, name) if measured else as_number(value, name)
    if not LEAST <= found <= MOST:
        raise ProblemError(
            f"the {name} of the drawing is {float(found):.6g} mm; it must be from {LEAST} to {MOST} mm"
        )
    return float(found)
