"""Where conditions hold: every place of a scan by the textbook's formulas, each once, and nothing else."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Any

import flint
import pytest
import textbook
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st
from links import CRANKS, FLOATS, links, of_stroke
from links import shown as links_shown
from mpmath import mp

from kurbel.drive.crank import Crank
from kurbel.errors import NoRootError, ProblemError
from kurbel.exact.certify import ball, half_turn_circle
from kurbel.exact.course import Course, Target
from kurbel.exact.place import SQUARE, exact_place
from kurbel.kernel import kinematics
from kurbel.linkage.arc.crank import ArcCrank
from kurbel.linkage.arc.drive import ArcDrive, arc_columns
from kurbel.motion.drives import Drive, condition_names
from kurbel.motion.evaluation import OFFSET, OUT, RETURN, At
from kurbel.motion.slide import SlideDrive, slide_columns
from kurbel.page.quantity import Formula, entry
from kurbel.reading.units import Speed
from kurbel.reading.where import VALUE, Condition, read_condition
from kurbel.solve.solve import Root, solve, target_of

# mpmath has no types.
Real = Any
FIFTH = Crank(Fraction(1, 5))
ratios = st.fractions(Fraction(1, 20), Fraction(9, 10), max_denominator=60)
shares = st.fractions(Fraction(-9, 10), Fraction(9, 10), max_denominator=20)


def solved(drive: Drive, text: str) -> list[Root]:
    return list(solve(drive, read_condition(text, drive.names)))


def degrees(root: Root, digits: int = 40) -> Fraction:
    """φ of the stroke, to so many decimals."""
    return Fraction(root.angle(False, 1, digits, "half-away").scaled, 10**digits)


def exact_degrees(roots: Sequence[Root]) -> list[tuple[int, Fraction | None]]:
    return [(root.stroke, root.place.degrees) for root in roots]


def drive_of(crank: Crank) -> textbook.Drive:
    return textbook.Drive(crank.ratio, crank.offset)


TEXTBOOK = {"s": "x", "psi": "psi"}


def course_of(drive: SlideDrive, quantity: str, stroke: int) -> Callable[[Fraction], Real]:
    """The quantity on a stroke by the textbook, at an angle in degrees."""
    key = TEXTBOOK.get(quantity, quantity) + ("_return" if stroke == RETURN else "")
    if quantity == "s":
        key += "_stroke"

    def at(angle: Fraction) -> Real:
        return textbook.evaluate(key, drive.method, drive_of(drive.crank), angle, bits=200)

    return at


def ends_of(crank: Crank, stroke: int) -> tuple[Fraction, Fraction]:
    """The dead centres by the triangle in which crank and rod lie in line, in degrees, a little inside."""
    with mp.workdps(40):
        rod, e = 1 / textbook.real(crank.ratio), textbook.real(crank.offset)
        inner, outer = mp.degrees(mp.asin(e / (rod + 1))), mp.degrees(mp.asin(e / (rod - 1)))
        begin, end = (inner, 180 + outer) if stroke == OUT else (outer, 180 + inner)
        # mpmath has more digits than a denominator of this size shows.
        near = Fraction(1, 10**30)
        return _fraction(begin) + near, _fraction(end) - near


def _fraction(number: Real) -> Fraction:
    return Fraction(str(mp.nstr(number, 36)))


def assert_all_found(
    at: Callable[[Fraction], Real], ends: tuple[Fraction, Fraction], value: Real, found: Sequence[Fraction]
) -> None:
    """Compare with a scan: where the sign changes an odd number of roots lies, elsewhere an even one.

    Each root is one of the textbook's.
    """
    for root in found:
        assert abs(at(root) - value) < mp.mpf(10) ** -25, f"{float(root)}° is no root"
    begin, end = ends
    grid = [begin + (end - begin) * step / 40 for step in range(41)]
    # A root on a point of the grid is 0 but for rounding, and parts no interval.
    signs = [mp.sign(mp.chop(at(angle) - value, mp.mpf(10) ** -25)) for angle in grid]
    for (low, before), (high, after) in pairwise(zip(grid, signs, strict=True)):
        inside = sum(low < root <= high for root in found)
        if before * after:
            assert inside % 2 == (before != after), f"{inside} roots in {float(low)}°..{float(high)}°"


@settings(deadline=None, max_examples=30)
@given(
    ratios,
    st.one_of(st.just(Fraction(0)), shares),
    st.sampled_from(["exact", "exact", "series", "infinite"]),
    st.sampled_from(["x", "s", "c", "p", "psi", "guide_force", "tangential_force", "radial_force"]),
    st.fractions(Fraction(1, 97), Fraction(96, 97), max_denominator=97),
)
# Double zeros of the slope, long and short rods, a bent course of the acceleration.
@example(Fraction(1, 3), Fraction(0), "exact", "p", Fraction(1, 40))
@example(Fraction(9, 10), Fraction(9, 10), "exact", "p", Fraction(1, 2))
@example(Fraction(9, 10), Fraction(-9, 10), "exact", "c", Fraction(96, 97))
@example(Fraction(1, 4), Fraction(0), "series", "p", Fraction(1, 97))
def test_roots_are_those_of_a_scan(
    ratio: Fraction, offset: Fraction, method: str, quantity: str, share: Fraction
) -> None:
    crank = Crank(ratio, (1 / ratio - 1) * offset)
    assume(not (crank.offset and method != "exact"))
    assume(method == "exact" or quantity in ("x", "s", "c", "p"))
    drive = SlideDrive(crank if method != "infinite" else Crank(Fraction(0)), method)
    # A value that the outstroke has, for it lies between two that are had.
    at = course_of(drive, quantity, OUT)
    begin, end = ends_of(crank, OUT)
    value = Fraction(int(at(begin + (end - begin) * share) * 10**6), 10**6)
    try:
        found = list(solve(drive, Condition(quantity, VALUE, value)))
    except NoRootError:
        found = []
    for stroke in (OUT, RETURN):
        mine = [degrees(root) for root in found if root.stroke == stroke]
        assert mine == sorted(mine)
        at = course_of(drive, quantity, stroke)
        with mp.workdps(50):
            assert_all_found(at, ends_of(crank, stroke), textbook.real(value), mine)


@settings(deadline=None, max_examples=20)
@given(st.sampled_from(CRANKS), st.sampled_from(["path", "velocity", "acceleration"]), st.floats(0.02, 0.98))
def test_roots_of_the_arc_crank_are_those_of_the_closed_links(
    crank: ArcCrank, quantity: str, share: float
) -> None:
    drive = ArcDrive(crank)
    course = drive.course(quantity, OUT)
    begin, end = (Fraction(float((180 * place.half_turns()).mid())) for place in (course.begin, course.end))
    with mp.workdps(30):
        value = links(crank).value(quantity, OUT, begin + (end - begin) * Fraction(share))
        wanted = Fraction(str(mp.nstr(value, 5)))
        try:
            found = solved(drive, f"{quantity} = {wanted}")
        except NoRootError:
            found = []
        for root in found:
            apart = links(crank).value(quantity, root.stroke, degrees(root)) - textbook.real(wanted)
            assert abs(apart) < mp.mpf(10) ** -10
        # The scan is in floats: mpmath takes a minute for as many.
        for stroke in (OUT, RETURN):
            _compare_with_floats(crank, quantity, stroke, float(wanted), found)


def _compare_with_floats(
    crank: ArcCrank, quantity: str, stroke: int, value: float, found: Sequence[Root]
) -> None:
    import numpy as np

    from kurbel.kernel.circle import circle
    from kurbel.linkage import linkage

    course = ArcDrive(crank).course(quantity, stroke)
    begin, end = (float((180 * place.half_turns()).mid()) for place in (course.begin, course.end))
    grid = np.linspace(begin + 1e-9, end - 1e-9, 2001)
    signs = np.sign(linkage.value(of_stroke(quantity, stroke), crank, circle(grid), FLOATS) - value)
    mine = np.array([float(degrees(root)) for root in found if root.stroke == stroke])
    for low, high, before, after in zip(grid, grid[1:], signs, signs[1:], strict=False):
        inside = ((mine > low) & (mine <= high)).sum()
        assert inside % 2 == (before != after)


@pytest.mark.parametrize("crank", CRANKS, ids=links_shown)
def test_the_rocker_and_shares_of_the_stroke_are_had_once_on_a_stroke(crank: ArcCrank) -> None:
    drive = ArcDrive(crank)
    for text in ("s = 3/7", "s = 0.9"):
        found = solved(drive, text)
        assert [root.stroke for root in found] == [OUT, RETURN]
        for root in found:
            share = drive.digits("path_stroke", root.stroke, root.place, 12, "half-away")
            assert abs(
                Fraction(share, 10**12)
                - read_condition(text, condition_names(slide_columns().values())).value
            ) <= Fraction(1, 10**12)
    middle = drive.course("rocker", OUT)
    with flint.ctx.workprec(64):
        theta = sum(float(middle.value(place.half_turns()).mid()) for place in (middle.begin, middle.end)) / 2
    for root in solved(drive, f"rocker = {theta:.4f}"):
        with mp.workdps(30):
            found_angle = links(crank).value("rocker", root.stroke, degrees(root))
            assert abs(found_angle - mp.mpf(f"{theta:.4f}")) < mp.mpf(10) ** -12


@settings(deadline=None, max_examples=40)
@given(ratios, shares, st.sampled_from(["c", "p", "psi", "guide_force"]), st.sampled_from(["max", "min"]))
def test_nothing_on_a_stroke_is_beyond_its_greatest_and_least_value(
    ratio: Fraction, offset: Fraction, quantity: str, extreme: str
) -> None:
    crank = Crank(ratio, (1 / ratio - 1) * offset)
    drive = SlideDrive(crank)
    # The greatest lean of the rod is that to either side.
    lean = abs if (quantity, extreme) == ("psi", "max") else mp.mpf
    sign = 1 if extreme == "max" else -1
    found = solved(drive, f"{quantity} = {extreme}")
    for stroke in {root.stroke for root in found}:
        at, (begin, end) = course_of(drive, quantity, stroke), ends_of(crank, stroke)
        with mp.workdps(50):
            best = sign * lean(at(degrees(next(root for root in found if root.stroke == stroke))))
            scan = max(sign * lean(at(begin + (end - begin) * step / 90)) for step in range(91))
            assert scan <= best + mp.mpf(10) ** -20
            assert best - scan < 0.02 * max(1, abs(best))


def test_the_rod_leans_furthest_halfway_on_both_strokes() -> None:
    half = Fraction(90)
    assert exact_degrees(solved(SlideDrive(FIFTH), "psi = max")) == [(OUT, half), (RETURN, half)]


def test_a_value_at_a_dead_centre_is_had_there_once() -> None:
    drive = SlideDrive(FIFTH)
    found = solved(drive, "p = 0.8")
    # On the outstroke p falls through it, on the return stroke it begins with it.
    assert exact_degrees(found) == [(OUT, None), (RETURN, Fraction(0))]
    assert exact_degrees(solved(drive, "p = -0.8")) == [(OUT, Fraction(180)), (RETURN, None)]
    assert exact_degrees(solved(drive, "p = 1.2")) == [(OUT, Fraction(0))]
    assert exact_degrees(solved(drive, "p = 1 of dead centre")) == [(OUT, Fraction(0)), (RETURN, Fraction(0))]
    assert exact_degrees(solved(drive, "x = 2")) == [(OUT, Fraction(180)), (RETURN, Fraction(180))]
    assert exact_degrees(solved(drive, "s = 100%")) == [(OUT, Fraction(180)), (RETURN, Fraction(180))]


@pytest.mark.parametrize("text", ["x = 0", "s = 0", "c = 0", "psi = 0", "c = min", "rod_force = 1"])
def test_a_dead_centre_belongs_to_the_stroke_that_begins_there(text: str) -> None:
    assert exact_degrees(solved(SlideDrive(FIFTH), text)) == [(OUT, Fraction(0)), (RETURN, Fraction(0))]


def test_a_value_just_reached_is_had_once() -> None:
    # p = cos φ + λ cos 2φ is least at cos φ = -1/(4λ), where it is -1/(8λ) - λ.
    (out, _) = solved(SlideDrive(Crank(Fraction(1, 3)), "series"), "p = -17/24")
    assert abs(mp.cos(mp.radians(textbook.real(degrees(out)))) + mp.mpf("0.75")) < mp.mpf(10) ** -14
    # With λ = 1/4 it is a fourfold zero at the dead centre.
    found = solved(SlideDrive(Crank(Fraction(1, 4)), "series"), "p = -3/4")
    assert exact_degrees(found) == [(OUT, Fraction(180)), (RETURN, None)]
    # A hair below, nothing.
    assert [
        root.stroke for root in solved(SlideDrive(Crank(Fraction(1, 4)), "series"), "p = -0.75000001")
    ] == [RETURN]
    # tan ψ = 3/4 at sin φ = 1 with λ = 3/5.
    found = solved(SlideDrive(Crank(Fraction(3, 5))), "guide_force = 3/4")
    assert exact_degrees(found) == [(OUT, Fraction(90))]
    for stroke, text in ((OUT, "psi = 30"), (RETURN, "psi = -30")):
        assert exact_degrees(solved(SlideDrive(Crank(Fraction(1, 2))), text)) == [(stroke, Fraction(90))]
    assert exact_degrees(solved(SlideDrive(Crank(Fraction(0)), "infinite"), "c = 1")) == [
        (OUT, Fraction(90)),
        (RETURN, Fraction(90)),
    ]


@pytest.mark.parametrize(
    ("method", "text", "angles"),
    [
        ("series", "p = -0.2", [90, None]),
        ("series", "x = 0.575", [60, None]),
        ("series", "p = 0.4", [60, None]),
        ("exact", "c = 1", [None, 90, 90, None]),
        ("infinite", "p = 0.5", [60, 60]),
        ("infinite", "s = 75%", [120, 120]),
        ("infinite", "c = 0.5", [30, 150, 30, 150]),
    ],
)
def test_round_angles_are_recognised(method: str, text: str, angles: list[int | None]) -> None:
    crank = Crank(Fraction(0)) if method == "infinite" else FIFTH
    found = [angle for _, angle in exact_degrees(solved(SlideDrive(crank, method), text))]
    assert found == [None if angle is None else Fraction(angle) for angle in angles]


def test_round_angles_of_the_offset_crank_are_recognised() -> None:
    # sin ψ = λ (sin φ - 1/2).
    drive = SlideDrive(Crank(Fraction(1, 4), Fraction(1, 2)))
    assert exact_degrees(solved(drive, "psi = 0")) == [(OUT, Fraction(30)), (OUT, Fraction(150))]
    # c = sin φ + cos φ tan ψ is 1 at 90°, and 1/2 where ψ = 0.
    assert (OUT, Fraction(90)) in exact_degrees(solved(drive, "c = 1"))
    assert (OUT, Fraction(30)) in exact_degrees(solved(drive, "c = 1/2"))


def test_a_round_angle_is_recognised_where_the_stroke_is_irrational() -> None:
    # The crosshead is √a, √b and √c from the shaft, along the slide, at both dead centres and at 90°.
    rod, e = Fraction(125, 84), Fraction(17, 42)
    a, b, c = (rod + 1) ** 2 - e**2, (rod - 1) ** 2 - e**2, rod**2 - (1 - e) ** 2
    assert 4 * c - a - b > 0
    assert (4 * c - a - b) ** 2 == 4 * a * b
    # Hence 2 √c = √a + √b: half of an irrational stroke is made.
    found = solved(SlideDrive(Crank(1 / rod, e)), "s = 50%")
    assert exact_degrees(found)[0] == (OUT, Fraction(90))


@pytest.mark.parametrize("offset", ["0", "0.3"])
@pytest.mark.parametrize("quantity", ["s", "p"])
def test_an_angle_next_to_a_round_one_is_not_taken_for_it(quantity: str, offset: str) -> None:
    course = SlideDrive(Crank(Fraction(1, 4), Fraction(offset))).course(quantity, OUT)
    with flint.ctx.workprec(200):
        exact = course.value(ball(Fraction(1, 3))).mid().fmpq()
    value = Fraction(int(exact.p), int(exact.q))
    places = course.roots(Target.rational(value))
    assert [place.degrees for place in places] == len(places) * [None]
    with flint.ctx.workprec(100):
        assert any(place.half_turns().contains(ball(Fraction(1, 3))) for place in places)


def test_a_root_at_the_very_cut_of_the_search_is_found() -> None:
    begin, end = (exact_place(Fraction(at), SQUARE, flint.fmpz_poly([1 - 2 * at, 1])) for at in (0, 1))
    # Its slope is zero at the beginning, so that the search has to cut.
    course = Course(lambda half_turns: half_turns**2, lambda half_turns: 2 * half_turns, begin, end)
    (place,) = course.roots(Target.rational(Fraction(5, 11) ** 2))
    with flint.ctx.workprec(200):
        assert abs(place.half_turns() - ball(Fraction(5, 11))) < ball(2) ** -150


def test_a_stroke_of_whole_sides_ends_exactly() -> None:
    # L + R = 15, L - R = 13, e = 12: 9 and 5 along the slide, a stroke of 4.
    drive = SlideDrive(Crank(Fraction(1, 14), Fraction(12)))
    for text in ("x = 4", "s = 100%"):
        found = solved(drive, text)
        assert [root.stroke for root in found] == [OUT, RETURN]
        assert all(
            root.place
            is drive.course(
                read_condition(text, condition_names(slide_columns().values())).quantity, root.stroke
            ).end
            for root in found
        )
    with pytest.raises(NoRootError):
        solved(drive, "x = 4.0000001")


def test_the_stroke_of_the_offset_crank_is_no_rational_number_to_be_reached() -> None:
    drive = SlideDrive(Crank(Fraction(1, 4), Fraction(1, 2)))
    # 2.01687...
    assert len(solved(drive, "x = 2.01")) == 2
    with pytest.raises(NoRootError, match=r"x lies between 0\.0000 and 2\.0169 R on both strokes"):
        solved(drive, "x = 2.02")


def test_values_at_a_root_are_certified_and_ties_proved() -> None:
    drive = SlideDrive(FIFTH, "series")
    (out, _) = solved(drive, "x = 0.575")
    assert out.number("x", 2, "half-away").scaled == 58
    assert out.number("x", 2, "half-even").scaled == 58
    assert out.number("p", 1, "half-away").scaled == 4
    # No round angle: cos φ = 1/980 makes ψ and p rational or roots of rationals, x the value asked for.
    (out, _) = solved(SlideDrive(FIFTH), "x = 1.25")
    assert (out.number("x", 1, "half-away").scaled, out.number("x", 1, "half-even").scaled) == (13, 12)
    assert out.number("x_stroke", 3, "half-even").scaled == 625
    assert out.number("x_stroke", 2, "half-even").scaled == 62
    (offset, _) = solved(SlideDrive(Crank(Fraction(1, 4), Fraction(1, 2))), "x = 1.25")
    assert (offset.number("x", 1, "half-away").scaled, offset.number("x", 1, "half-even").scaled) == (13, 12)


def test_a_tie_of_another_quantity_is_proved() -> None:
    # Exact path with cos φ = 3/5 and λ = 3/4: sin ψ = 3/5, cos ψ = 4/5 and x = 2/5 + 4/15.
    (out, _) = solved(SlideDrive(Crank(Fraction(3, 4))), "x = 2/3")
    assert out.place.degrees is None
    # c = 4/5 + 3/5 · 3/4 = 1.25.
    assert out.number("c", 1, "half-away").scaled == 13
    assert out.number("c", 1, "half-even").scaled == 12
    assert out.number("guide_force", 1, "half-away").scaled == 8
    assert out.number("rod_force", 1, "half-even").scaled == 12


def test_a_tie_below_zero_is_proved() -> None:
    # -1/6 (1 - 1/16) = -0.15625
    back = solved(SlideDrive(Crank(Fraction(1, 16)), "series"), "p = -1/6 of dead centre")[-1]
    assert back.place.degrees is None
    assert back.number("p", 4, "half-away").scaled == -1563
    assert back.number("p", 4, "half-even").scaled == -1562


def test_values_with_units_are_those_of_the_machine() -> None:
    machine = Crank(Fraction(1, 5), radius=Fraction(3, 10), speed=Speed(Fraction(2)))
    drive = SlideDrive(machine)
    for root in solved(drive, "x = 200 mm"):
        assert root.number("x_mm", 6, "half-away").scaled == 200 * 10**6
        assert root.number("x", 6, "half-away").scaled == 666667
    assert len(solved(drive, "c = 3 m/s")) == 4
    for root in solved(drive, "c = 3 m/s"):
        with mp.workdps(40):
            velocity = textbook.evaluate("c", "exact", drive_of(machine), degrees(root)) * 2 * mp.pi * 2
            assert (
                abs(root.stroke * _on_return(velocity, root, machine) * mp.mpf("0.3") - 3) < mp.mpf(10) ** -20
            )
    assert solved(drive, "p = 0 m/s²")[0].place.polynomial is not None
    in_radians = SlideDrive(Crank(Fraction(1, 5), radius=Fraction(3, 10), speed=Speed(Fraction(10), False)))
    # v = 3 m/s, had at 90°.
    assert (OUT, Fraction(90)) in exact_degrees(solved(in_radians, "c = 3 m/s"))


def _on_return(velocity: Real, root: Root, crank: Crank) -> Real:
    if root.stroke == OUT:
        return velocity
    return textbook.evaluate("c", "exact", drive_of(crank), degrees(root) + 180) * 4 * mp.pi


def test_shares_of_the_value_at_the_dead_centre() -> None:
    for crank in (FIFTH, Crank(Fraction(1, 4), Fraction(1, 2))):
        drive = SlideDrive(crank)
        for root in solved(drive, "p = 1/3 of dead centre"):
            at, (begin, _) = course_of(drive, "p", root.stroke), ends_of(crank, root.stroke)
            with mp.workdps(40):
                assert abs(at(degrees(root)) * 3 - at(begin)) < mp.mpf(10) ** -20
    whole = solved(SlideDrive(Crank(Fraction(1, 4), Fraction(1, 2))), "p = of dead centre")
    # The return stroke has its first acceleration once more.
    assert [root.stroke for root in whole] == [OUT, RETURN, RETURN]


def test_angles_of_the_turn_lie_between_0_and_360() -> None:
    drive = SlideDrive(Crank(Fraction(1, 4), Fraction(-2)))
    for text in ("x = 0", "s = 100%", "c = max", "p = 0", "s = 1%"):
        for root in solved(drive, text):
            turn = root.angle(True, 1, 6, "half-away").scaled
            assert 0 <= turn <= 360 * 10**6
            from_stroke = degrees(root, 6) * 10**6 + (180 * 10**6 if root.stroke == RETURN else 0)
            assert (turn - from_stroke) % (360 * 10**6) == 0


ON_STROKES = (
    " between -0.8000 and 1.2000 v²/R on the outstroke and between -1.2000 and 0.8000 v²/R on the return"
)


@pytest.mark.parametrize(
    ("method", "text", "said"),
    [
        ("exact", "p = 2", f"p lies{ON_STROKES} stroke"),
        (
            "series",
            "p = 2",
            f"p lies{ON_STROKES} stroke; unusable, beyond ±1: cos φ = 1.4075 and -3.9075 on the outstroke",
        ),
        ("exact", "c = -0.1", "c lies between 0.0000 and 1.0198 v on both strokes"),
        ("exact", "s = 101%", "s lies between 0% and 100% on both strokes"),
        (
            "exact",
            "psi = 90",
            "psi lies between 0.000° and 11.537° on the outstroke"
            " and between -11.537° and 0.000° on the return stroke",
        ),
    ],
)
def test_a_condition_without_a_root_is_answered_with_the_range(method: str, text: str, said: str) -> None:
    with pytest.raises(NoRootError) as caught:
        solved(SlideDrive(FIFTH, method), text)
    assert str(caught.value) == f"{text} is reached nowhere for R:L = 1:5; {said}"
    assert caught.value.exit_code == 1


def test_a_quantity_that_never_changes_is_named() -> None:
    with pytest.raises(ProblemError, match="psi is the same at every crank angle for R:L = 1:∞"):
        solved(SlideDrive(Crank(Fraction(0)), "infinite"), "psi = 0")


@settings(deadline=None, max_examples=25)
@given(
    ratios,
    st.sampled_from(sorted(set(condition_names(slide_columns().values()).values()))),
    st.fractions(-2, 2, max_denominator=50),
)
def test_a_condition_put_back_is_fulfilled(ratio: Fraction, quantity: str, value: Fraction) -> None:
    drive = SlideDrive(Crank(ratio))
    condition = Condition(quantity, VALUE, value)
    try:
        found = solve(drive, condition)
    except NoRootError:
        return
    for root in found:
        course, target = drive.course(quantity, root.stroke), target_of(drive, condition, root.stroke)
        with flint.ctx.workprec(300):
            apart = course.value(root.place.half_turns()) - target.ball()
            assert apart.contains(0)
            assert apart.rad() < ball(2) ** -200


def test_a_place_is_not_taken_for_another_so_near() -> None:
    # p of the exact formulas has no double zero near its least value, but two that a hair parts.
    drive = SlideDrive(Crank(Fraction(1, 3)))
    course = drive.course("p", OUT)
    (least,) = course.greatest(-1)
    with flint.ctx.workprec(200):
        value = course.value(least.half_turns())
        exact = value.mid().fmpq()
    low = Fraction(int(exact.p), int(exact.q)) + Fraction(1, 10**30)
    first, second = course.roots(Target.rational(low))
    assert (first.degrees, second.degrees) == (None, None)
    with flint.ctx.workprec(200):
        assert second.half_turns() - first.half_turns() > 0
        assert second.half_turns() - first.half_turns() < ball(10) ** -14
    assert not course.roots(Target.rational(low - Fraction(2, 10**30)))


def test_names_of_conditions_are_quantities_of_their_drives() -> None:
    assert {
        SlideDrive(FIFTH).column_of(name) for name in condition_names(slide_columns().values()).values()
    } <= set(SlideDrive(FIFTH).columns)
    arc = ArcDrive(CRANKS[0])
    assert {arc.column_of(name) for name in condition_names(arc_columns().values()).values()} <= set(
        arc.columns
    )


def with_entry(drive: SlideDrive, key: str, kernel: Callable[..., Any], **said: Any) -> SlideDrive:
    """Return the drive with another quantity."""
    one = entry(
        key, key, f"${key}$", "", 4, {"exact": Formula(kernel), OFFSET: Formula(kernel)}, names=(key,), **said
    )
    drive.entries = {**drive.entries, key: one}
    return drive


def test_a_quantity_of_which_nothing_proves_where_it_rises_is_refused() -> None:
    crank = Crank(Fraction(1, 5))

    def total(at: At) -> Any:
        along = kinematics.piston_acceleration(at.circle, at.ratio)
        return (1 + along * along) ** 0.5

    refused = with_entry(SlideDrive(crank), "total", total)
    for text in ("total=min", "total=1.1"):
        with pytest.raises(
            ProblemError, match="conditions on total are not solved for R:L = 1:5: nothing proves"
        ):
            solved(refused, text)
    refused = with_entry(
        SlideDrive(Crank(Fraction(1, 3), Fraction(1, 2))),
        "mu",
        lambda at: 90 - at.numbers.rod_angle(at.circle, at.ratio, at.offset),
        is_arc=True,
    )
    with pytest.raises(ProblemError, match="conditions on mu are not solved"):
        solved(refused, "mu=85")


def test_an_arc_that_rises_is_had_once_on_a_stroke() -> None:
    """arcsin x/3 of the straight crank: x/3 < 1 on the whole stroke."""
    drive = with_entry(
        SlideDrive(Crank(Fraction(1, 5))),
        "lift",
        lambda at: at.numbers.arc(kinematics.piston_path(at.circle, at.ratio) / 3),
        is_arc=True,
        rises=True,
    )
    (root_out, root_back) = solved(drive, "lift=30")
    for one in (root_out, root_back):
        ratio = Fraction(1, 5) * one.stroke
        path = kinematics.piston_path(half_turn_circle(one.place.half_turns()), ball(ratio))
        assert abs(float(path) - 1.5) < 1e-12
