"""The pages of the piston's motion and of the forces of the drive, and those of the moving rod."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cache

from kurbel.exact.numerals import Label, Number
from kurbel.motion import captions
from kurbel.motion.evaluation import NEEDS
from kurbel.motion.quantities import registry
from kurbel.motion.question import Request
from kurbel.motion.rows import motion_records
from kurbel.page.axes import AngleAxis, ColumnAxis, Place, RatioAxis
from kurbel.page.quantity import Column, Quantity
from kurbel.page.subject import Subject

AXES = {"ratio": RatioAxis, "angle": AngleAxis, "column": ColumnAxis}


def _number(question: Request, column: Column, place: Place, times: int) -> Number:
    scaled = question.values[place["ratio"]][place["column"]][place["angle"]]
    return Number(int(scaled) * times, column.places)


MOTION = Subject(
    key="motion",
    layout="kinematics",
    command="table",
    axes=AXES,
    axis_keys=("ratio", "phi"),
    quantities=registry,
    number=_number,
    caption=captions.caption,
    notes=captions.notes,
    rows=motion_records,
    options=NEEDS,
)


@cache
def _with_rods() -> Mapping[str, Quantity]:
    """The quantities of the crank drive, and those of the moving rod."""
    from kurbel.motion.inertia import inertia_registry

    return {**registry(), **inertia_registry()}


def _of_rods() -> Iterator[tuple[str, Quantity]]:
    from kurbel.motion.inertia import inertia_registry

    return (("inertia", one) for one in inertia_registry().values())


def _inertia_notes(question: Request) -> Iterator[Label]:
    yield from captions.notes(question)
    yield from captions.inertia_notes(question)


def _error_notes(question: Request) -> Iterator[Label]:
    from kurbel.motion.inertia_page import error_notes

    return error_notes(question)


INERTIA = Subject(
    key="inertia",
    layout="inertia",
    command="inertia",
    sample="inertia --centre 0.65 --gyration 0.35",
    axes=AXES,
    axis_keys=("ratio", "phi"),
    quantities=_with_rods,
    number=_number,
    caption=captions.caption,
    notes=_inertia_notes,
    page_notes=_error_notes,
    rows=motion_records,
    listed=_of_rods,
    options=NEEDS,
)
