"""Pages of the arc crank against links closed by mpmath, of the parallel crank against its circle."""

from __future__ import annotations

import cmath
import math
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from cli import printed, refusal
from links import DIGITS, Real, links
from mpmath import mp
from pages import Address, cells

import kurbel
from kurbel.drive.crank import Crank
from kurbel.errors import KurbelError, ProblemError
from kurbel.exact.numerals import Number, number_text
from kurbel.linkage.arc.crank import ArcCrank
from kurbel.linkage.arc.quantities import arc_registry
from kurbel.linkage.quantities import FORCE
from kurbel.motion.evaluation import OUT, RETURN
from kurbel.page.labels import plain
from kurbel.page.layouts import LANGUAGES, layout
from kurbel.page.subject import subject
from kurbel.page.table import Table

ARC = ("table", "--mechanism", "arc")
# Motion of the links, decimals, and heads in German and English.
MOTIONS = {
    "path": (4, "Weg auf dem Bogen|$x/R$", "Path along the arc|$x/R$"),
    "velocity": (4, "Geschwindigkeit|$c/v$", "Velocity|$c/v$"),
    "acceleration": (4, "Beschleunigung|$(p R)/v^2$", "Acceleration|$(p R)/v^2$"),
    "rocker": (3, "Schwingenwinkel|$θ$ in °", "Rocker angle|$θ$ in °"),
    "rod": (3, "Schubstangenwinkel|$ψ$ in °", "Rod angle|$ψ$ in °"),
}
STROKES = {OUT: ("Hingang", "Outstroke"), RETURN: ("Rückgang", "Return")}
# Ratio, rocker, pivot: the default place, a pivot below the slide, and links that swing far.
DRIVES: list[tuple[str, str, tuple[str, str] | None]] = [
    ("1:5", "6", None),
    ("1:3.5", "9", ("3.7", "-9.2")),
    ("1:3", "2.5", ("4", "0")),
]
ANGLES = ("0", "22.5", "73", "131", "180")
each_drive = pytest.mark.parametrize("drive", DRIVES, ids=str)
each_language = pytest.mark.parametrize("lang", LANGUAGES)


def arc_crank(ratio: str, rocker: str, pivot: tuple[str, str] | None) -> ArcCrank:
    distance, height = (None, None) if pivot is None else map(Fraction, pivot)
    return ArcCrank(Crank(1 / Fraction(ratio.removeprefix("1:"))), Fraction(rocker), distance, height)


def page(drive: tuple[str, str, tuple[str, str] | None], **choices: Any) -> Table:
    ratio, rocker, pivot = drive
    return kurbel.table(ratio, mechanism="arc", rocker=rocker, pivot=pivot, **choices)


def rounded(value: Real, decimals: int) -> str:
    return number_text(Number(int(mp.nint(value * mp.mpf(10) ** decimals)), decimals))


def notes(table: Table) -> str:
    return " ".join(plain(note.text) for note in table.notes)


# Arc crank ---------------------------------------------------------------------------------------


@each_language
@each_drive
def test_every_cell_is_that_of_the_closed_links_under_its_heads(
    drive: tuple[str, str, tuple[str, str] | None], lang: str
) -> None:
    machine, column = links(arc_crank(*drive)), LANGUAGES.index(lang)
    expected: dict[Address, str] = {}
    with mp.workdps(DIGITS):
        for motion, (decimals, *heads) in MOTIONS.items():
            name, symbol = heads[column].split("|")
            for stroke, names in STROKES.items():
                for angle in ANGLES:
                    address = ("", f"{float(angle):.1f}", name, names[column], symbol)
                    found = machine.value(motion, stroke, Fraction(angle))
                    expected[address] = rounded(found, decimals)
    assert cells(page(drive, angle=";".join(ANGLES), lang=lang)) == expected


