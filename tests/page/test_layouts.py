"""The shipped layouts: on every page each cell stands under the heads of its own ratio, angle and quantity.

Addresses of cells are spelled out here; what belongs there is asked of `certified` for that ratio and angle
alone. Pages of engines are in test_engine_pages.py.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any, NamedTuple

import pytest
import textbook
from mpmath import mp
from pages import MOTION, Address, cells, default_page, each_layout, shown

from kurbel.drive.crank import Crank
from kurbel.errors import ChoiceError, ProblemError
from kurbel.exact.numerals import Number, number_text
from kurbel.motion import page as motion_page
from kurbel.motion.evaluation import DIFFERENCE, certified
from kurbel.motion.page import RecordRows, Request
from kurbel.motion.quantities import registry
from kurbel.page.build import build
from kurbel.page.layouts import LANGUAGES, layout, layout_names
from kurbel.page.table import DITTO, Table
from kurbel.reading import notation
from kurbel.reading.units import Speed

EIGHTEENTH = [str(angle) for angle in range(0, 181, 10)]


def page(
    name: str, lang: str = "de", ratios: tuple[str, ...] = (), angles: str = "", **choices: Any
) -> Table:
    """Build a layout; what is not given is the layout's own. `crank` holds the fields of Crank."""
    chosen = layout(name)
    crank = choices.pop("crank", {})
    cranks = tuple(Crank(ratio, **crank) for ratio in notation.ratios(ratios or chosen.ratios))
    return build(
        Request(
            layout=chosen,
            cranks=cranks,
            angles=notation.angles((angles,) if angles else chosen.angles),
            lang=lang,
            **choices,
        )
    )


def digits(key: str, method: str, ratio: str, angle: str, decimals: int, **crank: Any) -> str:
    """Return what stands at one point, whatever the page."""
    drive = Crank(notation.ratio(ratio), **crank)
    scaled = certified(registry()[key], method, drive, notation.angle(angle), decimals)
    return number_text(Number(scaled, decimals))


# A column of a page: its quantity, method and decimals, and its heads in German and in English.
class Heads(NamedTuple):
    key: str
    method: str
    decimals: int
    de: Address
    en: Address


def both(key: str, method: str, decimals: int, de: str, en: str) -> Heads:
    return Heads(key, method, decimals, tuple(de.split("|")), tuple(en.split("|")))


