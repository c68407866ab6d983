"""Ties are planted where terms cancel: expected digits are those of the fraction that is left."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import pytest
from cli import printed

from kurbel import KurbelError
from kurbel.drive.crank import Crank
from kurbel.exact.kind import Kind, settled
from kurbel.exact.terms import terms, tie_bits, vanishes
from kurbel.kernel.steam import logarithm
from kurbel.linkage.arc import ArcCrank
from kurbel.linkage.arc_quantities import arc_registry
from kurbel.motion.evaluation import Needs, is_known, kernel_of, value
from kurbel.motion.motion_quantities import registry
from kurbel.page.quantity import Of
from kurbel.reading.units import Speed

F = Fraction


def root(kind: Kind, number: int) -> Any:
    return kind.of(F(number)) ** kind.exponent(F(1, 2))


def log(kind: Kind, value: Any) -> Any:
    return logarithm(kind.of(value) if isinstance(value, Fraction) else value)


# What is 0, each by another theorem.
NOTHING: dict[str, Callable[[Kind], Any]] = {
    "roots": lambda kind: root(kind, 2) * root(kind, 8) - kind.of(F(4)),
    "the pentagon": lambda kind: kind.circle(F(36)).cosine - kind.circle(F(72)).cosine - kind.of(F(1, 2)),
    "powers of pi": lambda kind: (kind.pi * kind.pi + kind.pi) / kind.pi - kind.pi - kind.of(F(1)),
    "the root of pi": lambda kind: (4 * kind.pi) ** kind.exponent(F(1, 2))
    - 2 * kind.pi ** kind.exponent(F(1, 2)),
    "primes": lambda kind: 2 * log(kind, F(2)) + log(kind, F(3)) - log(kind, F(12)),
    "primes with irrational factors": lambda kind: root(kind, 2) * log(kind, F(2))
    - log(kind, F(4)) / root(kind, 2),
    "logarithms over pi": lambda kind: log(kind, F(9)) / kind.pi - 2 * log(kind, F(3)) / kind.pi,
    "irrational logarithms": lambda kind: log(kind, 2 - root(kind, 2))
    + log(kind, 2 + root(kind, 2))
    - log(kind, F(2)),
    "long logarithms": lambda kind: log(kind, F(10**50 + 1, 10**50))
    + log(kind, F(10**50, 10**50 + 1)),
}  # fmt: skip


@pytest.mark.parametrize("nothing", NOTHING.values(), ids=NOTHING)
@pytest.mark.parametrize(("exact", "away", "even"), [("1/4", 3, 2), ("-1/4", -3, -2), ("7/20", 4, 4)])
def test_what_terms_leave_is_a_tie_and_beside_it_is_none(
    nothing: Callable[[Kind], Any], exact: str, away: int, even: int
) -> None:
    assert vanishes(nothing)
    assert settled(lambda kind: nothing(kind) + kind.of(F(exact)), 1) == away
    assert settled(lambda kind: nothing(kind) + kind.of(F(exact)), 1, "half-even") == even
    # A hair beside, by a rational number, a multiple of π and a logarithm.
    for more in (lambda kind: kind.of(F(1)), lambda kind: kind.pi, lambda kind: log(kind, F(5))):
        for sign in (1, -1):

            def beside(kind: Kind, more: Any = more, sign: int = sign) -> Any:
                return nothing(kind) + kind.of(F(exact)) + kind.of(F(sign, 10**60)) * more(kind)

            assert terms(beside) != {} and tie_bits(beside, abs(F(exact))) > 0
            beyond = (F(exact) * 10 + F(sign, 2) * F(1, 10**9)).__round__()
            assert settled(beside, 1) == settled(beside, 1, "half-even") == beyond


@pytest.mark.parametrize(
    "value",
    [
        # 30° and a half, √2 as a ball alone, ln 2/ln 2, and half of 1 by a quotient of two terms.
        lambda kind: kind.arc(kind.of(F(1, 2))) + kind.of(F(1, 2)),
        lambda kind: log(kind, F(2)) / log(kind, F(2)) + kind.of(F(1, 2)),
        lambda kind: (1 + kind.pi) / (2 + 2 * kind.pi),
    ],
)
def test_what_nobody_settles_is_refused(value: Callable[[Kind], Any]) -> None:
    assert tie_bits(value, F(61, 2)) == float("inf")
    with pytest.raises(KurbelError, match="a digit is not settled"):
        settled(value, 0)


# P R = (1 - b) d² p R/2 without expansion, for the π of the piston's area is that of the turn: 375.01125 N m,
# and N = P R ω, of 10 rad/s 3750.1125 W.
WHEEL = (
    "flywheel --eps 1 --back 0.25 --ratio 1:5 --stroke 500mm --bore 200mm --pressure 100003Pa --delta 1/100"
    " --speed 10rad/s -f csv"
)


@pytest.mark.parametrize(
    ("column", "digits", "away", "even"),
    [("mean_torque", 4, "375.0113", "375.0112"), ("power", 3, "3750.113", "3750.112")],
)
def test_a_torque_is_rational_where_the_pi_of_the_area_is_that_of_the_turn(
    column: str, digits: int, away: str, even: str
) -> None:
    for rounding, expected in (("half-away", away), ("half-even", even)):
        words = [*WHEEL.split(), "--columns", column, "--digits", str(digits), "--rounding", rounding]
        assert printed(*words).records()[0][column] == expected


CRANKS = (
    Crank(F(1, 5)),
    Crank(F(1, 5), F(1, 3)),
    Crank(F(1, 4), radius=F(1, 4), speed=Speed(F(2), True)),
    Crank(F(1, 4), F(1, 3), radius=F(1, 4), speed=Speed(F(7), False), acceleration=F(3)),
)


@pytest.mark.parametrize("crank", CRANKS)
def test_every_quantity_of_the_motion_has_terms_or_is_undecided(crank: Crank) -> None:
    run = 0
    for one in registry().values():
        try:
            kernel_of(one, "exact", crank)
        except KurbelError:
            continue
        if is_known(one, crank):

            def at(kind: Kind, one: Any = one) -> Any:
                return value(one, "exact", crank, kind.circle(F(60)), kind, degrees=kind.of(F(60)))

            run += 1
            assert terms(at) is not None or one.in_degrees or Needs.TIME in one.needs, one.key
    assert run > 5


def test_every_quantity_of_the_arc_crank_has_terms_but_its_arcs() -> None:
    drive, undecided = ArcCrank(Crank(F(1, 5)), F(6), F(5)), set()
    for one in arc_registry().values():
        if not one.needs:

            def at(kind: Kind, one: Any = one) -> Any:
                return value(one, "exact", drive, kind.circle(F(60)), kind)

            if terms(at) is None:
                undecided.add(one.key)
                assert one.in_degrees or one.of is Of.STROKE, one.key
    assert "path" in undecided
