"""Blau, examples 33 to 35: each printed value worked out anew, and the equations as he solves them."""

from __future__ import annotations

from fractions import Fraction
from typing import Any, NamedTuple

import pytest
from cli import printed
from mpmath import mp
from places import SOURCES
from registers import register

from kurbel.drive.crank import Crank
from kurbel.exact.certify import NEVER_TIES, rounded
from kurbel.exact.closed_form import ClosedForm, closed_forms, form_text
from kurbel.exact.numerals import Number, number_text
from kurbel.motion.drives import condition_names
from kurbel.motion.evaluation import OUT
from kurbel.motion.slide import SlideDrive, slide_columns
from kurbel.reading.notation import ratio
from kurbel.reading.where import read_condition
from kurbel.solve.solve import Root, solve, target_of

FILE = SOURCES / "blau" / "solved.csv"
# p over v²/R by the condition, from p = cos α + λ cos 2α, at the dead centre 1 + λ.
SHARES = {
    "p = 0": Fraction(0),
    "p = 1/6 of dead centre": Fraction(1, 6),
    "p = -1/6 of dead centre": Fraction(-1, 6),
}
# mpmath has no types.
Real = Any


class Cell(NamedTuple):
    """One printed value, what is true, and the record."""

    place: str
    condition: str
    cell: str
    computed: str
    record: str
    printed: str

    @property
    def ratio(self) -> Fraction:
        return ratio(self.place.split("/")[1])

    @property
    def value(self) -> str:
        return self.place.split("/")[2]

    def root(self) -> Root:
        """Return the root on the outstroke."""
        drive = SlideDrive(Crank(self.ratio), "series")
        return next(
            root
            for root in solve(
                drive, read_condition(self.condition, condition_names(slide_columns().values()))
            )
            if root.stroke == OUT
        )

    def forms(self) -> list[ClosedForm]:
        drive, condition = (
            SlideDrive(Crank(self.ratio), "series"),
            read_condition(self.condition, condition_names(slide_columns().values())),
        )
        formula = drive.course("p", OUT).formula
        assert formula is not None
        return closed_forms(formula, target_of(drive, condition, OUT))


def cells() -> list[Cell]:
    return [Cell(**row) for row in register(FILE)]


CELLS = cells()
each_cell = pytest.mark.parametrize("cell", CELLS, ids=[cell.place for cell in CELLS])


def decimals(text: str) -> int:
    return len(text.partition(",")[2])


@each_cell
def test_the_computed_value_is_that_of_the_quadratic_equation(cell: Cell) -> None:
    with mp.workdps(40):
        lam = mp.mpf(cell.ratio.numerator) / cell.ratio.denominator
        share = SHARES[cell.condition]
        value = (1 + lam) * share.numerator / share.denominator
        # 2 λ u² + u - λ - p = 0
        root = mp.sqrt(1 + 8 * lam * (lam + value))
        cosine, other = (-1 + root) / (4 * lam), (-1 - root) / (4 * lam)
        path = 1 - cosine + lam / 2 * (1 - cosine**2)
        true: dict[str, Real] = {"cos": cosine, "x": path, "x_stroke": path / 2, "unusable": other}
        if cell.value == "phi":
            assert minutes_apart(mp.degrees(mp.acos(cosine)), cell.computed) <= mp.mpf("0.5")
        else:
            wanted = Fraction(cell.computed.replace(",", "."))
            off = abs(true[cell.value] - mp.mpf(wanted.numerator) / wanted.denominator)
            assert off <= mp.mpf("0.5") * mp.mpf(10) ** -decimals(cell.computed)
    assert cell.record == ("agrees" if cell.printed == cell.computed else "differs")


def minutes_apart(degrees: Real, text: str) -> Real:
    """How far an angle is off, in units of the last place: minutes, or degrees where none are printed."""
    whole, _, minutes = text.rstrip("'").partition("°")
    apart = abs(degrees - int(whole) - mp.mpf(minutes or "0") / 60)
    return apart * 60 if minutes else apart