FD = "$overline(f d) = overline(f' d')$"
COLUMNS = {
    "blau-kolbenwege": [
        both("x", "series", 3, "Kolbenweg|$x/R$", "Piston path|$x/R$"),
        both("x_stroke", "series", 3, "Kolbenweg|$x/(2 R)$", "Piston path|$x/(2 R)$"),
    ],
    "blau-fd": [
        both("x", "infinite", 4, "$overline(a f) = overline(b f')$", "$overline(a f) = overline(b f')$"),
        both("fd", "exact", 4, f"{FD}|genau", f"{FD}|exact"),
        both("fd", "series", 4, *[f"{FD}|$1/2 · R/L sin^2 α$"] * 2),
        both("x", "exact", 4, "Hingang|$overline(a d)$", "Outstroke|$overline(a d)$"),
        both("x_return", "exact", 4, "Rückgang|$overline(b' d')$", "Return|$overline(b' d')$"),
    ],
    "ordnungen": [
        both(key, method, 5, f"{de} ${symbol}$|{in_german}", f"{en} ${symbol}$|{in_english}")
        for key, symbol, de, en in (
            ("x", "x/R", "Kolbenweg", "Piston path"),
            ("c", "c/v", "Kolbengeschwindigkeit", "Piston velocity"),
            ("p", "(p R)/v^2", "Kolbenbeschleunigung", "Piston acceleration"),
        )
        for method, in_german, in_english in (
            ("exact", "genau", "exact"),
            ("series", "1. Ordnung", "1st order"),
            ("series-3", "3. Ordnung", "3rd order"),
        )
    ],
    "kinematics": [
        both("x", "exact", 4, "Kolbenweg|Hingang|$x/R$", "Piston path|Outstroke|$x/R$"),
        both("x_return", "exact", 4, "Kolbenweg|Rückgang|$x/R$", "Piston path|Return|$x/R$"),
        both("c", "exact", 4, "Kolbengeschwindigkeit|Hingang|$c/v$", "Piston velocity|Outstroke|$c/v$"),
        both("c_return", "exact", 4, "Kolbengeschwindigkeit|Rückgang|$c/v$", "Piston velocity|Return|$c/v$"),
        both(
            "p", "exact", 4,
            "Kolbenbeschleunigung|Hingang|$(p R)/v^2$", "Piston acceleration|Outstroke|$(p R)/v^2$",
        ),
        both(
            "p_return", "exact", 4,
            "Kolbenbeschleunigung|Rückgang|$(p R)/v^2$", "Piston acceleration|Return|$(p R)/v^2$",
        ),
    ],
    "forces": [
        both(key + end, "exact", 4, f"{de}|{stroke}|${letter}$", f"{en}|{in_english}|${letter}$")
        for key, letter, de, en in (
            ("rod_force", "S/F", "Stangenkraft", "Rod force"),
            ("guide_force", "N/F", "Führungsdruck", "Guide force"),
            ("tangential_force", "T/F = M_d/(F R)", "Tangentialkraft und Drehmoment",
             "Tangential force and torque"),
            ("radial_force", "Z/F", "Radialkraft", "Radial force"),
        )
        for end, stroke, in_english in (("", "Hingang", "Outstroke"), ("_return", "Rückgang", "Return"))
    ],
    "kolbenwege": [
        both("x_percent", "exact", 2, "Hingang, $R:L$", "Outstroke, $R:L$"),
        both("x_return_percent", "exact", 2, "Rückgang, $R:L$", "Return stroke, $R:L$"),
    ],
    "lueger-kolbenbewegung": [
        both("x_percent", "exact", 2, "Kolbenweg|in % des Hubes", "Piston path|in % of the stroke"),
        both("p", "series", 4, "$cos α + r/l cos 2 α$", "$cos α + r/l cos 2 α$"),
    ],
    "roetscher-112": [
        both("p", "series", 3, "$cos φ ± {ratio} cos 2 φ$", "$cos φ ± {ratio} cos 2 φ$"),
        both("c", "exact", 3, "$(sin(φ ± ψ))/(cos ψ)$", "$(sin(φ ± ψ))/(cos ψ)$"),
    ],
    "verfahren": [
        both(key, method, 4, f"{de} ${symbol}$|{in_german}", f"{en} ${symbol}$|{in_english}")
        for key, symbol, de, en in (
            ("x", "x/R", "Kolbenweg", "Piston path"),
            ("c", "c/v", "Kolbengeschwindigkeit", "Piston velocity"),
            ("p", "(p R)/v^2", "Kolbenbeschleunigung", "Piston acceleration"),
        )
        for method, in_german, in_english in (
            ("exact", "genau", "exact"),
            ("series", "1. Ordnung", "1st order"),
            (DIFFERENCE, "Unterschied", "Difference"),
        )
    ],
}  # fmt: skip


def grouped(symbol: str) -> Callable[[str, str, Address], Address]:
    """Ratios head groups of rows, angles stand in the stub."""
    return lambda ratio, angle, heads: (f"${symbol} = {ratio}$", angle, *heads)


# Where a point stands: from ratio, angle and the column's heads to the address of its cell.
ADDRESSES: dict[str, Callable[[str, str, Address], Address]] = {
    "blau-fd": grouped("R:L"),
    "blau-kolbenwege": grouped("R:L"),
    "ordnungen": grouped("R:L"),
    "forces": grouped("R:L"),
    "kinematics": grouped("R:L"),
    "kolbenwege": lambda ratio, angle, heads: ("", angle, *heads, f"${ratio}$"),
    "lueger-kolbenbewegung": grouped("r:l"),
    "roetscher-112": lambda ratio, angle, heads: (
        "",
        f"${ratio}$",
        *(head.replace("{ratio}", ratio.replace(":", "/")) for head in heads),
        f"${angle}$",
        f"${mirrored(angle)}$",
    ),
    "verfahren": grouped("R:L"),
}


def mirrored(angle: str) -> str:
    return f"{360 - float(angle):g}"