@pytest.mark.parametrize("ratio", ["1:5", "2:7"])
@pytest.mark.parametrize("offset", ["0", "0.5", "-0.7"])
def test_a_very_long_rocker_prints_the_page_of_the_slide_digit_for_digit(ratio: str, offset: str) -> None:
    arc = kurbel.table(ratio, mechanism="arc", rocker=10**9, offset=offset)
    columns = ("x", "x_return", "c", "c_return", "p", "p_return", "psi", "psi_return")
    straight = kurbel.table(ratio, offset=offset, columns=("ratio", "phi", *columns))
    found = [
        tuple(
            value for field, value in zip(arc.records.fields, row, strict=True) if "rocker" not in field.key
        )
        for row in arc.records.rows
    ]
    assert len(found) == 19
    assert found == [tuple(row) for row in straight.records.rows]


@each_language
@each_drive
def test_dead_centres_swing_times_and_transmission_stand_below_the_table(
    drive: tuple[str, str, tuple[str, str] | None], lang: str
) -> None:
    crank = arc_crank(*drive)
    machine = links(crank)
    with mp.workdps(DIGITS):
        (inner, high), (outer, low) = machine.inner, machine.outer
        apart = mp.degrees(outer - inner) % 360
        swing = abs(mp.degrees(high - low))
        ground = abs(machine.pivot)
        # The rod's end sees pin and pivot, the lines nearest to one another with crank and ground in line.
        cosines = [
            abs(machine.rod**2 + machine.rocker**2 - (ground + side) ** 2)
            / (2 * machine.rod * machine.rocker)
            for side in (1, -1)
        ]
        inner_degrees = (mp.degrees(inner) + 180) % 360 - 180
        expected = [
            ("φᵢ = {}°", rounded(inner_degrees, 3)),
            ("φₒ = {}°", rounded(mp.degrees(outer) % 360, 3)),
            ({"de": "Schwingungswinkel {}°", "en": "swing {}°"}[lang], rounded(swing, 3)),
            (
                {"de": "Hub auf dem Bogen {} R", "en": "stroke along the arc {} R"}[lang],
                rounded(mp.radians(swing) * machine.rocker, 4),
            ),
            (
                {"de": "Hingang zu Rückgang {}:1", "en": "outstroke and return {}:1"}[lang],
                rounded(apart / (360 - apart), 4),
            ),
            (
                {"de": "Übertragungswinkel {}°", "en": "transmission angle {}°"}[lang],
                rounded(mp.degrees(mp.acos(max(cosines))), 3),
            ),
        ]
    text = notes(page(drive, lang=lang, angle=30)).replace("−", "-")
    for words, digits in expected:
        assert words.format(digits) in text


def test_the_links_of_every_drive_stand_before_its_dead_centres() -> None:
    table = kurbel.table("1:5;3:10", mechanism="arc", rocker=6, angle="0;30")
    lines = [plain(note.text) for note in table.notes]
    assert lines[-2].startswith("R:L = 1:5, B = 6 R, D = 5 R, H = 6 R: Totlagen ")
    assert lines[-1].startswith("R:L = 3:10, B = 6 R, D = 10/3 R, H = 6 R: Totlagen ")
    assert table.caption.endswith("der Bogenschubkurbel für $B = 6 R$")
    assert {address[0] for address in cells(table)} == {"$R:L = 1:5$", "$R:L = 3:10$"}
    endless = notes(kurbel.table("1:∞", mechanism="arc", rocker=6, angle=30))
    assert "R:L = 1:∞, B = 6 R, H = 6 R: Totlagen φᵢ = 0.000° und φₒ = 180.000°" in endless
    # D and L have no length.
    assert "L cos ψ" not in endless


