"""Arrays of what any page over the crank angle shows, by the options of that page."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from kurbel.commands.engine import turning
from kurbel.commands.forces import forces
from kurbel.commands.inertia import inertia
from kurbel.commands.motion import table
from kurbel.engine.arrays import at_angles
from kurbel.engine.diagram.diagram_page import TorquesRequest
from kurbel.engine.request import EngineRequest
from kurbel.errors import KurbelError, ProblemError
from kurbel.exact.kind import floats
from kurbel.motion.motion_page import AngleQuestion
from kurbel.page.quantity import Quantity
from kurbel.page.subject import Question
from kurbel.reading.names import unknown

if TYPE_CHECKING:
    from kurbel.commands.subject import Function

Floats = NDArray[np.float64]
# Of pages that have a quantity the first is asked.
PAGES: tuple[Function, ...] = (table, forces, inertia, turning)


def arrays(columns: Sequence[str], degrees: Floats, given: Mapping[str, object]) -> list[Floats]:
    """Return each quantity at these angles, by the options of a page that shows it. Raises KurbelError."""
    asked = {key: _asked(key, given) for key in columns}
    together: dict[Function, list[str]] = {}
    for key, (page, question) in asked.items():
        if isinstance(question, AngleQuestion):
            together.setdefault(page, []).append(key)
    found: dict[str, Floats] = {}
    for page, keys in together.items():
        # Columns of one page share the circle of each angle.
        question = asked[keys[0]][1] if len(keys) == 1 else page.question(**given, columns=keys)
        assert isinstance(question, AngleQuestion)
        found |= zip(keys, map(_single, keys, question.curves(degrees)), strict=True)
    for key, (_, question) in asked.items():
        if key not in found:
            found[key] = _single(key, _curves(question, key, degrees))
    return [np.broadcast_to(found[key], degrees.shape) for key in columns]


def _asked(key: str, given: Mapping[str, object]) -> tuple[Function, Question]:
    """Return the first page that takes the options and has the quantity, and its question."""
    takers = [page for page in PAGES if set(given) <= set(page.command.signature.parameters)]
    if not takers:
        known = {name for page in PAGES for name in page.command.signature.parameters}
        if wrong := sorted({*given} - known):
            raise unknown("compute", wrong[0], sorted(known), "it has those of kurbel.forces and its like")
        raise ProblemError(
            f"no page takes {', '.join(sorted(given))} together; leave what is not of this drive out"
        )
    refused: list[KurbelError] = []
    for page in takers:
        try:
            question = page.question(**given, columns=key)
            # Whether the page has the quantity is known once its columns are.
            if question.page_columns:
                return page, question
        except KurbelError as error:
            refused.append(error)
    # The last one knows most of what was given.
    raise refused[-1 if len(takers) < len(PAGES) else 0]


def _curves(question: Question, key: str, degrees: Floats) -> list[Floats]:
    """Return the quantity of each drive that was asked for."""
    (column,) = question.page_columns
    if isinstance(question, EngineRequest):
        return at_angles(question, column.quantity, (question.methods or ("exact",))[0], degrees)
    if isinstance(question, TorquesRequest):
        return [_of_torques(question, column.quantity, degrees)]
    raise ProblemError(f"{key} has no array over the crank angle on this page; print it")


def _single(key: str, found: list[Floats]) -> Floats:
    if len(found) != 1:
        raise ProblemError(f"{key} was asked for of {len(found)} drives; compute takes one")
    return found[0]


def _of_torques(question: TorquesRequest, quantity: Quantity, degrees: Floats) -> Floats:
    kernel = quantity.formulas["exact"].kernel
    places, where = np.unique(degrees, return_inverse=True)
    values = [float(kernel(question, Fraction(place), floats())) for place in places.tolist()]
    return np.array(values)[where].reshape(degrees.shape)