def expected(name: str, lang: str, ratios: tuple[str, ...], angles: list[str]) -> dict[Address, str]:
    return {
        ADDRESSES[name](ratio, angle, getattr(column, lang)): digits(
            column.key, column.method, ratio, angle, column.decimals
        )
        for column in COLUMNS[name]
        for ratio in ratios
        for angle in angles
    }


each_page = pytest.mark.parametrize(("name", "lang"), [(name, lang) for name in MOTION for lang in LANGUAGES])


@each_page
def test_every_cell_stands_under_its_heads(name: str, lang: str) -> None:
    ratios, angles = ("1:4", "1:3.5", "1:7"), ["17.5", "30.5", "77.5", "123.5"]
    assert cells(page(name, lang, ratios, ";".join(angles))) == expected(name, lang, ratios, angles)


@each_page
def test_defaults_are_the_ratios_and_angles_of_the_layout(name: str, lang: str) -> None:
    table, own = page(name, lang), layout(name)
    ratios, angles = notation.ratios(own.ratios), notation.angles(own.angles)
    assert len(cells(table)) == len(ratios) * len(angles) * len(COLUMNS[name])
    assert cells(table) == cells(default_page(name, lang))


@each_layout
def test_every_layout_builds_with_its_defaults(name: str, lang: str) -> None:
    table = default_page(name, lang)
    named = {"collation": "roetscher-112", "formulas": "blau-equations", "construction": "blau-9"}
    key = named.get(name, name)
    assert (table.lang, table.key, table.layout) == (lang, key, name)
    for text in (table.caption, table.source, *(note.text for note in table.notes)):
        assert "{" not in text


def test_a_single_ratio_stands_in_the_caption_and_heads_no_group() -> None:
    table = page("kinematics", ratios=("1:4,5",), angles="30")
    assert {address[0] for address in cells(table)} == {""}
    assert "$R:L = 1:4.5$" in table.caption
    several = page("kinematics", ratios=("1:4,5", "1:5"), angles="30")
    assert "1:" not in several.caption


# roetscher-112 -----------------------------------------------------------------------------------


def test_roetscher_112_goes_on_in_a_second_block_from_90_to_180() -> None:
    first, second = page("roetscher-112").panels
    assert [column.heading for column in first.columns] == [
        ("$0$", "$360$"), ("$10$", "$350$"), ("$20$", "$340$"), ("$30$", "$330$"), ("$40$", "$320$"),
        ("$50$", "$310$"), ("$60$", "$300$"), ("$70$", "$290$"), ("$80$", "$280$"),
    ]  # fmt: skip
    assert [column.heading for column in second.columns] == [
        (f"${angle}$", f"${360 - angle}$") for angle in range(90, 181, 10)
    ]
    for panel in (first, second):
        assert [stub.heading for stub in panel.stub] == [("$R/L$",), ("$φ =$",)]
        assert [row.stub[0].value for row in panel.rows()] == [
            "$1:5$", DITTO, "$1:4.5$", DITTO, "$1:4$", DITTO,
        ]  # fmt: skip
        assert [len(group.rows) for group in panel.groups] == [2, 2, 2]


def test_roetscher_112_has_the_value_of_a_point_that_anyone_can_look_up() -> None:
    found = cells(page("roetscher-112"))
    # cos 30° + ¼ cos 60° and sin(30° + ψ)/cos ψ, sin ψ = ⅛.
    assert found["", "$1:4$", "$cos φ ± 1/4 cos 2 φ$", "$30$", "$330$"] == "0.991"
    assert found["", "$1:4$", "$(sin(φ ± ψ))/(cos ψ)$", "$30$", "$330$"] == "0.609"
    assert found["", "$1:4.5$", "$cos φ ± 1/4.5 cos 2 φ$", "$90$", "$270$"] == "-0.222"


def test_blocks_are_as_few_as_needed() -> None:
    for angles, sizes in (("0..90:10", [10]), ("0..180:5", [9, 9, 9, 10]), ("0..100:10", [5, 6])):
        assert [len(panel.columns) for panel in page("roetscher-112", angles=angles).panels] == sizes


# kolbenwege --------------------------------------------------------------------------------------