@each_drive
@pytest.mark.parametrize("stroke", [OUT, RETURN])
def test_the_formulas_below_the_table_give_its_numbers(
    drive: tuple[str, str, tuple[str, str] | None], stroke: int
) -> None:
    keys = ["phi", *(key if stroke == OUT else f"{key}_return" for key in (*MOTIONS, "slant"))]
    table = page(drive, angle="7..367:30" if stroke == OUT else "7..177:17", columns=keys, digits=14)
    crank = arc_crank(*drive)
    side = 1 if crank.pivot_height >= 0 else -1
    rod, rocker = float(1 / crank.crank.ratio), float(crank.rocker)
    distance = float(crank.distance or rod)
    dead = {OUT: links(crank).inner, RETURN: links(crank).outer}[stroke][1]
    start = math.degrees(cmath.phase(cmath.exp(1j * float(dead)) / (-side * 1j)))
    for row in table.records.rows:
        phi, x, c, p, theta, psi, tau = (number.scaled / 10**number.decimals for number in row)  # type: ignore[union-attr]
        assert tau == pytest.approx(psi + theta, abs=1e-12)
        assert x == pytest.approx(stroke * side * rocker * math.radians(start - theta), abs=1e-12)
        zeta, τ = math.radians(phi - theta), math.radians(tau)
        assert c == pytest.approx(math.sin(zeta + τ) / math.cos(τ), abs=1e-12)
        λ = stroke * float(crank.crank.ratio)
        bent = math.sin(zeta) + stroke * side / rocker * c**2
        expected = math.cos(zeta) + λ * math.cos(zeta) ** 2 / math.cos(τ) ** 3 - bent * math.tan(τ)
        assert p == pytest.approx(expected, abs=1e-12)
        φ, ψ, θ = (math.radians(angle) for angle in (phi, psi, theta))
        along = stroke * math.cos(φ) + rod * math.cos(ψ)
        across = stroke * math.sin(φ) - rod * math.sin(ψ)
        assert along == pytest.approx(distance + side * rocker * math.sin(θ), abs=1e-12)
        assert across == pytest.approx(float(crank.pivot_height) - side * rocker * math.cos(θ), abs=1e-12)
    sign, bow, back = ("+" if stroke == OUT else "−"), ("+" if stroke * side > 0 else "−"), "−+"[side < 0]
    text = notes(table)
    assert f"cos ζ {sign} λ (cos² ζ)/cos³ τ − (sin ζ {bow} β c²/v²) tan τ" in text
    lead = "" if stroke == OUT else "− "
    assert f"{lead}R cos φ + L cos ψ = D {'+' if side > 0 else '−'} B sin θ" in text
    assert f", {lead}R sin φ − L sin ψ = H {back} B cos θ" in text
    assert ("− R" in text) == (stroke != OUT)
    starts = {(OUT, 1): "θᵢ − θ", (OUT, -1): "θ − θᵢ", (RETURN, 1): "θ − θₒ", (RETURN, -1): "θₒ − θ"}
    assert f"x = B ({starts[stroke, side]})" in text


def test_both_strokes_have_both_signs_below_the_table() -> None:
    above, below = (notes(kurbel.table(mechanism="arc", rocker=6, pivot=(5, height))) for height in (6, -6))
    assert "cos ζ ± λ (cos² ζ)/cos³ τ − (sin ζ ± β" in above
    assert "cos ζ ± λ (cos² ζ)/cos³ τ − (sin ζ ∓ β" in below
    assert "oberes Zeichen: Hingang" in above
    paths = notes(kurbel.table(mechanism="arc", rocker=6, columns="phi,path,rod_velocity_return"))
    assert "ζ" not in paths
    assert "± R cos φ" in paths
    assert "oberes Zeichen" in paths
    assert "Rückgang bei 180° + φ" in paths


