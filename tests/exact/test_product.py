"""Products of powers of rational numbers, π and enclosed numbers."""

from __future__ import annotations

from fractions import Fraction

import pytest
from mpmath import mp, mpf

from kurbel.exact.kind import Kind
from kurbel.exact.numerals import Number, number_text
from kurbel.exact.real import Product
from kurbel.kernel.circle import Numeric

F = Fraction


def digits(product: Product, decimals: int, true: object) -> None:
    """The number to so many decimals is that of a value in mpmath."""
    with mp.workdps(60):
        shown = number_text(product.number(decimals, "half-away"))
        assert abs(mpf(shown) - true) <= mpf(10) ** -decimals / 2


def test_powers_of_rational_numbers_and_of_pi_have_the_digits_of_mpmath() -> None:
    with mp.workdps(60):
        cube = (Product.of(F(7, 3), 2) / Product.of(5)) ** F(1, 3)
        digits(cube, 30, (mpf(7) / 3 * mp.pi**2 / 5) ** (mpf(1) / 3))
        root = Product.of(F(5, 2)) ** F(1, 2) * Product.of(7) ** F(1, 3)
        digits(root, 30, mp.sqrt(mpf(5) / 2) * mp.cbrt(7))
        digits(Product.of(3, 1).plus(root), 30, 3 * mp.pi + mp.sqrt(mpf(5) / 2) * mp.cbrt(7))


def test_what_is_rational_is_known_to_be_so() -> None:
    root = Product.of(F(8, 27)) ** F(2, 3) * Product.of(2, -2) ** F(1, 2) * Product.of(2, 2) ** F(1, 2)
    assert root.rational == F(8, 9)
    assert (Product.of(2) ** F(1, 2)).rational is None
    assert Product.of(2, 1).rational is None
    # √1.51880976 is 1.2324, and √1.51880977 no such number.
    assert Product.reduced(lambda kind: kind.of(F(151880976, 10**8)) ** 0.5).rational == F(12324, 10**4)
    assert Product.reduced(lambda kind: kind.of(F(151880977, 10**8)) ** 0.5).rational is None
    # 3π - π is a multiple of π, and π² over it one of π.
    twice = Product.of(3, 1).plus(Product.of(1, 1), -1)
    assert (Product.of(1, 2) / twice).equals(Product.of(F(1, 2), 1))
    assert Product.of(3).exceeds(Product.of(F(9, 10), 1))
    assert not Product.of(F(9, 10), 1).exceeds(Product.of(3))


@pytest.mark.parametrize(("rounding", "last"), [("half-away", 13), ("half-even", 12)])
def test_ties_are_known_and_rounded_as_asked(rounding: str, last: int) -> None:
    # √1.5625 = 1.25, also of a number that is enclosed, and √1.5625 π/π.
    exact = Product.of(F(25, 16)) ** F(1, 2)
    enclosed = Product.about(lambda kind: kind.of(F(25, 16))) ** F(1, 2)
    for one in (exact, enclosed, exact * Product.of(1, 1) / Product.of(1, 1)):
        assert one.number(1, rounding) == Number(last, 1)


def test_without_decimals_a_number_has_five_figures_and_a_short_one_its_own() -> None:
    assert number_text(Product.of(F(5, 2), 2).number(None, "half-away")) == "24.674"
    assert number_text(Product.of(20000).number(None, "half-away")) == "20000"
    assert number_text(Product.of(F(1, 3)).number(None, "half-away")) == "0.33333"
    # 9.999966... is 10.000 to five figures, 9.999933... is not.
    assert number_text(Product.of(F(299999, 30000)).number(None, "half-away")) == "10.000"
    assert number_text(Product.of(F(149999, 15000)).number(None, "half-away")) == "9.9999"


def test_an_algebraic_number_is_rational_where_that_is_proved() -> None:
    def of(kind: Kind) -> Numeric:
        # √2 √8 + 1/3 = 13/3, by no rule of products.
        half = kind.exponent(F(1, 2))
        return kind.of(F(2)) ** half * kind.of(F(8)) ** half + kind.of(F(1, 3))

    assert Product.reduced(of).rational == F(13, 3)
    near = Product.reduced(lambda kind: kind.of(F(13, 3) + F(1, 10**40)))
    assert near.rational is None
    with mp.workdps(60):
        digits(near, 45, mpf(13) / 3 + mpf(10) ** -40)