def test_kolbenwege_has_a_column_for_each_ratio_on_either_stroke() -> None:
    (panel,) = page("kolbenwege").panels
    ratios = ["$1:3$", "$1:3.5$", "$1:4$", "$1:4.5$", "$1:5$", "$1:6$", "$1:∞$"]
    assert [column.heading[-1] for column in panel.columns] == ratios * 2
    spanners = [column.spanners for column in panel.columns]
    assert spanners == [("Hingang, $R:L$",)] * 7 + [("Rückgang, $R:L$",)] * 7
    assert [shown(row.stub[0].value) for row in panel.rows()] == EIGHTEENTH


def test_kolbenwege_of_an_infinite_rod_are_the_same_on_both_strokes() -> None:
    found = cells(page("kolbenwege"))
    for angle in EIGHTEENTH:
        out, back = (found["", angle, stroke, "$1:∞$"] for stroke in ("Hingang, $R:L$", "Rückgang, $R:L$"))
        assert out == back


# kinematics --------------------------------------------------------------------------------------

MACHINE = {"radius": Fraction(3, 10), "speed": Speed(Fraction(2))}


def test_kinematics_has_a_group_for_each_ratio() -> None:
    (panel,) = page("kinematics", ratios=("1:4", "1:5", "0.3")).panels
    assert [group.label for group in panel.groups] == ["$R:L = 1:4$", "$R:L = 1:5$", "$R:L = 3:10$"]
    assert [[shown(row.stub[0].value) for row in group.rows] for group in panel.groups] == [EIGHTEENTH] * 3


def test_kinematics_with_units_has_them_in_place_of_the_ratios() -> None:
    found = cells(page("kinematics", ratios=("1:5",), angles="35;250", crank=MACHINE))
    heads = {
        "x_mm": ("Kolbenweg", "Hingang", "$x$ in mm"),
        "x_return_mm": ("Kolbenweg", "Rückgang", "$x$ in mm"),
        "c_mps": ("Kolbengeschwindigkeit", "Hingang", "$c$ in m/s"),
        "c_return_mps": ("Kolbengeschwindigkeit", "Rückgang", "$c$ in m/s"),
        "p_mps2": ("Kolbenbeschleunigung", "Hingang", "$p$ in m/s²"),
        "p_return_mps2": ("Kolbenbeschleunigung", "Rückgang", "$p$ in m/s²"),
    }
    assert len(found) == 2 * 6
    for angle in ("35", "250"):
        for key, spanners in heads.items():
            decimals = registry()[key].decimals
            assert decimals is not None
            assert found["", angle, *spanners] == digits(key, "exact", "1:5", angle, decimals, **MACHINE)


def test_a_length_without_a_speed_brings_millimetres_only() -> None:
    found = cells(page("kinematics", angles="35", crank={"radius": Fraction(3, 10)}))
    heads = ["$x$ in mm"] * 2 + ["$c/v$"] * 2 + ["$(p R)/v^2$"] * 2
    assert [address[-1] for address in found] == heads


def test_machine_is_stated_with_mean_piston_speed() -> None:
    # c_m = S n/30 = 0.6 · 120/30 m/s, v = R ω = 0.3 · 4π m/s.
    line = page("kinematics", ratios=("1:5",), crank=MACHINE).notes[-1].text
    assert line == (
        '$R = 300 "mm"$, $L = 1500 "mm"$; $n = 120 "min"^(-1)$, $v = 3.770 "m/s"$,'
        ' mittlere Kolbengeschwindigkeit $c_m = 2.400 "m/s"$, $v:c_m = π:2$'
    )
    crank = MACHINE | {"speed": Speed(Fraction(5, 2), turns=False), "offset": Fraction(1, 2)}
    line = page("kinematics", "en", ratios=("1:4",), crank=crank).notes[-2].text
    assert line == (
        '$R = 300 "mm"$, $L = 1200 "mm"$; $ω = 2.5 "rad/s"$, $v = 0.750 "m/s"$,'
        f' mean piston speed $c_m = {of_stroke(lambda s: s * 0.75 / mp.pi, 3)} "m/s"$,'
        f" $v:c_m = {of_stroke(lambda s: mp.pi / s, 4)}$"
    )