@each_language
def test_every_column_of_the_arc_crank_is_that_of_the_closed_links(lang: str) -> None:
    known = subject("arc crank").column_keys(layout("arc"))
    keys = [key for key in known if key not in ("ratio", "phi") and arc_registry()[key].of != FORCE]
    keys = [key for key in keys if not arc_registry()[key].needs]
    assert len(keys) == 28
    drive = ("1:3.5", "9", ("3.7", "-9.2"))
    table = page(drive, angle="73.1", columns=keys, lang=lang)
    assert len({field.name for field in table.records.fields}) == len(keys)
    (row,) = table.records.rows
    with mp.workdps(DIGITS):
        for key, field, number in zip(keys, table.records.fields, row, strict=True):
            motion, stroke = key.removesuffix("_return"), RETURN if key.endswith("_return") else OUT
            assert isinstance(number, Number)
            assert field.decimals == number.decimals == (3 if field.unit == "°" else 4)
            value = links(arc_crank(*drive)).value(motion, stroke, Fraction("73.1"))
            assert number_text(number) == rounded(value, number.decimals), key


# Of the links, in R, v = R ω, v²/R and ω: what makes a unit of them, where R = 40 mm and n = 90/min, and
# the power of π beside it.
SIZED = {
    "path_mm": ("path", "40", 0),
    "velocity_mps": ("velocity", "0.12", 1),
    "acceleration_mps2": ("acceleration", "0.36", 2),
    "turn_velocity_radps": ("turn_velocity", "3", 1),
    "turn_acceleration_radps2": ("turn_acceleration", "9", 2),
    "rod_velocity_radps": ("rod_velocity", "3", 1),
    "rod_acceleration_radps2": ("rod_acceleration", "9", 2),
}


@pytest.mark.parametrize("circuit", [1, -1])
def test_links_are_given_in_millimetres_and_printed_so(circuit: int) -> None:
    """A four-bar whose angles count from the line of centres."""
    lengths = ("--crank", "40mm", "--rod", "15cm", "--rocker", "80mm", "--pivot", "150mm;0")
    asked = ("--speed", "90/min", "--angle", "60", "--columns", ",".join(SIZED), "--digits", "9", "-f", "csv")
    (row,) = printed(*ARC, *lengths, f"--circuit={circuit}", *asked).records()
    # All lengths over that of the crank.
    drive = ArcCrank(Crank(Fraction(4, 15)), Fraction(2), Fraction(15, 4), Fraction(0), circuit)
    with mp.workdps(DIGITS):
        for key, (motion, unit, power) in SIZED.items():
            value = links(drive).value(motion, OUT, Fraction(60)) * mp.mpf(unit) * mp.pi**power
            assert Fraction(row[key]) == Fraction(rounded(value, 9)), key


def test_records_and_pages_have_the_same_digits() -> None:
    words = (*ARC, "--rocker", "6", "--ratio", "1:5;1:4", "--angle", "0;22,5", "--digits", "7")
    records = printed(*words, "-f", "csv").records()
    assert [(record["ratio"], record["phi"]) for record in records] == [
        (ratio, angle) for ratio in ("1:5", "1:4") for angle in ("0.0", "22.5")
    ]
    text = printed(*words, "--decimal", "point").out.replace("−", "-").split()
    for record in records:
        assert {record[key] for key in record if key != "ratio"} <= set(text)
    assert printed(*words, "--columns", "phi,path", "-f", "csv").out.splitlines()[0] == "ratio,phi,path"


# Parallel crank ----------------------------------------------------------------------------------


@each_language
def test_every_cell_of_the_parallel_crank_is_that_of_its_pin(lang: str) -> None:
    along, across, path, velocity, acceleration = {
        "de": ("längs der Wellenlinie", "quer zur Wellenlinie", "Weg", "Geschwindigkeit", "Beschleunigung"),
        "en": (
            "along the line of shafts",
            "square to the line of shafts",
            "Path",
            "Velocity",
            "Acceleration",
        ),
    }[lang]
    expected: dict[Address, str] = {}
    for angle in range(0, 361, 15):
        sine, cosine = mp.sin(mp.radians(angle)), mp.cos(mp.radians(angle))
        expected |= {
            ("", str(angle), *heads): rounded(value, 4)
            for heads, value in (
                ((along, path, "$x/R$"), 1 - cosine),
                ((along, velocity, "$c_x/v$"), sine),
                ((along, acceleration, "$(p_x R)/v^2$"), cosine),
                ((across, path, "$y/R$"), sine),
                ((across, velocity, "$c_y/v$"), cosine),
                ((across, acceleration, "$(p_y R)/v^2$"), -sine),
            )
        }
    table = kurbel.table(mechanism="parallel", lang=lang)
    assert cells(table) == expected
    assert {"de": "Bei 0° und 180° ", "en": "At 0° and 180° "}[lang] in notes(table)


