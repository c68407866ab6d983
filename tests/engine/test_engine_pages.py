"""Pages about engines: each cell stands under the heads of its own engine, stroke, angle and flywheel.

Addresses are spelled out here; what belongs there is the record of that engine, whose digits
test_cli_engine.py compares with the quadrature.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import cache
from typing import Any, NamedTuple

import pytest
from cli import printed, records, refusal
from pages import ENGINES, Address, cells, page_of, shown

import kurbel
from kurbel.exact.numerals import degrees_text
from kurbel.formats.render import render
from kurbel.page.layouts import LANGUAGES, layout
from kurbel.page.subject import subject
from kurbel.page.table import Table

# So small that no number has five digits, which pages would have in larger units (tests/page).
TASK = {"power": 5_000, "speed": 2, "delta": "1:50;1:100", "radius": 1.5}
MACHINE = {
    "stroke": 0.6, "bore": 0.3, "pressure": 80_000, "speed": 2, "reciprocating": 30, "rod_mass": 15,
    "centre": "0.6", "gyration": "0.3",
}  # fmt: skip
QR, PR = "$(Q r)/(m_1 v_1^2)$", "$(P r)/(m_1 v_1^2)$"


class Head(NamedTuple):
    """What stands at a row or over a column in German and in English, and the unit of a row."""

    de: Address
    en: Address
    unit: Address = ()


def head(de: str, en: str, *unit: str) -> Head:
    return Head(tuple(de.split("|")), tuple(en.split("|")), unit)


DELTA = head("Ungleichförmigkeitsgrad $δ$", "Degree of irregularity $δ$", PR)
LOW, HIGH = '$v_"min"/v_1 - 1$', '$v_"max"/v_1 - 1$'
HEADS: Mapping[str, Mapping[str, Head]] = {
    "weisbach-150": {"delta": DELTA},
    "delta-tafel": {"delta": head("Ungleichförmigkeitsgrad $δ$, $r:l$", "Degree of irregularity $δ$, $r:l$")},
    "delta-verfahren": {
        f"{kind}_{method}": head(f"{de}|{of}", f"{en}|{of_en}")
        for kind, de, en in (
            ("delta", "Ungleichförmigkeitsgrad $δ$", "Degree of irregularity $δ$"),
            ("difference", "Unterschied gegen genau", "Difference from exact"),
        )
        for method, of, of_en in (
            ("exact", "genau", "exact"),
            ("series", "1. Ordnung", "1st order"),
            ("weisbach", "Weisbach", "Weisbach"),
        )
        if (kind, method) != ("difference", "exact")
    },
    "delta-detail": {
        "mean_force": head("mittlere Umfangskraft $P$", "Mean tangential force $P$", "$Q$"),
        "alpha_cutoff": head("Absperrung bei $α_ε$", "Cut-off at $α_ε$", ""),
        "alpha_min": head("kleinste Geschwindigkeit bei $α_1$", "Least speed at $α_1$", ""),
        "v_min": head(f"kleinste Geschwindigkeit {LOW}", f"Least speed {LOW}", QR),
        "alpha_max": head("größte Geschwindigkeit bei $α_2$", "Greatest speed at $α_2$", ""),
        "v_max": head(f"größte Geschwindigkeit {HIGH}", f"Greatest speed {HIGH}", QR),
        "delta": DELTA,
    },
    "turning": {
        "tangential": head("Tangentialkraft|$T/Q$", "Tangential force|$T/Q$"),
        "mean_force": head("mittlere|$P/Q$", "Mean|$P/Q$"),
        "tangential_excess": head("Überschuss|$T/Q - P/Q$", "Excess|$T/Q - P/Q$"),
        "energy": head("Überschussarbeit|$W/(Q r)$", "Excess energy|$W/(Q r)$"),
    },
    "speed": {
        "tangential": head("Tangentialkraft|$T/Q$", "Tangential force|$T/Q$"),
        "energy": head("Überschussarbeit|$W/(Q r)$", "Excess energy|$W/(Q r)$"),
        "speed": head("Geschwindigkeit|$v/v_1$", "Velocity|$v/v_1$"),
        "rpm": head('Drehzahl|$n$ in $"min"^(-1)$', 'Speed|$n$ in $"min"^(-1)$'),
        "time": head("Zeit|$t$ in s", "Time|$t$ in s"),
    },
    "delta-flywheel": {
        key: head(f"{de}|${symbol}$", f"{en}|${symbol}$")
        for key, symbol, de, en in (
            ("speed_min", 'v_"min"/v_1', "Geschwindigkeit", "Velocity"),
            ("speed_max", 'v_"max"/v_1', "Geschwindigkeit", "Velocity"),
            ("delta_mean", "δ_m", "auf das Mittel bezogen", "By the mean speed"),
            ("one_to_mean", "1/δ_m", "auf das Mittel bezogen", "By the mean speed"),
            ("delta_first", "δ_1", "nach Weisbach", "By Weisbach"),
            ("one_to_first", "1/δ_1", "nach Weisbach", "By Weisbach"),
        )
    },
    "turning-path": {
        "pin_path": head("Weg des Kurbelzapfens|$s/r$", "Path of the crank pin|$s/r$"),
        "tangential": head("Tangentialkraft|$T/Q$", "Tangential force|$T/Q$"),
        "mean_force": head("mittlere|$P/Q$", "Mean|$P/Q$"),
        "tangential_excess": head("Überschuss|$T/Q - P/Q$", "Excess|$T/Q - P/Q$"),
        "energy": head("Überschussarbeit|$W/(Q r)$", "Excess energy|$W/(Q r)$"),
    },
    "engine-forces": {
        key: head(f"{de}|${letter}/Q$", f"{en}|${letter}/Q$")
        for key, letter, de, en in (
            ("piston_force", "F", "Kolbenkraft", "Piston force"),
            ("rod_force", "S", "Stangenkraft", "Rod force"),
            ("guide_force", "N", "Führungsdruck", "Guide force"),
            ("tangential_force", "T", "Tangentialkraft", "Tangential force"),
            ("radial_force", "Z", "Radialkraft", "Radial force"),
        )
    },
    "machine-forces": {
        key: head(f"{de}|${letter}$ in {unit}", f"{en}|${letter}$ in {unit}")
        for key, letter, de, en, unit in (
            ("piston_force_n", "F", "Kolben", "Piston", "N"),
            ("rod_force_n", "S", "Stange", "Rod", "N"),
            ("guide_force_n", "N", "Führung", "Guide", "N"),
            ("crank_pin_force_n", "K", "Kurbelzapfen", "Crank pin", "N"),
            ("tangential_force_n", "T", "Kurbelzapfen", "Crank pin", "N"),
            ("radial_force_n", "Z", "Kurbelzapfen", "Crank pin", "N"),
            ("bearing_along_n", "H_x", "Hauptlager", "Main bearing", "N"),
            ("bearing_across_n", "H_y", "Hauptlager", "Main bearing", "N"),
            ("torque_nm", "M_d", "Drehmoment", "Torque", "N m"),
        )
    },
    "rod-load": {
        "thrust": head('größter Druck $S_"max"$', 'Greatest thrust $S_"max"$', "$Q$"),
        "phi_thrust": head("größter Druck bei $φ$", "Greatest thrust at $φ$", ""),
        "pull": head('größter Zug $-S_"min"$', 'Greatest pull $-S_"min"$', "$Q$"),
        "phi_pull": head("größter Zug bei $φ$", "Greatest pull at $φ$", ""),
        "thrust_angle": head("Druck über", "Thrust over", "°"),
        "pull_angle": head("Zug über", "Pull over", "°"),
        "reversal_angle": head("Richtungswechsel über", "Reversal over", "°"),
        "reversal_unbroken": head("davon am Stück", "longest unbroken", "°"),
        "reversal_share": head("Gegenlast, Anteil der größten", "Reversed load, share of the greatest", "%"),
    },
    "rod-load-turn": {
        key: head(f"{de}|${letter}$ in N", f"{en}|${letter}$ in N")
        for key, letter, de, en in (
            ("piston_force_n", "F", "Kolbenkraft", "Piston force"),
            ("inertia_force_n", "F_m", "Massenkraft", "Inertia force"),
            ("crosshead_load_n", "F_B", "Kreuzkopfzapfen", "Crosshead pin"),
            ("rod_force_n", "S", "Stange am Kreuzkopf", "Rod at the crosshead"),
            ("pin_rod_force_n", "S_A", "Stange an der Kurbel", "Rod at the crank"),
        )
    },
    "flywheel": {
        "power": head("Leistung $N$", "Power $N$", "W"),
        "speed": head("Drehzahl $n$", "Speed $n$", '$"min"^(-1)$'),
        "omega": head("Winkelgeschwindigkeit $ω$", "Angular velocity $ω$", "rad/s"),
        "mean_torque": head("mittleres Drehmoment $P r$", "Mean torque $P r$", "N m"),
        "swing_share": head("Arbeitsüberschuss $(ΔW)/(P r)$", "Energy swing $(ΔW)/(P r)$", ""),
        "swing": head("Arbeitsüberschuss $ΔW$", "Energy swing $ΔW$", "J"),
        "inertia": head("Trägheitsmoment $J$", "Moment of inertia $J$", "kg m²"),
        "mass": head("Schwungmasse am Halbmesser $J/ρ^2$", "Mass at the radius $J/ρ^2$", "kg"),
    },
}
STROKES = {
    "outstroke": {"de": "Hingang", "en": "Outstroke"},
    "return": {"de": "Rückgang", "en": "Return"},
    "turn": {"de": "Umdrehung", "en": "Whole turn"},
}
ENDS = {
    "slide": {"de": "Kreuzkopfzapfen", "en": "Crosshead pin"},
    "crosshead": {"de": "Stange am Kreuzkopf", "en": "Rod at the crosshead"},
    "crank": {"de": "Stange an der Kurbel", "en": "Rod at the crank"},
}


# Records have the number, pages what was written.
TARGETS = {"0.02": "$1:50$", "0.01": "$1:100$"}


class Point(NamedTuple):
    """What a record says of itself; `inner` is its stroke, angle, end of the rod or flywheel."""

    epsilon: str
    ratio: str
    inner: str

    @property
    def engine(self) -> str:
        return f"$ε = {self.epsilon.removesuffix('.0')}$, $r:l = {self.ratio.strip('$')}$"

    @property
    def drive(self) -> str:
        return f"$r:l = {self.ratio.strip('$')}$"


# From a record, its column's heads, the unit and the language to the address of the cell.
ADDRESSES: Mapping[str, Callable[[Point, Address, Address, str], Address]] = {
    "weisbach-150": lambda at, label, unit, lang: (
        at.drive, *label, f"${at.epsilon.removesuffix('.0')}$", *unit,
    ),
    "delta-tafel": lambda at, label, unit, lang: ("", at.epsilon, *label, at.ratio),
    "delta-verfahren": lambda at, label, unit, lang: (at.drive, at.epsilon, *label),
    "delta-detail": lambda at, label, unit, lang: (at.engine, *label, STROKES[at.inner][lang], *unit),
    "delta-flywheel": lambda at, label, unit, lang: (at.drive, at.epsilon, *label),
    **dict.fromkeys(
        ("turning", "turning-path", "speed", "engine-forces", "machine-forces", "rod-load-turn"),
        lambda at, label, unit, lang: (at.engine, at.inner, *label),
    ),
    "rod-load": lambda at, label, unit, lang: (at.engine, *label, ENDS[at.inner][lang], *unit),
    "flywheel": lambda at, label, unit, lang: (at.engine, *label, TARGETS[at.inner], *unit),
}  # fmt: skip


@cache
def page(name: str, lang: str = "de", **choices: Any) -> Table:
    """A page of four engines, with more digits than a minute of arc needs."""
    own: dict[str, Any] = {"eps": "2;3.5", "ratio": "1:4;1:7", "digits": 8, "back": "0.1"}
    if name == "flywheel":
        own |= TASK
    if layout(name).subject == "machine":
        own |= MACHINE
    if "phi" in subject(layout(name).subject).axis_keys:
        own["angle"] = "17;77;302"
    return page_of(name, lang=lang, **(own | choices))


def expected(name: str, lang: str, table: Table) -> dict[Address, str]:
    """Return what stands where, by the table's records."""
    keys = [field.key for field in table.records.fields]
    found = {}
    for row in table.records.rows:
        record = dict(zip(keys, row, strict=True))
        axes = [record[key] for key in keys if key not in HEADS[name]]
        at = Point(*(shown(value) for value in (*axes, "")[:3]))
        for key, heads in HEADS[name].items():
            value = record[key]
            if key.startswith(("alpha", "phi_")) and value is not None:
                text = f"${degrees_text(Fraction(round(60 * Fraction(shown(value))), 60))}$"
            else:
                text = shown(value)
            found[ADDRESSES[name](at, getattr(heads, lang), heads.unit, lang)] = text
    return found