def of_stroke(formula: Callable[[Any], Any], decimals: int) -> str:
    """A number that depends on the stroke of the crank R:L = 1:4, e = R/2."""
    with mp.workprec(200):
        value = textbook.rounded(formula(textbook.stroke(OFFSET)), decimals, bits=200)
    assert value is not None
    return textbook.printed(value, decimals)


OFFSET = textbook.Drive(Fraction(1, 4), Fraction(1, 2))


def test_offset_crank_states_its_dead_centres_and_stroke() -> None:
    with mp.workprec(200):
        inner = mp.asin(mp.mpf(1) / 2 / 5) * 180 / mp.pi
        outer = 180 + mp.asin(mp.mpf(1) / 2 / 3) * 180 / mp.pi
        places = [textbook.rounded(angle, 3, bits=200) for angle in (inner, outer)]
    assert places == [5739, 189594]
    assert of_stroke(lambda s: s, 4) == "2.0169"
    table = page("kinematics", ratios=("1:4",), crank={"offset": Fraction(1, 2)})
    assert [note.text for note in table.notes] == [
        "$x/R = (cos φ_i - cos φ) + (cos ψ_i - cos ψ)/λ$, $c/v = sin φ + cos φ tan ψ$,"
        " $(p R)/v^2 = cos φ - sin φ tan ψ + λ (cos^2 φ)/(cos^3 ψ)$, $sin ψ = λ (sin φ - e/R)$, $λ = R/L$",
        "Rückgang bei $180° + φ$, vom äußeren Totpunkt und in Richtung des Rückgangs gerechnet",
        "Geschränkt, $e = 0.5 R$, $R:L = 1:4$: Totlagen $φ_i = 5.739°$ und $φ_o = 189.594°$, Hub $2.0169 R$",
    ]


# Formulas below the page -------------------------------------------------------------------------

FORMULAS = {
    "exact": (
        "$x/R = 1 - cos φ ± (1 - cos ψ)/λ$, $c/v = sin φ ± (λ sin φ cos φ)/(cos ψ)$,"
        " $(p R)/v^2 = cos φ ± λ (cos 2 φ + λ^2 sin^4 φ)/(cos^3 ψ)$, $sin ψ = λ sin φ$, $λ = R/L$"
    ),
    "series": (
        "$x/R = 1 - cos φ ± 1/2 λ sin^2 φ$, $c/v = sin φ ± 1/2 λ sin 2 φ$,"
        " $(p R)/v^2 = cos φ ± λ cos 2 φ$, $λ = R/L$"
    ),
    "infinite": "$x/R = 1 - cos φ$, $c/v = sin φ$, $(p R)/v^2 = cos φ$",
}


@pytest.mark.parametrize("method", FORMULAS)
def test_page_states_the_formulas_of_its_method(method: str) -> None:
    table = page("kinematics", method=method)
    signs = ["oberes Zeichen: Hingang, unteres Zeichen: Rückgang"] if method != "infinite" else []
    assert [note.text for note in table.notes] == [FORMULAS[method], *signs]
    named = {
        "exact": "genaue Formeln",
        "series": "Näherung erster Ordnung",
        "infinite": "unendlich lange Schubstange",
    }
    assert table.caption.endswith(f"; {named[method]}")
    (_, digits_of_x), *_ = cells(page("kinematics", method=method, angles="60", columns=("x",))).items()
    assert digits_of_x == {"exact": "0.5756", "series": "0.5750", "infinite": "0.5000"}[method]


def test_outstroke_alone_has_no_double_sign() -> None:
    (note,) = page("kinematics", "en", columns=("phi", "c")).notes
    assert note.text == "$c/v = sin φ + (λ sin φ cos φ)/(cos ψ)$, $sin ψ = λ sin φ$, $λ = R/L$"


def test_verfahren_states_both_methods_and_where_the_difference_comes_from() -> None:
    texts = [note.text for note in page("verfahren").notes]
    assert texts == [
        "Unterschied: genauer Wert weniger Näherung, vor dem Runden gebildet.",
        "genaue Formeln: " + FORMULAS["exact"].replace("±", "+"),
        "Näherung erster Ordnung: " + FORMULAS["series"].replace("±", "+"),
    ]
    found = cells(page("verfahren", angles="20"))
    assert found["", "20", "Kolbengeschwindigkeit $c/v$", "Unterschied"] == "0.0002"