@pytest.mark.parametrize(("rounding", "half"), [("half-away", 1), ("half-even", 0)])
def test_ties_of_the_parallel_crank_are_rounded_as_asked(rounding: str, half: int) -> None:
    table = kurbel.table(mechanism="parallel", angle=[60, 30, 120], digits=0, rounding=rounding)
    rows = [{field.key: value for field, value in zip(table.records.fields, row, strict=True)}
            for row in table.records.rows]  # fmt: skip
    assert rows[0]["coupler_path"] == rows[1]["coupler_velocity"] == Number(half, 0)
    assert rows[2]["coupler_acceleration"] == Number(-half, 0)
    assert rows[2]["coupler_path"] == Number(2, 0)


# Command line ------------------------------------------------------------------------------------


def test_straight_is_the_default_and_offset_is_straight_with_an_offset() -> None:
    assert printed("table", "--mechanism", "straight").out == printed("table").out
    offset = ("--offset", "0.5", "--ratio", "1:4")
    assert printed("table", "--mechanism", "offset", *offset).out == printed("table", *offset).out


def test_the_layout_tells_the_mechanism() -> None:
    arc = ("--rocker", "6R", "--pivot", "5; 6R")
    assert printed("table", "--layout", "arc", *arc).out == printed(*ARC, "--rocker", "6").out
    assert printed("table", "--layout", "parallel").out == printed("table", "--mechanism", "parallel").out


def test_what_is_typed_goes_before_the_environment() -> None:
    arc = printed(*ARC, "--rocker", "6").out
    crank = {
        "KURBEL_TABLE_BEAM": "3",
        "KURBEL_TABLE_LAYOUT": "forces",
    }
    assert printed(*ARC, "--rocker", "6", **crank).out == arc
    linkage = {"KURBEL_TABLE_MECHANISM": "arc", "KURBEL_TABLE_ROCKER": "6"}
    assert printed("table", **linkage).out == arc
    assert printed("table", "--layout", "kinematics", **linkage).out == printed("table").out
    assert printed("table", "--mechanism", "parallel", **linkage).out.startswith(" Weg, Geschwindigkeit")


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        ("offset", "the offset crank needs the offset e; add --offset, for example --offset 0.5"),
        ("arc", "the arc crank needs the length of its rocker; add --rocker, for example --rocker 6"),
        (
            "ark",
            'there is no mechanism "ark" (did you mean arc?); choose from straight, offset, arc, parallel,'
            " beam",
        ),
        ("straight --rocker 6", "--rocker does not belong to the straight crank; it is for --mechanism arc"),
        (
            "straight --offset 0.5",
            "--offset does not belong to the straight crank; it is for --mechanism offset or arc",
        ),
        (
            "parallel --stroke 1m",
            "--stroke does not belong to the parallel crank, whose page is in units of R and v;"
            " it is for --mechanism straight, offset, arc or beam",
        ),
        (
            "parallel --ratio 1:5",
            "--ratio does not belong to the parallel crank; it is for --mechanism straight, offset, arc or"
            " beam",
        ),
        (
            "arc --rocker 6 --method series",
            'method "series" has no formulas for the arc crank;'
            " use exact, with --ratio 1:∞ for the infinite rod",
        ),
        (
            "arc --rocker 600mm",
            'rocker "600mm" is a length, but no length of the crank is known; add --crank or --stroke, or'
            " give it in units of R, for example 6",
        ),
        ("arc --rocker x", 'rocker "x" is not a number; write it as 4.5 or 4,5'),
        (
            "arc --rocker 6 --pivot 5",
            'pivot "5" is not a place; write its distance from the shaft along and across the slide in units'
            " of R as D;H, for example 5;6",
        ),
        (
            "arc --rocker 2 --pivot 5;0 --ratio 1:3",
            "the pivot is G = 5 R from the shaft, too far for L = 3 R and B = 2 R; the crank turns with G"
            " below L + B - R = 4 R or, the pivot left in place, with a rod or rocker longer by 1.000001 R",
        ),
        (
            "arc --rocker 1",
            "rocker length B is 1 R; it must be longer than the crank radius R, or the crank cannot turn"
            " while the rocker swings",
        ),
        (
            "arc --rocker 6 --offset 1 --pivot 5;6",
            "offset e = 1 R and a height of the pivot were both given; give one, for the height is e + B",
        ),
        ("arc --rocker 6 --columns phi", "there is no column beside the axes; add one, such as path"),
        (
            "parallel --columns phi,y",
            'there is no column "y"; choose from phi, coupler_path, coupler_velocity, coupler_acceleration,'
            " coupler_rise, coupler_rise_velocity, coupler_rise_acceleration, rod_velocity,"
            " rod_acceleration, tangential_force, tangential_force_n, radial_force, radial_force_n, torque,"
            " torque_nm",
        ),
        (
            "arc --layout kinematics --rocker 6",
            "layout kinematics is about something else; choose from arc, forces-arc",
        ),
        (
            "arc --rocker 6 --step 0.001",
            "a page of 1800010 numbers is too long; at most 300000 are set, use -f csv or -f json",
        ),
    ],
)
def test_what_does_not_fit_is_answered_with_a_sentence(words: str, sentence: str) -> None:
    assert refusal("table", "--mechanism", *words.split()) == sentence


