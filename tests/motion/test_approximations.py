"""Rötscher's steps to GF, and the greatest errors of the series, against computations in mpmath."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path
from random import Random
from typing import Any

import flint
import pytest
from cli import kurbel, printed
from mpmath import mp
from textbook import Drive, evaluate, real, rounded

from kurbel.drive.crank import Crank
from kurbel.exact.kind import balls
from kurbel.kernel.series import chord
from kurbel.motion.series.chord import steps_to
from kurbel.motion.series.errors import Greatest

Real = Any


def errors_csv(*options: str) -> list[dict[str, str]]:
    return printed("table", "--layout=series-errors", *options, "-f", "csv").records()


def steps_csv(*options: str) -> list[dict[str, str]]:
    return printed("table", "--layout=roetscher-gf", *options, "-f", "csv").records()


# Greatest errors ---------------------------------------------------------------------------------


def greatest(key: str, drive: Drive, order: int) -> tuple[Real, Real]:
    """Search the whole turn, every third degree and then ever closer, for where a series errs most."""
    method = "series" if order == 1 else f"series-{order}"

    def error(degrees: Fraction) -> Real:
        return abs(evaluate(key, "exact", drive, degrees, 256) - evaluate(key, method, drive, degrees, 256))

    best, width = max((Fraction(angle) for angle in range(0, 360, 3)), key=error), Fraction(3)
    while width > Fraction(1, 10**5):
        best = max((best + width * part / 8 for part in range(-8, 9)), key=error)
        width /= 4
    return error(best), best


@pytest.mark.parametrize(
    ("ratio", "order"), [("0.237", 1), ("0.31", 3), ("0.2", 5), ("0.43", 7), ("0.77", 9)]
)
def test_greatest_errors_are_those_of_a_search_over_the_turn(ratio: str, order: int) -> None:
    (record,) = errors_csv(f"--ratio={ratio}", f"--order={order}", "--lang=en")
    for key in ("x", "c", "p"):
        value, place = greatest(key, Drive(Fraction(ratio)), order)
        shown, angle = record[f"error_{key}"], Fraction(record[f"error_{key}_phi"])
        assert int(shown.replace(".", "")) == rounded(value, len(shown.partition(".")[2]), 256), key
        # The same is found at four places of the turn.
        mirrored = min(place % 180, 180 - place % 180)
        assert abs(mirrored - angle) < Fraction(1, 1000), key


def test_first_order_errs_by_an_eighth_and_a_half_of_the_third_power() -> None:
    # The first terms that are left out: λ³/8 of x and -λ³/2 of p at 90°, √27/32 λ³ of c at 60°.
    found, ratio = Greatest(Fraction(1, 10**6), 1), 1e-6
    for key, share in (("x", 1 / 8), ("c", 27**0.5 / 32), ("p", 1 / 2)):
        assert abs(found.rough(key) / (share * ratio**3) - 1) < 1e-9
    with flint.ctx.workprec(256):
        assert abs(float(180 * found.half_turns()) - 60) < 1e-6


def test_errors_have_the_digits_and_the_units_that_are_asked_for() -> None:
    exact = {"x": Fraction(1, 3) - Fraction(3, 10), "p": Fraction(3, 4) - Fraction(3, 5)}
    # At λ = 3:5 the root at 90° is 4/5.
    (record,) = errors_csv("--ratio=3:5", "--order=1", "--digits=30")
    for key, value in exact.items():
        assert abs(Fraction(record[f"error_{key}"]) - value) <= Fraction(1, 2 * 10**30)
    (record,) = errors_csv("--ratio=3:5", "--order=1", "--stroke=1m", "--digits=3", "--columns=error_x_mm")
    assert record == {"error_x_mm": "16.667"}
    ties = [errors_csv("--ratio=3:5", "--order=1", "--digits=1", "--columns=error_p", f"--rounding={one}")
            for one in ("half-away", "half-even")]  # fmt: skip
    assert ties == [[{"error_p": "0.2"}], [{"error_p": "0.2"}]]
    assert errors_csv("--ratio=1:∞", "--columns=error_x,error_c_phi") == [
        {"order": str(order), "error_x": "0", "error_c_phi": ""} for order in (1, 3, 5, 7, 9)
    ]


# Rötscher's steps --------------------------------------------------------------------------------


def successive(ratio: Real, sine: Real, steps: int) -> Real:
    """CF²/(2 L - GF) in units of R, with CF = R sin φ and L = R/λ."""
    found = mp.mpf(0)
    for _ in range(steps):
        found = sine**2 / (2 / ratio - found)
    return found


def test_steps_and_their_number_are_those_of_the_equation_itself() -> None:
    random = Random(1047)
    for _ in range(6):
        ratio, angle = Fraction(random.randint(100, 960), 1000), Fraction(random.randint(1, 17999), 100)
        digits = random.randint(1, 20)
        names = [f"gf_{step}" for step in range(1, 10)]
        (record,) = steps_csv(
            f"--ratio={float(ratio)}", f"--angle={float(angle)}", f"--digits={digits}",
            "--columns=" + ",".join((*names, "gf", "gf_steps")),
        )  # fmt: skip
        with mp.workprec(400):
            lam, sine = real(ratio), mp.sin(real(angle) * mp.pi / 180)
            exact = (1 - mp.sqrt(1 - (lam * sine) ** 2)) / lam
            wanted = rounded(exact, digits)
            count = next(k for k in range(5000) if rounded(successive(lam, sine, k), digits) == wanted)
            for step, name in enumerate(names, 1):
                expected = rounded(successive(lam, sine, step), digits)
                assert int(record[name].replace(".", "")) == expected, name
            assert int(record["gf"].replace(".", "")) == wanted
            assert int(record["gf_steps"]) == count
            left, share = exact, exact / (2 / lam - exact)
            for step in range(1, 12):
                assert 0 < exact - successive(lam, sine, step) < share**step * exact
                assert exact - successive(lam, sine, step) < share * left
                left = exact - successive(lam, sine, step)


def test_the_closed_form_is_that_of_the_steps() -> None:
    kind = balls()
    circle, ratio = kind.circle(Fraction(371, 7)), kind.of(Fraction(3, 7))
    for steps in range(6):
        assert chord.closed(circle, ratio, steps).overlaps(chord.after(circle, ratio, steps))


def test_steps_never_reach_a_value_half_way_that_is_rounded_up() -> None:
    # At λ = 4:5 and 90° GF is exactly ½ R, and all steps are below it: 2/5, 10/21, …
    crank, quarter = Crank(Fraction(4, 5)), Fraction(90)
    assert steps_to(crank, quarter, 0, "half-away") is None
    assert steps_to(crank, quarter, 0, "half-even") == 0
    assert steps_to(crank, quarter, 1, "half-away") == 2
    page = printed(
        "table", "--layout=roetscher-gf", "--ratio=4:5", "--angle=90", "--digits=0", "--lang=en"
    ).out
    assert "half-way between" in page


def test_orders_are_listed_or_repeated_and_each_stands_once() -> None:
    errors = ("table", "--layout=series-errors")
    for words, listed in (
        (("--order=3", "--order=9", "--order=3"), "3;9"),
        (("--order=1", "--order=1"), "1"),
    ):
        assert printed(*errors, *words).out == printed(*errors, f"--order={listed}").out
    page = ("table", "--method=series", "--angle=30", "--order=3")
    assert printed(*page, "--order=3").out == printed(*page).out


# What is refused ---------------------------------------------------------------------------------


def test_other_commands_say_that_their_series_are_of_first_order() -> None:
    for words in ("inertia --centre=0.6 --gyration=0.3", "forces --method=series", "delta --eps=4"):
        result = kurbel(*words.split(), "--order=3")
        assert result.code == 2
        assert "elsewhere --method series is of first order; see kurbel" in result.err


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ("--layout=series-errors --angle=30", "is of the whole turn; leave --angle out"),
        ("--layout=series-errors --method=series", "takes no method"),
        ("--layout=series-errors --order=10", "write a whole number from 1 to 9"),
        ("--layout=series-errors --order=0", "write a whole number from 1 to 9"),
        ("--order=3", "add --method series, or leave --order out"),
        ("--method=series --order=3 --order=5", "a page is of one order, and 2 were given"),
        ("--layout=series-errors --offset=0.2", "is of the straight crank"),
        ("--layout=roetscher-gf --offset=0.2", "is of the straight crank"),
        ("--layout=roetscher-gf --order=3", "has steps and no series"),
        ("--layout=roetscher-gf --acceleration=5rad/s²", "turns evenly"),
        ("--layout=roetscher-gf --mechanism=arc --rocker=6", "and the arc crank was described"),
    ],
)
def test_what_says_nothing_of_a_page_is_refused(options: str, said: str) -> None:
    result = kurbel("table", *options.split())
    assert (result.code, result.out) == (2, "") or result.code == 1
    assert said in result.err
    assert result.err.count("\n") == 1


def test_steps_until_decimals_stand_can_be_swept(tmp_path: Path) -> None:
    words = ("sweep", "table", "--layout=roetscher-gf", "--ratio=1:4;1:5", "--angle=0;90", "-o")
    counted = []
    for digits in ((), ("--digits=6",), ("--digits=2",)):
        assert kurbel(*words, str(tmp_path / "gf.csv"), "--restart", *digits).code == 0
        rows = (tmp_path / "gf.csv").read_text(encoding="utf-8").splitlines()[1:]
        counted.append([float(row.split(",")[-2]) for row in rows])
    # At 1:5 and 90° four steps give six places, as on the page; more decimals take more steps.
    assert counted[1] == [0, 4, 0, 4]
    assert all(more >= some >= few for more, some, few in zip(*counted, strict=True))
    assert counted[0] != counted[1] != counted[2]