def test_lueger_has_the_letters_of_its_source_in_every_line() -> None:
    table = page("lueger-kolbenbewegung")
    assert [note.text for note in table.notes] == [
        "genaue Formeln: $x/R = 1 - cos α + (1 - cos ψ)/λ$, $sin ψ = λ sin α$, $λ = r/l$",
        "Näherung erster Ordnung: $(p R)/v^2 = cos α + λ cos 2 α$, $λ = r/l$",
    ]
    assert [stub.heading for panel in table.panels for stub in panel.stub] == [("$α$ in °",)]


@pytest.mark.parametrize("name", [name for name in MOTION if layout(name).fixed])
def test_page_whose_heads_state_formulas_takes_no_method(name: str) -> None:
    for method in FORMULAS:
        with pytest.raises(ProblemError) as caught:
            page(name, method=method)
        assert str(caught.value) == (
            f"layout {name} states its formulas in its heads and takes no method;"
            " use --layout kinematics to choose one"
        )
    with pytest.raises(ChoiceError):
        page(name, columns=("phi", "psi"))


def test_fixed_layouts_are_those_whose_heads_state_every_formula() -> None:
    assert [name for name in layout_names() if layout(name).fixed] == [
        "blau-fd",
        "blau-kolbenwege",
        "delta-verfahren",
        "forces-verfahren",
        "ordnungen",
        "roetscher-112",
        "verfahren",
    ]


# Columns, angles, records ------------------------------------------------------------------------


def test_columns_are_picked_and_ordered() -> None:
    table = page("kinematics", angles="35", columns=("c_return", "phi", "psi", "x"))
    assert [address[2:] for address in cells(table)] == [
        ("Kolbengeschwindigkeit", "Rückgang", "$c/v$"),
        ("Schubstangenwinkel", "Hingang", "$ψ$ in °"),
        ("Kolbenweg", "Hingang", "$x/R$"),
    ]
    assert [field.key for field in table.records.fields] == ["c_return", "phi", "psi", "x"]
    assert table.caption.startswith("Kolbengeschwindigkeit, Schubstangenwinkel und Kolbenweg für")


def test_a_fixed_page_gives_its_own_columns_in_any_order() -> None:
    found = cells(page("verfahren", angles="60", columns=("p_series", "x_exact")))
    asked = (("p", "series"), ("x", "exact"))
    assert list(found.values()) == [digits(key, method, "1:5", "60", 4) for key, method in asked]


def test_columns_need_a_quantity_and_what_it_is_measured_in() -> None:
    for columns, sentence in (
        (("phi", "ratio"), "--columns names no quantity; add one, for example --columns phi,x,c,p"),
        (("x_mm",), "column x_mm is in mm and needs --stroke"),
        (("x", "c_return_mps"), "column c_return_mps is in m/s and needs --stroke and --speed"),
    ):
        with pytest.raises(ProblemError) as caught:
            page("kinematics", columns=columns)
        assert str(caught.value) == sentence


@each_page
def test_records_have_the_ratio_the_angle_and_the_columns(name: str, lang: str) -> None:
    table = page(name, lang, ratios=("1:4,5", "1:7"), angles="20;100")
    own = [column.key for column in layout(name).columns if registry()[column.quantity].needs == ""]
    assert [field.key for field in table.records.fields] == ["ratio", "phi", *own]
    records = list(table.records.rows)
    assert [(row[0], shown(row[1])) for row in records] == [
        (f"${ratio}$", angle) for ratio in ("1:4.5", "1:7") for angle in ("20", "100")
    ]
    points = [(ratio, angle) for ratio in ("2:9", "1:7") for angle in ("20", "100")]
    for row, (ratio, angle) in zip(records, points, strict=True):
        assert [shown(value) for value in row[2:]] == [
            digits(column.key, column.method, ratio, angle, column.decimals) for column in COLUMNS[name]
        ]


def test_columns_that_a_layout_adds_have_keys_of_their_own() -> None:
    assert motion_page.MOTION.column_keys(layout("verfahren"))[2:] == tuple(
        f"{key}_{method}" for key in "xcp" for method in ("exact", "series", "difference")
    )
    assert "p_bracket" in motion_page.MOTION.column_keys(layout("lueger-kolbenbewegung"))
    assert motion_page.MOTION.column_keys(layout("kinematics"))[:2] == ("ratio", "phi")
    assert set(registry()) < set(motion_page.MOTION.column_keys(layout("kinematics")))


