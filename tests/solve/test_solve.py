"""Where conditions hold: every place of a scan, each once, and with the value that kurbel.verify encloses."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import partial
from typing import Any

import numpy as np
import pytest
from cli import kurbel, printed, records
from courses import OUT, RETURN, Course, course, ends, slide
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st
from machines import machine

from kurbel import verify

STROKES = (OUT, RETURN)
MOTION = ("x", "s", "c", "p")
QUANTITIES = (
    *MOTION, "psi", "rod_velocity", "rod_acceleration", "rod_force", "guide_force", "tangential_force",
    "radial_force",
)  # fmt: skip
RATIOS = st.fractions(Fraction(1, 20), Fraction(9, 10), max_denominator=60)
SHARES = st.fractions(Fraction(-9, 10), Fraction(9, 10), max_denominator=20)
DIGITS = 25
FIFTH = ("--ratio=1:5",)
Row = dict[str, str]


def found(*words: str, digits: int = DIGITS) -> list[Row]:
    """Return the places, or none where the condition is nowhere fulfilled."""
    asked = ("solve", *words, "--columns=phi,phi_turn", f"--digits={digits}", "-f", "csv")
    result = kurbel(*asked)
    if result.code == 1:
        assert "is reached nowhere" in result.err
        return []
    assert result.code == 0, result.err
    return result.records()


def angles(rows: Sequence[Row], stroke: str) -> list[str]:
    """Return the angles of a stroke, which rise and none of which is there twice."""
    own = [row for row in rows if row["stroke"] == stroke]
    for row in own:
        turn, phi = Fraction(row["phi_turn"]), Fraction(row["phi"])
        assert 0 <= turn <= 360
        assert (turn - phi - (180 if stroke == RETURN else 0)) % 360 == 0
    found = [row["phi"] for row in own]
    assert found == sorted(set(found), key=Fraction)
    return found


def radians(angle: str, stroke: str) -> float:
    """Return the place in the turn of an angle of a stroke."""
    return float(np.radians(float(angle) + (180 if stroke == RETURN else 0)))


def check_none_missed(scanned: Course, span: tuple[float, float], value: float, roots: list[float]) -> None:
    """Compare with a scan: where the sign changes an odd number of roots lies, elsewhere an even one."""
    begin, end = span
    grid = np.linspace(begin + 1e-9, end - 1e-9, 3001)
    signs = np.sign(scanned(grid) - value)
    inside, _ = np.histogram(roots, grid)
    changed = signs[1:] != signs[:-1]
    assert list(np.flatnonzero(inside % 2 != changed)) == []


@settings(deadline=None, max_examples=30)
@given(
    RATIOS,
    st.one_of(st.just(Fraction(0)), SHARES),
    st.sampled_from(["exact", "exact", "exact", "series", "infinite"]),
    st.sampled_from(QUANTITIES),
    st.fractions(Fraction(1, 97), Fraction(96, 97), max_denominator=97),
)
# Double zeros of the slope, long and short rods, a bent course of the acceleration.
@example(Fraction(1, 3), Fraction(0), "exact", "p", Fraction(1, 40))
@example(Fraction(9, 10), Fraction(9, 10), "exact", "p", Fraction(1, 2))
@example(Fraction(9, 10), Fraction(-9, 10), "exact", "c", Fraction(96, 97))
@example(Fraction(1, 4), Fraction(0), "series", "p", Fraction(1, 97))
def test_roots_are_those_of_a_scan(
    ratio: Fraction, aside: Fraction, method: str, quantity: str, share: Fraction
) -> None:
    offset = (1 / ratio - 1) * aside
    assume(method == "exact" or (quantity in MOTION and not offset))
    drive, true = slide(ratio, offset, method), verify.drive(ratio, offset)
    spans, key = ends(drive), "x_stroke" if quantity == "s" else quantity
    # A value that the outstroke has.
    begin, end = spans[OUT]
    value = f"{course(drive, quantity)(np.array([begin + (end - begin) * float(share)]))[0]:.6f}"
    rows = found(
        f"--ratio={ratio}", f"--offset={offset}", f"--method={method}", f"--where={quantity}={value}"
    )
    for stroke in STROKES:
        roots = angles(rows, stroke)
        for root in roots:
            there = true.value(key, root, method, stroke=stroke).near()
            assert abs(there - Fraction(value)) < Fraction(1, 10**21)
        places = [radians(root, stroke) for root in roots]
        check_none_missed(course(drive, quantity, stroke), spans[stroke], float(value), places)


@settings(deadline=None, max_examples=30)
@given(RATIOS, SHARES, st.sampled_from(QUANTITIES[2:]), st.sampled_from(["max", "min", "|max|"]))
def test_nothing_on_a_stroke_is_beyond_its_greatest_and_least_value(
    ratio: Fraction, aside: Fraction, quantity: str, extreme: str
) -> None:
    offset = (1 / ratio - 1) * aside
    drive, sign = slide(ratio, offset), -1 if extreme == "min" else 1
    where = f"|{quantity}|=max" if extreme == "|max|" else f"{quantity}={extreme}"
    rows = found(f"--ratio={ratio}", f"--offset={offset}", f"--where={where}", digits=12)
    # The greatest lean of the rod is that to either side.
    lean = abs if extreme == "|max|" or (quantity, extreme) == ("psi", "max") else float
    for stroke in STROKES:
        roots, scanned = angles(rows, stroke), course(drive, quantity, stroke)
        scan = scanned(np.linspace(*ends(drive)[stroke], 4001))
        heights = sign * (abs(scan) if lean is abs else scan)
        best = max(heights)
        # The dead centre at which a stroke ends belongs to the next.
        assert roots or heights[-1] == pytest.approx(best, rel=1e-12)
        for root in roots:
            value = sign * lean(float(scanned(np.array([radians(root, stroke)]))[0]))
            assert value == pytest.approx(best, rel=2e-5, abs=2e-5)
            assert value > best - 1e-12 * max(1, abs(best))


@settings(deadline=None, max_examples=12)
@given(
    st.sampled_from([("1:5", "6", "0"), ("1:3", "4", "0.3"), ("1:4", "3.5", "-0.4")]),
    st.sampled_from(["path", "velocity", "acceleration"]),
    st.floats(0.02, 0.98),
)
def test_roots_of_the_arc_crank_are_those_of_its_links(
    sizes: tuple[str, str, str], quantity: str, share: float
) -> None:
    ratio, rocker, offset = sizes
    drive = ("--mechanism=arc", f"--ratio={ratio}", f"--rocker={rocker}", f"--offset={offset}")
    links = machine(mechanism="arc", ratio=ratio, rocker=rocker, offset=offset, eps="3", back="0.1")
    inner, outer = np.radians(links.dead_centres)
    motion, step = links.drive.motion, 1e-4

    def scanned(angle: Any, stroke: str) -> Any:
        sign = 1 if stroke == OUT else -1
        begin = inner if stroke == OUT else outer
        if quantity == "path":
            return sign * (motion(angle).way - motion(np.array([begin])).way)
        if quantity == "velocity":
            return sign * motion(angle).speed
        return sign * (motion(angle + step).speed - motion(angle - step).speed) / (2 * step)

    value = f"{scanned(np.array([inner + (outer - inner) * share]), OUT)[0]:.5f}"
    rows = found(*drive, f"--where={quantity}={value}", digits=12)
    for stroke, span in ((OUT, (inner, outer)), (RETURN, (outer, inner + 2 * np.pi))):
        roots = [radians(root, stroke) for root in angles(rows, stroke)]
        for root in roots:
            assert scanned(np.array([root]), stroke)[0] == pytest.approx(float(value), abs=1e-7)
        check_none_missed(partial(scanned, stroke=stroke), span, float(value), roots)


# Places that are known: by their condition the strokes and angles, None where the angle is no round one.
ROUND: list[tuple[Sequence[str], str, list[tuple[str, int | None]]]] = [
    (FIFTH, "psi = max", [(OUT, 90), (RETURN, 90)]),
    # On the outstroke p falls through what the return stroke begins with.
    (FIFTH, "p = 0.8", [(OUT, None), (RETURN, 0)]),
    (FIFTH, "p = -0.8", [(OUT, 180), (RETURN, None)]),
    (FIFTH, "p = 1.2", [(OUT, 0)]),
    (FIFTH, "p = 1 of dead centre", [(OUT, 0), (RETURN, 0)]),
    (FIFTH, "x = 2", [(OUT, 180), (RETURN, 180)]),
    (FIFTH, "s = 100%", [(OUT, 180), (RETURN, 180)]),
    # A dead centre belongs to the stroke that begins there.
    (FIFTH, "x = 0", [(OUT, 0), (RETURN, 0)]),
    (FIFTH, "s = 0", [(OUT, 0), (RETURN, 0)]),
    (FIFTH, "c = 0", [(OUT, 0), (RETURN, 0)]),
    (FIFTH, "psi = 0", [(OUT, 0), (RETURN, 0)]),
    (FIFTH, "c = min", [(OUT, 0), (RETURN, 0)]),
    (FIFTH, "rod_force = 1", [(OUT, 0), (RETURN, 0)]),
    (FIFTH, "c = 1", [(OUT, None), (OUT, 90), (RETURN, 90), (RETURN, None)]),
    # A value just reached is had once: p = cos φ + λ cos 2φ is least at cos φ = -1/(4λ), by -1/(8λ) - λ.
    (("--ratio=1:3", "--method=series"), "p = -17/24", [(OUT, None), (RETURN, None)]),
    # With λ = 1/4 it is a fourfold zero at the dead centre; a hair below is nothing.
    (("--ratio=1:4", "--method=series"), "p = -3/4", [(OUT, 180), (RETURN, None)]),
    (("--ratio=1:4", "--method=series"), "p = -0.75000001", [(RETURN, None)]),
    # tan ψ = 3/4 at sin φ = 1 with λ = 3/5.
    (("--ratio=3:5",), "guide_force = 3/4", [(OUT, 90)]),
    (("--ratio=1:2",), "psi = 30", [(OUT, 90)]),
    (("--ratio=1:2",), "psi = -30", [(RETURN, 90)]),
    (("--ratio=1:5", "--method=series"), "p = -0.2", [(OUT, 90), (RETURN, None)]),
    (("--ratio=1:5", "--method=series"), "x = 0.575", [(OUT, 60), (RETURN, None)]),
    (("--ratio=1:5", "--method=series"), "p = 0.4", [(OUT, 60), (RETURN, None)]),
    (("--method=infinite",), "c = 1", [(OUT, 90), (RETURN, 90)]),
    (("--method=infinite",), "p = 0.5", [(OUT, 60), (RETURN, 60)]),
    (("--method=infinite",), "s = 75%", [(OUT, 120), (RETURN, 120)]),
    (("--method=infinite",), "c = 0.5", [(OUT, 30), (OUT, 150), (RETURN, 30), (RETURN, 150)]),
    # sin ψ = λ (sin φ - 1/2), and c = sin φ + cos φ tan ψ is 1 at 90°, and 1/2 where ψ = 0.
    (("--ratio=1:4", "--offset=0.5"), "psi = 0", [(OUT, 30), (OUT, 150)]),
    (("--ratio=1:4", "--offset=0.5"), "c = 1/2", [(OUT, 30), (OUT, None), (RETURN, None), (RETURN, None)]),
    # The return stroke has its first acceleration once more.
    (("--ratio=1:4", "--offset=0.5"), "p = of dead centre", [(OUT, None), (RETURN, None), (RETURN, None)]),
    # L + R = 15, L - R = 13, e = 12: 9 and 5 along the slide, a stroke of 4, had at its end.
    (("--ratio=1:14", "--offset=12"), "x = 4", [(OUT, None), (RETURN, None)]),
    # The crosshead is √a, √b and √c from the shaft at both dead centres and at 90°, and 2 √c = √a + √b.
    (("--ratio=84:125", "--offset=17/42"), "s = 50%", [(OUT, 90), (RETURN, None)]),
    (("--ratio=1:5", "--stroke=600mm", "--speed=10rad/s"), "c = 3 m/s",
     [(OUT, None), (OUT, 90), (RETURN, 90), (RETURN, None)]),
]  # fmt: skip


@pytest.mark.parametrize(("words", "text", "places"), ROUND, ids=lambda one: str(one))
def test_a_place_that_is_known_is_had_once_and_round_angles_are_round(
    words: Sequence[str], text: str, places: list[tuple[str, int | None]]
) -> None:
    rows = found(*words, f"--where={text}", digits=40)
    assert [row["stroke"] for row in rows] == [stroke for stroke, _ in places]
    for row, (_, degrees) in zip(rows, places, strict=True):
        # Recognised or not, the digits behind the point say whether the angle is round.
        assert (Fraction(row["phi"]) == degrees) == (degrees is not None), row
    assert len({row["phi_turn"] for row in rows}) == len(rows)


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize(
    ("words", "quantity", "value", "degrees"),
    [
        # At 60° of the first order x = 0.575 and p = 0.4.
        (("--method=series",), "x", Fraction(575, 1000), 60),
        (("--method=series",), "p", Fraction(2, 5), 60),
        ((), "c", Fraction(1), 90),
        (("--offset=1",), "psi", Fraction(0), 90),
    ],
)
def test_an_angle_next_to_a_round_one_is_not_taken_for_it(
    words: tuple[str, ...], quantity: str, value: Fraction, degrees: int, sign: int
) -> None:
    apart = sign * Fraction(1, 10**24)
    rows = found(*FIFTH, *words, f"--where={quantity}={value + apart}", digits=30)
    near = [abs(Fraction(row["phi"]) - degrees) for row in rows if row["stroke"] == OUT]
    if quantity == "psi":
        # The rod leans to the one side alone, and touches 0.
        assert len(near) == (2 if sign < 0 else 0)
    assert all(one > Fraction(1, 10**25) for one in near)
    assert quantity == "psi" or min(near) < Fraction(1, 10**21)


def test_two_roots_that_a_hair_parts_are_both_found_and_below_them_none() -> None:
    # p of the exact formulas has its least value on the outstroke before the dead centre for λ = 1/3.
    words = ("solve", "--ratio=1:3", "--where=p=min", "--columns=p,phi", "--digits=40", "-f", "csv")
    least = Fraction(printed(*words).records()[0]["p"])
    for apart, count in ((1, 2), (-1, 0)):
        rows = found("--ratio=1:3", f"--where=p={least + Fraction(apart, 10**30)}", digits=30)
        own = [Fraction(row["phi"]) for row in rows if row["stroke"] == OUT]
        assert len(own) == count
        if count:
            assert 0 < own[1] - own[0] < Fraction(1, 10**11)


@pytest.mark.parametrize(
    ("words", "text", "column", "digits", "away", "even"),
    [
        (("--ratio=1:5", "--method=series"), "x = 0.575", "x", 2, "0.58", "0.58"),
        (("--ratio=1:5", "--method=series"), "x = 0.575", "p", 1, "0.4", "0.4"),
        # No round angle: cos φ = 1/980 makes ψ and p rational or roots of rationals, x the value asked for.
        (FIFTH, "x = 1.25", "x", 1, "1.3", "1.2"),
        (FIFTH, "x = 1.25", "x_stroke", 2, "0.63", "0.62"),
        (FIFTH, "x = 1.25", "x_stroke", 3, "0.625", "0.625"),
        (("--ratio=1:4", "--offset=0.5"), "x = 1.25", "x", 1, "1.3", "1.2"),
        # cos φ = 3/5 and λ = 3/4: sin ψ = 3/5, x = 2/5 + 4/15, c = 4/5 + 3/5 · 3/4, tan ψ = 3/4.
        (("--ratio=3:4",), "x = 2/3", "c", 1, "1.3", "1.2"),
        (("--ratio=3:4",), "x = 2/3", "guide_force", 1, "0.8", "0.8"),
        (("--ratio=3:4",), "x = 2/3", "rod_force", 1, "1.3", "1.2"),
        # -1/6 (1 - 1/16) = -0.15625, on the return stroke.
        (("--ratio=1:16", "--method=series"), "p = -1/6 of dead centre", "p", 4, "-0.1563", "-0.1562"),
    ],
)
def test_values_at_a_root_that_lie_half_way_are_proved_to(
    words: Sequence[str], text: str, column: str, digits: int, away: str, even: str
) -> None:
    for rounding, number in (("half-away", away), ("half-even", even)):
        asked = (*words, f"--where={text}", f"--columns={column}", f"--digits={digits}")
        rows = records("solve", *asked, f"--rounding={rounding}")
        assert rows[-1 if number[0] == "-" else 0][column] == number


@pytest.mark.parametrize(
    ("words", "text", "bare"),
    [
        (("--stroke=600mm",), "x = 200 mm", "x = 2/3"),
        (("--stroke=600mm", "--speed=10rad/s"), "c = 10.8 km/h", "c = 1"),
        (("--stroke=600mm", "--speed=10rad/s"), "p = 12 m/s^2", "p = 2/5"),
        (("--offset=0.5",), "s = 25%", "s = 1/4"),
        ((), "p = 1/2 of dead centre", "p = 0.6"),
    ],
)
def test_a_value_with_a_unit_is_had_where_its_share_is(words: tuple[str, ...], text: str, bare: str) -> None:
    with_unit, without = (found(*FIFTH, *words, f"--where={one}") for one in (text, bare))
    assert with_unit[0] == without[0]
    assert (with_unit == without) == ("dead centre" not in text)


@pytest.mark.parametrize("offset", ["0", "-0.6"])
def test_every_column_at_a_root_is_that_of_its_angle(offset: str) -> None:
    words = ["solve", "--ratio=1:4", f"--offset={offset}", "--stroke=300mm", "--speed=125/min", "-f", "csv"]
    words += ["--where=p = 1.07", "--where=s = 37%", "--where=psi = min"]
    keys = (
        "x_mm", "x_stroke", "c_mps", "p_mps2", "psi", "time", "rod_velocity_radps", "rod_acceleration_radps2",
        "rod_force", "guide_force", "torque",
    )  # fmt: skip
    drive = verify.drive("1:4", offset, radius="0.15", speed=Fraction(125, 60), turns=True)
    rows = printed(*words, f"--columns={','.join(keys)}", "--digits=9").records()
    places = printed(*words, "--columns=phi", "--digits=40").records()
    assert {row["stroke"] for row in places} == set(STROKES)
    for row, place in zip(rows, places, strict=True):
        for key in keys:
            value = drive.value(key, place["phi"], stroke=place["stroke"])
            assert value.confirms(row[key]) == verify.CONFIRMED, (place, key)
