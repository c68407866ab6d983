"""The library: its examples run, and it gives what the command line gives."""

from __future__ import annotations

import doctest
from collections.abc import Callable
from decimal import Decimal

import numpy as np
import pytest

import kurbel
import kurbel.commands.numbers


@pytest.mark.parametrize(("module", "examples"), [(kurbel, 4), (kurbel.commands.numbers, 6)])
def test_the_examples_of_the_docstrings_are_true(module: object, examples: int) -> None:
    result = doctest.testmod(module)  # type: ignore[arg-type]
    assert (result.failed, result.attempted) == (0, examples)


def test_a_float_ratio_is_read_by_its_shortest_decimal() -> None:
    assert kurbel.certified("x", 0.2, 90, digits=40) == kurbel.certified("x", "1:5", "90", digits=40)


def test_digits_beyond_the_default_precision_of_decimals_are_kept() -> None:
    assert kurbel.certified("x", "1:5", 90, digits=50).as_tuple().exponent == -50
    assert kurbel.certified("c", "1:5", 90, digits=50) == Decimal(1)


def test_arrays_keep_their_shape() -> None:
    angles = np.linspace(0.0, 360.0, 12).reshape(3, 4)
    columns = kurbel.compute(angles, "1:4", ["x", "x_return", "psi"], offset="0.1")
    assert {key: array.shape for key, array in columns.items()} == dict.fromkeys(columns, (3, 4))


def test_one_angle_is_an_array_without_dimensions() -> None:
    assert kurbel.compute(90, "1:5")["c"].shape == ()
    assert float(kurbel.compute(90.0, "1:5")["c"]) == 1.0


def test_arrays_agree_with_certified_digits() -> None:
    angles = [0.0, 12.5, 90.0, 179.0, 251.25]
    for key, array in kurbel.compute(angles, "2:9", ["x", "x_return", "c", "p", "psi"]).items():
        exact = [float(kurbel.certified(key, "2:9", angle, digits=30)) for angle in angles]
        np.testing.assert_allclose(array, exact, rtol=1e-14, atol=1e-15)


@pytest.mark.parametrize(
    ("quantity", "sentence"),
    [
        ("y", 'there is no quantity "y"; choose from x, x_return'),
        ("x_retrun", 'there is no quantity "x_retrun" (did you mean x_return?); choose from x, '),
    ],
)
def test_an_unknown_quantity_is_answered_with_the_list(quantity: str, sentence: str) -> None:
    with pytest.raises(kurbel.KurbelError) as raised:
        kurbel.certified(quantity, "1:5", 90)
    assert str(raised.value).startswith(sentence)


def test_a_page_of_the_library_is_the_page_of_the_command_line(capfd: pytest.CaptureFixture[str]) -> None:
    import sys
    from unittest.mock import patch

    from kurbel.cli import main

    with (
        patch.object(sys, "argv", ["kurbel", "table", "--ratio", "1:4,5", "--digits", "6"]),
        pytest.raises(SystemExit),
    ):
        main()
    assert kurbel.typeset(kurbel.table("1:4,5", digits=6)) == capfd.readouterr().out


def test_text_is_read_as_on_the_command_line() -> None:
    page = kurbel.table("1:5", angle="0..20:10", columns="phi, x", lang="en")
    assert [len(panel.groups[0].rows) for panel in page.panels] == [3]
    assert kurbel.compute("0;90", "1:5", "c")["c"].tolist() == [0.0, 1.0]


@pytest.mark.parametrize("digits", [-1, 51, 5000, 2.5])
def test_decimals_that_cannot_be_printed_are_refused(digits: int) -> None:
    for call in (
        lambda: kurbel.certified("x", "1:5", 90, digits=digits),
        lambda: kurbel.table("1:5", digits=digits),
    ):
        with pytest.raises(
            kurbel.KurbelError, match=f"^digits is {digits}; it must be a whole number from 0 to 50"
        ):
            call()


def test_a_misspelt_rounding_is_not_ignored() -> None:
    with pytest.raises(kurbel.KurbelError, match="did you mean half-even"):
        kurbel.certified("x", "1:5", 60, digits=2, rounding="half_even")
    with pytest.raises(kurbel.KurbelError, match="there is no rounding"):
        kurbel.table("1:5", rounding="bogus")


@pytest.mark.parametrize(
    "call",
    [
        lambda: kurbel.certified(None, "1:5", 60),  # type: ignore[arg-type]
        lambda: kurbel.certified("x", "1:5", 60, method=None),  # type: ignore[arg-type]
        lambda: kurbel.table("1:5", layout=5),  # type: ignore[arg-type]
        lambda: kurbel.table("1:5", columns=5),  # type: ignore[arg-type]
        lambda: kurbel.table("1:5", angle=[0], label="a b}"),
        lambda: kurbel.compute([0], "1:5", [None]),  # type: ignore[list-item]
        lambda: kurbel.compute(10**400, "1:5"),
        lambda: kurbel.compute([1 + 2j], "1:5"),
        lambda: kurbel.typeset(None),  # type: ignore[arg-type]
    ],
)
def test_wrong_kinds_of_arguments_are_answered_with_a_sentence(call: Callable[[], object]) -> None:
    with pytest.raises(kurbel.KurbelError):
        call()


def test_one_angle_and_one_ratio_need_no_list() -> None:
    page = kurbel.table(0.2, angle=90, columns=("phi", "x"))
    assert kurbel.typeset(page, "csv") == "phi,x\n90,1.1010\n"


@pytest.mark.parametrize("angles", [[float("nan")], [float("inf")], [1e300], "abc", [[1], [2, 3]], None])
def test_angles_that_are_none_are_refused(angles: object) -> None:
    with pytest.raises(kurbel.KurbelError):
        kurbel.compute(angles, "1:5")  # type: ignore[arg-type]