def test_angles_are_printed_as_they_are() -> None:
    for angles, heads in (
        ("11.25;22.5;180", ["11.25", "22.50", "180.00"]),
        ("0°20';45", ["$0°20'$", "$45°0'$"]),
        ("30°15'", ["30.25"]),
        ("0..1:0°20'", ["$0°0'$", "$0°20'$", "$0°40'$", "$1°0'$"]),
    ):
        assert [address[1] for address in cells(page("kinematics", angles=angles, columns=("x",)))] == heads


def test_digits_go_for_every_column() -> None:
    found = cells(page("lueger-kolbenbewegung", angles="77", digits=30))
    asked = (("x_percent", "exact"), ("p", "series"))
    assert list(found.values()) == [digits(key, method, "1:5", "77", 30) for key, method in asked]


def test_a_page_that_nobody_could_print_is_refused_but_its_records_are_not() -> None:
    own = layout("kinematics")
    angles = notation.progression(Fraction(0), Fraction(360), Fraction(360, 100_000))
    request = Request(
        layout=own, cranks=(Crank(Fraction(1, 5)),), angles=angles, columns=("phi", "x", "c", "p")
    )
    with pytest.raises(ProblemError) as caught:
        build(request)
    sentence = "a page of 300003 numbers is too long; at most 300000 are set, use -f csv or -f json"
    assert str(caught.value) == sentence
    rows = build(request, pages=False).records.rows
    assert isinstance(rows, RecordRows)
    assert len(rows) == 100_001
    assert [shown(value) for value in next(iter(rows))] == ["0.0000", "0.0000", "0.0000", "1.2000"]


def test_a_page_with_too_many_ratios_across_is_refused() -> None:
    assert len(page("kolbenwege", ratios=("1:3..252",), angles="30").panels[0].columns) == 500
    with pytest.raises(ProblemError) as caught:
        page("kolbenwege", ratios=("1:3..253",), angles="30")
    sentence = "a page of 502 columns is too wide; at most 500 are set, use -f csv or -f json"
    assert str(caught.value) == sentence


@pytest.mark.parametrize(
    ("crank", "ratio", "expected"),
    [
        # c_m = S n/30 = 0.075 · 125/30 = 0.3125 m/s, a tie at three decimals.
        ({"radius": Fraction(75, 2000), "speed": Speed(Fraction(125, 60))}, "1:5", '$c_m = 0.313 "m/s"$'),
        # v = R ω = 0.3 · 12.345 = 3.7035 m/s, another.
        (
            {"radius": Fraction(3, 10), "speed": Speed(Fraction(12345, 1000), turns=False)},
            "1:5",
            '$v = 3.704 "m/s"$',
        ),
        ({"radius": Fraction(93, 2000), "speed": Speed(Fraction(2005, 60))}, "1:4", '$c_m = 6.216 "m/s"$'),
    ],
)
def test_ties_in_the_notes_are_settled(crank: dict[str, Any], ratio: str, expected: str) -> None:
    assert expected in page("kinematics", ratios=(ratio,), angles="90", crank=crank).notes[-1].text


def test_pairs_of_angles_stand_once_and_below_180() -> None:
    table = page("roetscher-112", angles="200;160;-20;380;0;360")
    headings = [column.heading for panel in table.panels for column in panel.columns]
    assert headings == [("$160$", "$200$"), ("$20$", "$340$"), ("$0$", "$360$")]


def test_ratios_of_an_infinite_rod_are_one() -> None:
    table = page("kolbenwege", method="infinite", angles="90")
    assert [len(panel.columns) for panel in table.panels] == [2]


def test_label_names_the_table_and_keeps_the_templates_of_its_layout() -> None:
    own = layout("kinematics")
    request = Request(
        layout=own, cranks=(Crank(Fraction(1, 5)),), angles=notation.angles(["90"]), label="eins"
    )
    assert (build(request).key, build(request).layout) == ("eins", "kinematics")