@pytest.mark.parametrize("lang", LANGUAGES)
@pytest.mark.parametrize("name", ENGINES)
def test_every_cell_stands_under_its_heads_and_is_that_of_its_record(name: str, lang: str) -> None:
    table = page(name, lang=lang)
    found = cells(table)
    assert found == expected(name, lang, table)
    assert len(set(found.values())) > 3


@pytest.mark.parametrize("name", ENGINES)
def test_a_single_engine_stands_in_the_caption_and_heads_no_group(name: str) -> None:
    table = page(name, eps="3.5", ratio="1:4")
    assert {group.label for panel in table.panels for group in panel.groups} == {""}
    text = render(table, "text", decimal="point")
    assert "1:4" in text
    assert "3.5" in text
    shown_in_heads = {*layout(name).across, *layout(name).stub}
    assert ("$ε = 3.5$" in table.caption) == ("expansion" not in shown_in_heads)
    assert ("$r:l = 1:4$" in table.caption) == ("ratio" not in shown_in_heads)


@pytest.mark.parametrize("name", ["delta-detail", "turning", "flywheel"])
def test_groups_are_headed_by_what_differs_and_the_rest_is_told_in_the_caption(name: str) -> None:
    for choices, heads, told in (
        ({"ratio": "1:4"}, ["$ε = 2$", "$ε = 3.5$"], "$r:l = 1:4$"),
        ({"eps": "3.5"}, ["$r:l = 1:4$", "$r:l = 1:7$"], "$ε = 3.5$"),
    ):
        table = page(name, **choices)
        assert [group.label for panel in table.panels for group in panel.groups] == heads
        assert told in table.caption
        assert not any(label in table.caption for label in heads)