@each_cell
def test_kurbel_gives_the_computed_value(cell: Cell) -> None:
    places = decimals(cell.computed)
    if cell.value == "phi":
        share = 60 if "'" in cell.computed else 1
        angle = cell.root().angle(False, share, 0, "half-away").scaled
        whole, minutes = divmod(angle, share)
        assert cell.computed == (f"{whole}°{minutes}'" if share > 1 else f"{angle}°")
    elif cell.value in ("cos", "unusable"):
        form = next(form for form in cell.forms() if form.is_usable == (cell.value == "cos"))
        if not form.outside:
            assert form_text(form) == cell.computed
        else:
            scaled = rounded(form.ball, places, "half-away", NEVER_TIES)
            assert number_text(Number(scaled, places), ",") == cell.computed
    else:
        assert number_text(cell.root().number(cell.value, places, "half-away"), ",") == cell.computed


def test_quadratic_equations_are_solved_as_in_the_book() -> None:
    # (-5 ± √33)/4; (-2 ± √6)/2, for which he has -1 ± √1,5; -5/4 ± √(41/16); 0 and -5/2.
    by_place = {cell.place: cell.forms() for cell in CELLS if cell.value == "cos"}
    assert by_place == {
        "blau-33/1:5/cos": [ClosedForm(-5, 1, 33, 4), ClosedForm(-5, -1, 33, 4)],
        "blau-33/1:4/cos": [ClosedForm(-2, 1, 6, 2), ClosedForm(-2, -1, 6, 2)],
        "blau-34/1:5/cos": [ClosedForm(-5, 1, 41, 4), ClosedForm(-5, -1, 41, 4)],
        "blau-35/1:5/cos": [ClosedForm(0, 0, 1, 1), ClosedForm(-5, 0, 1, 2)],
    }
    assert [[form.is_usable for form in forms] for forms in by_place.values()] == 4 * [[True, False]]


@pytest.mark.parametrize(
    ("text", "forms"),
    [
        # 2 u²/5 + u - 7/5 = 0 at the inner dead centre, 2 u²/5 + u + 3/5 = 0 at the outer one.
        ("p = 1.2", [ClosedForm(1, 0, 1, 1), ClosedForm(-7, 0, 1, 2)]),
        ("p = -0.8", [ClosedForm(-1, 0, 1, 1), ClosedForm(-3, 0, 1, 2)]),
        # 1 - u + (1 - u²)/10 = 1.1
        ("x = 1.1", [ClosedForm(0, 0, 1, 1), ClosedForm(-10, 0, 1, 1)]),
    ],
)
def test_equations_with_rational_roots_are_solved_too(text: str, forms: list[ClosedForm]) -> None:
    drive, condition = (
        SlideDrive(Crank(Fraction(1, 5)), "series"),
        read_condition(text, condition_names(slide_columns().values())),
    )
    formula = drive.course(condition.quantity, OUT).formula
    assert formula is not None
    assert closed_forms(formula, target_of(drive, condition, OUT)) == forms


def page(*words: str) -> str:
    return " ".join(printed("solve", "--method=series", *words).out.split())


def test_the_page_of_example_33_has_both_strokes_and_the_unusable_root() -> None:
    german = page("--ratio=1:5", "--where=p=0")
    assert "Hingang 79°16′ 79°16′ 0,9104 0,4552" in german
    assert "Rückgang 100°44′ 280°44′ 1,0896 0,5448" in german
    said = "Hingang: cos φ = (−5 ± √33)/4, also 0,1861; −2,6861 unbrauchbar, jenseits ±1"
    assert said in german
    english = page("--ratio=1:5", "--where=p=0", "--lang=en")
    assert "Outstroke: cos φ = (−5 ± √33)/4, hence 0.1861; −2.6861 unusable, beyond ±1" in english


def test_the_page_of_example_35_names_its_unusable_root() -> None:
    german = page("--ratio=1:5", "--where=p = -1/6 of dead centre")
    assert "Hingang 90°0′ 90°0′ 1,1000 0,5500" in german
    assert "Hingang: cos φ = 0; −5/2 unbrauchbar, jenseits ±1" in german
