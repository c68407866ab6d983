"""Options that functions share: where they stand, and their defaults; what shells are offered."""

from typing import Annotated, TypedDict, Unpack

import pytest

from kurbel.commands.options import Choice, Count, Option, parameters_of, signature_of
from kurbel.errors import KurbelError

Text = Annotated[str | None, Option("A text.")]


class Shared(TypedDict, total=False):
    bore: Text
    from_: Text
    rounding: Annotated[str, Option("What becomes of a tie.", default="half-away", last=True)]


def page(ratio: Text = None, *, eps: Text, columns: Text = "x", **given: Unpack[Shared]) -> None:
    """Print a page."""


@pytest.mark.parametrize(
    ("order", "names"),
    [
        ("", ["ratio", "bore", "from_", "eps", "columns", "rounding"]),
        ("columns bore", ["ratio", "columns", "bore", "from_", "eps", "rounding"]),
        ("rounding eps", ["ratio", "eps", "bore", "from_", "columns", "rounding"]),
    ],
)
def test_shared_options_stand_before_the_functions_own_unless_an_order_says_where(
    order: str, names: list[str]
) -> None:
    assert [*signature_of(page, order).parameters] == names


def test_defaults_are_those_of_the_signature_and_of_shared_options() -> None:
    found = parameters_of(signature_of(page))
    assert {key: one.default for key, one in found.items()} == {
        "ratio": None, "bore": None, "from_": None, "eps": None, "columns": "x", "rounding": "half-away",
    }  # fmt: skip
    assert [key for key, one in found.items() if one.required] == ["eps"]
    assert (found["from_"].name, found["from_"].flag) == ("from", "--from")


def test_names_may_stand_elsewhere_and_are_offered_by_their_beginning() -> None:
    method = Choice("method", "kurbel.motion.evaluation:METHODS")
    assert [*method.offered("", {})] == ["exact", "series", "infinite"]
    assert [*method.offered("s", {})] == ["series"]
    assert method.read("series", {}) == "series"
    with pytest.raises(KurbelError, match=r"serie.*did you mean series"):
        method.read("serie", {})
    assert [*Count("orders", 1, 3).offered("", {})] == []
