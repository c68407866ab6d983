"""What is asked for with --unknown, as options describe it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from kurbel.commands import parameters as option
from kurbel.commands.old_motion import sheet_of
from kurbel.commands.options import is_given
from kurbel.commands.unknown.ratio import OfRatio
from kurbel.commands.unknown.sized import Sized
from kurbel.errors import ProblemError
from kurbel.page.layouts import layout_of
from kurbel.page.subject import Question
from kurbel.reading.given import as_names

ABOUT = ("unknown",)


def unknown_of(
    unknown: str, angle: Any, texts: Sequence[str], columns: option.Names, layout: str | None,
    given: Mapping[str, Any],
) -> Question:  # fmt: skip
    """Return what is asked for: all values of the unknown with which the condition holds at the angle."""
    from kurbel.solve.unknown import nowhere
    from kurbel.solve.unknown_page import UnknownRequest

    page = layout_of(layout or "solve-unknown", ABOUT, given["layouts"])
    if is_given(given.get(unknown)):
        raise ProblemError(
            f"--{unknown.replace('_', '-')} is given and asked for, as --unknown; leave one of the two out"
        )
    if len(texts) != 1:
        raise ProblemError(f"--unknown takes one condition, and {len(texts)} were given; write one --where")
    asked = (OfRatio if unknown == "ratio" else Sized)(unknown, angle, texts[0], given)
    question = UnknownRequest(
        layout=page,
        unknown=unknown,
        asked=asked,
        columns=as_names(columns, "speed"),
        **sheet_of(given),
    )
    if not question.asked.found:
        raise nowhere(unknown, str(asked.condition))
    return question