def test_a_rocker_without_its_mechanism_is_refused() -> None:
    said = "--rocker does not belong to the straight crank; it is for --mechanism arc"
    assert refusal("table", "--rocker", "6") == said


# Python ------------------------------------------------------------------------------------------


def test_a_page_of_python_is_refused_in_a_sentence() -> None:
    with pytest.raises(ProblemError, match="no crank ratio was given"):
        kurbel.table([], mechanism="arc", rocker=6)
    with pytest.raises(
        KurbelError, match=r'pivot "\(5,\)" is not a place; write its distance from the shaft'
    ):
        kurbel.table(mechanism="arc", rocker=6, pivot=(5,))  # type: ignore[arg-type]
    with pytest.raises(KurbelError, match="layout arc is about something else; choose from forces-par"):
        kurbel.table(mechanism="parallel", layout="arc")


@pytest.mark.parametrize(
    ("subject", "words", "drives"),
    [
        ("arc crank", ("--rocker", "6", "--columns", "velocity"), "arc cranks"),
        ("motion", ("--offset", "0.3", "--columns", "x"), "offset cranks"),
    ],
)
def test_no_angle_of_these_stands_over_its_mirror_image(
    tmp_path: Path, subject: str, words: tuple[str, ...], drives: str
) -> None:
    folder = tmp_path / "gespiegelt"
    folder.mkdir()
    quantity = words[-1]
    (folder / "layout.toml").write_text(
        f"""title = "Gespiegelt"
        caption = "Gespiegelt"
        subject = "{subject}"
        down = ["ratio", "column"]
        stub = ["column"]
        across = ["angle"]
        pairs = true
        ratios = ["1:5"]
        angles = ["10;20"]
        columns = [{{ quantity = "{quantity}" }}]
        """,
        "utf-8",
    )
    given = ("--layouts", str(tmp_path), "--layout", "gespiegelt", "--ratio", "1:5")
    assert refusal("table", *given, *words) == (
        f"layout gespiegelt sets an angle over its mirror image, and {drives} do not stand alike at both;"
        " leave pairs out"
    )