@pytest.mark.parametrize("name", ENGINES)
def test_several_engines_are_not_told_in_the_caption(name: str) -> None:
    caption = page(name, lang="de").caption
    assert "3.5" not in caption
    assert "1:" not in caption


def test_the_turn_takes_its_extremes_from_its_strokes() -> None:
    found = cells(page("delta-detail", eps="3.5", ratio="1:4"))
    low, high = f"kleinste Geschwindigkeit {LOW}", f"größte Geschwindigkeit {HIGH}"
    out, back, turn = ([float(found["", row, stroke, QR]) for row in (low, high)] for stroke in (
        "Hingang", "Rückgang", "Umdrehung",
    ))  # fmt: skip
    assert turn == [min(out[0], back[0]), max(out[1], back[1])]
    delta = float(found["", "Ungleichförmigkeitsgrad $δ$", "Umdrehung", PR])
    force = float(found["", "mittlere Umfangskraft $P$", "Umdrehung", "$Q$"])
    assert abs(delta - (turn[1] - turn[0]) / force) < 1e-6


@pytest.mark.parametrize(("ratio", "marks"), [("1:4", 2), ("1:∞", 4)])
def test_marks_stand_at_the_extremes_of_the_turn(ratio: str, marks: int) -> None:
    # With an infinite rod both strokes are alike, and all four extremes make δ.
    table = page("delta-detail", eps="3", ratio=ratio)
    marked = [
        (panel.columns[place].heading, row.cells[place].value)
        for panel in table.panels
        for row in panel.rows()
        for place in range(len(row.cells))
        if row.cells[place].notes
    ]
    assert len(marked) == marks
    found = cells(table)
    turn = {found["", f"{word} Geschwindigkeit {what}", "Umdrehung", QR]
            for word, what in (("kleinste", LOW), ("größte", HIGH))}  # fmt: skip
    assert {shown(value) for _, value in marked} == turn


def test_expansions_without_a_finite_decimal_are_printed_as_fractions() -> None:
    table = kurbel.delta([Fraction(7, 3), 2], layout="delta-tafel", ratio="1:4;1:5")
    assert [row[0] for row in table.records.rows][::2] == ["$7/3$", "$2$"]
    (group,) = table.panels[0].groups
    assert [row.stub[0].value for row in group.rows] == ["$7/3$", "$2$"]


@pytest.mark.parametrize("command", ["delta", "turning", "forces"])
def test_every_column_that_can_be_asked_for_is_printed(command: str) -> None:
    """Alone, of an engine of which everything is known, in the records and on the page."""
    sizes = ("--stroke=600mm", "--bore=300mm", "--pressure=80kPa", "--speed=120/min", "--ratio=1:4")
    weights = ("--reciprocating=30kg", "--rod-mass=15kg", "--centre=0.6", "--gyration=0.3")
    engine = (command, "--eps=3", *sizes, *weights)
    names = refusal(*engine, "--columns=no-such").partition("; choose from ")[2].split(", ")
    assert len(names) > 15
    axes = {
        "epsilon",
        "ratio",
        "phi",
        "stroke",
        "volumetric_efficiency",
        "delivered",
        "delivery",
        "efficiency",
    }
    for name in sorted({*names} - axes):
        words = (*engine, f"--columns={name}", *(() if command == "delta" else ("--step=90",)))
        rows = records(*words)
        assert [*rows[0]][-1] == name
        numbers = [row[name] for row in rows if row[name]]
        assert numbers
        page = printed(*words, "--decimal=point").out
        if "°" not in page:
            assert all(number.replace("-", "−") in page for number in numbers)


OBLIQUE = (("--offset=0.5",), ("--mechanism=arc", "--rocker=5"), ("--mechanism=beam", "--beam=4"))


@pytest.mark.parametrize("drive", OBLIQUE, ids=str)
def test_alpha_counts_as_the_note_says_in_each_stroke_and_in_the_turn(drive: tuple[str, ...]) -> None:
    engine, places = ("--ratio=1:5", "--eps=4", *drive), ("--columns=phi_i,phi_o", "--digits=9", "-f", "csv")
    inner, outer = printed("deadcentres", "--ratio=1:5", *drive, *places).records()[0].values()
    zero = {"outstroke": Fraction(inner), "return": Fraction(outer), "turn": Fraction(inner)}
    speeds = ("delta", "--detail", *engine, "--columns=stroke,alpha_min,alpha_max", "-f", "csv", "--digits=9")
    records = printed(*speeds).records()
    assert [one["stroke"] for one in records] == [*zero]
    angles = [
        str(float(Fraction(one[key]) + zero[one["stroke"]]))
        for one in records
        for key in ("alpha_min", "alpha_max")
    ]
    turning = ("turning", *engine, "--angle=" + ";".join(angles), "--columns=tangential_excess")
    for one in printed(*turning, "--digits=6", "-f", "csv").records():
        assert abs(float(one["tangential_excess"])) < 2e-6


@pytest.mark.parametrize(("method", "apart"), [("exact", 0), ("series", 7e-5)])
def test_the_mean_of_t_is_p_but_not_to_first_order(method: str, apart: float) -> None:
    engine = ("--eps=4", "--ratio=1:3", f"--method={method}", "-f", "csv", "--digits=9")
    records = printed("turning", *engine, "--step=0.5", "--columns=tangential").records()[:-1]
    mean = sum(float(one["tangential"]) for one in records) / len(records)
    (delta,) = printed("delta", *engine, "--columns=mean_force").records()
    # Where steam is cut off T has a kink.
    assert abs(float(delta["mean_force"]) - mean) == pytest.approx(apart, abs=5e-6)
