"""Indicator cards: what their files may say, and what is refused in which words."""

from __future__ import annotations

import os
import sys
import threading
from pathlib import Path

import numpy as np
import pytest
from cards import read_card
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose
from places import CARDS

from kurbel.engine.card.card import Card
from kurbel.engine.card.file import position_unit, pressure_unit
from kurbel.errors import CardError, KurbelError, MissingExtraError, NotationError
from kurbel.reading import csv_file, units
from kurbel.reading.extras import how_to_install

# Nine points that fall with the stroke, in bar; nothing about them repeats.
SHARES = (0.0, 0.1, 0.22, 0.36, 0.5, 0.61, 0.74, 0.88, 1.0)
FORWARD = (8.1, 8.0, 7.7, 6.2, 4.9, 4.1, 3.5, 2.9, 2.3)
BACK = (2.7, 1.9, 1.4, 1.2, 1.1, 1.15, 1.2, 1.25, 1.3)
HEAD = "position,p_forward [bar],p_return [bar]"


def text_of(head: str = HEAD, delimiter: str = ",", mark: str = ".", end: str = "\n", unit: str = "") -> str:
    rows = [
        delimiter.join([f"{share}", f"{there}{unit}", f"{back}{unit}"]).replace(".", mark)
        for share, there, back in zip(SHARES, FORWARD, BACK, strict=True)
    ]
    return end.join([head, *rows, ""])


def written(folder: Path, text: str | bytes) -> Path:
    path = folder / "card.csv"
    path.write_bytes(text.encode() if isinstance(text, str) else text)
    return path


def sentence(folder: Path, text: str | bytes) -> str:
    """Return what is said about a file with this text, without the folder."""
    return sentence_on(written(folder, text)).replace(csv_file.shown(folder / "card.csv"), "card.csv")


def sentence_on(path: Path | str) -> str:
    with pytest.raises(CardError) as raised:
        read_card(path)
    said = str(raised.value)
    assert len(said) < 300
    assert ". " not in said.replace(str(path), "")
    assert not said.endswith(".")
    return said


def check_card(card: Card, pascals: float = 1e5) -> None:
    assert card.positions == SHARES
    assert_allclose(card.forward, np.array(FORWARD) * pascals, rtol=1e-15, atol=0)
    assert_allclose(card.back, np.array(BACK) * pascals, rtol=1e-15, atol=0)


# How a card may be written.


@pytest.mark.parametrize(
    "text",
    [
        text_of(),
        text_of(end="\r\n"),
        "\ufeff" + text_of(),
        "\ufeff# scanned 1907\n\n" + text_of().replace("\n0.5", "\n\n  # cut-off\n0.5") + ",,\n\n",
        text_of("position;p_forward [bar];p_return [bar]", ";", ","),
        text_of("position;p_forward [bar];p_return [bar]", ";", "."),
        text_of("position\tp_forward [bar]\tp_return [bar]", "\t", ","),
        text_of("position,p_forward (bar),p_return/bar"),
        text_of("Position [-],P_FORWARD in bar, p_return bar "),
        text_of("position/1,p_forward/(bar),p_return[bar]"),
        text_of("position,p_forward,p_return", unit=" bar"),
        text_of().replace("8.1,", ' "8.1",').replace("position,", '"position", '),
    ],
)
def test_a_card_is_read_however_it_is_written(text: str, tmp_path: Path) -> None:
    check_card(read_card(written(tmp_path, text)))


def test_every_value_may_have_a_unit_of_its_own(tmp_path: Path) -> None:
    with_units = {
        "8,1;": "810kPa;",
        "8,0;": "0,8 MPa;",
        "7,7;": "7700 hPa;",
        "6,2;": "6,2bar;",
        "4,9;": "4900mbar;",
        "4,1;": "4,1 bar;",
        "3,5;": "35e4Pa;",
        "2,9;": "0,29 N/mm²;",
        "2,3;": "2,3 bar;",
    }
    text = text_of("position;p_forward;p_return [bar]", ";", ",")
    for bare, other in with_units.items():
        text = text.replace(bare, other)
    check_card(read_card(written(tmp_path, text)))


def test_columns_stand_in_any_order_among_others(tmp_path: Path) -> None:
    rows = [
        f"{back};note, with comma;{share * 100};;{there}"
        for share, there, back in zip(SHARES, FORWARD, BACK, strict=True)
    ]
    text = "\n".join(["p_return [bar];remark;position [%];;p_forward [bar]", *rows])
    card = read_card(written(tmp_path, text))
    assert_allclose(card.positions, SHARES, rtol=1e-15, atol=0)
    assert (card.positions[0], card.positions[-1]) == (0, 1)
    assert_allclose(card.forward, np.array(FORWARD) * 1e5, rtol=1e-15, atol=0)
    assert_allclose(card.back, np.array(BACK) * 1e5, rtol=1e-15, atol=0)


def test_a_card_remembers_its_file_and_lines(tmp_path: Path) -> None:
    path = written(tmp_path, "# a comment\n" + text_of())
    card = read_card(str(path))
    assert card.name == csv_file.shown(path)
    assert card.lines == tuple(range(3, 12))


def test_a_card_of_a_german_spreadsheet_is_read() -> None:
    card = read_card(CARDS / "condenser.csv")
    assert (card.positions[1], card.positions[-1], len(card.positions)) == (0.01, 1, 49)
    assert_allclose([card.forward[1], card.back[0]], [6.98 * 98066.5, -0.24 * 98066.5], rtol=1e-15, atol=0)


def test_pressures_below_the_atmosphere_may_be_negative(tmp_path: Path) -> None:
    card = read_card(written(tmp_path, text_of().replace("1.1\n", "-0.82\n").replace("1.4\n", "−0.3\n")))
    assert (card.back[4], card.back[2]) == (-82000, -30000)


def test_a_last_position_off_by_rounding_is_the_end(tmp_path: Path) -> None:
    assert (
        read_card(written(tmp_path, text_of().replace("\n1.0,", "\n1.0000000000000002,"))).positions[-1] == 1
    )


@pytest.mark.parametrize(
    ("unit", "pascals"),
    [
        ("bar", 100_000),
        ("mbar", 100),
        ("Pa", 1),
        ("hPa", 100),
        ("kPa", 1000),
        ("MPa", 1e6),
        # The standard acceleration is 9.80665 m/s², the pound 0.45359237 kg, the inch 0.0254 m.
        ("at", 98066.5),
        ("kp/cm²", 98066.5),
        ("kgf/cm^2", 98066.5),
        ("kg/cm2", 98066.5),
        ("atm", 101_325),
        ("psi", 9.80665 * 0.45359237 / 0.0254**2),
        ("lb/in²", 9.80665 * 0.45359237 / 0.0254**2),
        ("N/mm**2", 1e6),
        ("torr", 101_325 / 760),
    ],
)
def test_units_of_pressure_are_what_they_are_defined_as(unit: str, pascals: float) -> None:
    assert_allclose(pressure_unit(unit), pascals, rtol=1e-15, atol=0)


@pytest.mark.parametrize(
    "unit", ["m", "kg", "N", "N/m", "degC", "9**9**9", "Bar", "ata", "x" * 99, "m" + "*m" * 4000, "1/Pa", "%"]
)
def test_what_is_no_pressure_is_refused(unit: str) -> None:
    with pytest.raises(NotationError, match=r"^has the unit \".*\", which is no pressure.*; write bar, kPa"):
        pressure_unit(unit)


def test_positions_are_shares_or_percent() -> None:
    assert [position_unit(unit) for unit in ("", "1", "-", "%")] == [1, 1, 1, 0.01]
    with pytest.raises(NotationError, match=r"^has the unit \"mm\"; it is a share of the stroke, 0\.\.1"):
        position_unit("mm")


# What is refused, and in which words.

SEMICOLONS = "position;p_forward [bar];p_return [bar]"
NEEDED = "and a card needs position, p_forward [bar], p_return [bar]"
EMPTY = "card.csv is empty; a card starts with the heads position, p_forward and p_return"
NO_NUMBER = "is not a number; write it as 8.1"
NO_UNIT = "p_forward has no unit; write it in the head, as in p_forward [bar], or behind each value"
UTF_8 = "is not UTF-8; save the card as CSV in UTF-8"
NO_TEXT = "is in no text file; a card is a CSV file, with lines that end in LF or CRLF"
SHARE = "it is a share of the stroke, write percent as position [%]"


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", EMPTY),
        ("\ufeff# nothing\n\n", EMPTY),
        (HEAD, "card.csv has 0 points; a card has at least 8"),
        (f"{HEAD}\n0,1,1\n.5,1,1\n1,1,1\n", "card.csv has 3 points; a card has at least 8"),
        (
            "# a\n0,8.1,1.1\n",
            "card.csv, line 2: there is no column position and no p_forward and no p_return; the heads are"
            f" 0, 8.1, 1.1, {NEEDED}",
        ),
        (
            "position,p_foward [bar],p_return [bar]\n",
            "card.csv, line 1: there is no column p_forward (did you mean p_foward [bar]?); the heads are"
            f" position, p_foward [bar], p_return [bar], {NEEDED}",
        ),
        (f"{HEAD},position\n", "card.csv, line 1: 2 columns are headed position; a card has one"),
        (f'"{HEAD}\n', "card.csv, line 1: the quotes do not match (unexpected end of data)"),
    ],
)
def test_a_file_without_head_or_points_is_refused(text: str, said: str, tmp_path: Path) -> None:
    assert sentence(tmp_path, text) == said


@pytest.mark.parametrize(
    ("head", "said"),
    [
        (
            "position,p_forward [Bar],p_return [bar]",
            'p_forward has the unit "Bar", which is no pressure (did you mean bar?);'
            " write bar, kPa, MPa, psi, atm, at or kp/cm²",
        ),
        (
            "position,p_forward [bar],p_return [newton]",
            'p_return has the unit "newton", which is no pressure;'
            " write bar, kPa, MPa, psi, atm, at or kp/cm²",
        ),
        (
            "position [mm],p_forward [bar],p_return [bar]",
            'position has the unit "mm"; it is a share of the stroke, 0..1, or 0..100 with the unit %',
        ),
    ],
)
def test_a_wrong_unit_in_the_head_is_refused(head: str, said: str, tmp_path: Path) -> None:
    assert sentence(tmp_path, text_of(head)) == f"card.csv, line 1: {said}"


@pytest.mark.parametrize(
    ("bare", "given", "said"),
    [
        ("7.7,1.4", "7.7", "the row has 2 fields where the head has 3"),
        ("7.7,1.4", "7,7,1,4", "the row has 5 fields where the head has 3"),
        ("7.7", "seven", f'p_forward "seven" {NO_NUMBER}'),
        ("7.7", "", f'p_forward "" {NO_NUMBER}'),
        ("7.7", "٣", f'p_forward "٣" {NO_NUMBER}'),
        ("7.7", "7_7", f'p_forward "7_7" {NO_NUMBER}'),
        ("7.7", "7.7.1", f'p_forward "7.7.1" {NO_NUMBER}'),
        ("7.7", "x" * 70, f'p_forward "{"x" * 37}..." {NO_NUMBER}'),
        (
            "7.7",
            "7.7 bar",
            'p_forward "7.7 bar" has a unit behind the value and one in the head, bar; write it once',
        ),
        ("1.4", "nan", f'p_return "nan" {NO_NUMBER}'),
        ("1.4", "-inf", f'p_return "-inf" {NO_NUMBER}'),
        ("1.4", "1e999", 'p_return "1e999" is too large'),
        ("1.4", "0e309", 'p_return "0e309" is too large'),
        ("1.4", "-1e99", "p_return is -1e+104 Pa; no card goes beyond 10^12 Pa"),
        ("7.7", '"7.7', "the quotes do not match (unexpected end of data)"),
        ("0.22", "22", f"position 22 is outside 0..1; {SHARE}"),
        ("0.22", "-0.22", f"position -0.22 is outside 0..1; {SHARE}"),
        (
            "0.22",
            "0.07",
            "position 0.07 comes after 0.1, but positions must rise; give a closed curve, out and back,"
            " as p_forward and p_return side by side",
        ),
        (
            "0.22",
            "0.1",
            "position 0.1 is repeated; a card has one p_forward and one p_return a position, so a sudden"
            " change needs two positions close together",
        ),
    ],
)
def test_a_wrong_value_is_refused_with_its_line(bare: str, given: str, said: str, tmp_path: Path) -> None:
    advice = "; with decimal commas, part the columns by semicolons" if "fields" in said else ""
    assert sentence(tmp_path, text_of().replace(bare, given)) == f"card.csv, line 4: {said}{advice}"


def test_a_value_without_unit_is_refused(tmp_path: Path) -> None:
    head = "position,p_forward,p_return"
    assert sentence(tmp_path, text_of(head)) == f"card.csv, line 2: {NO_UNIT}"
    mixed = text_of(head, unit=" bar").replace("7.7 bar", "7.7")
    assert sentence(tmp_path, mixed) == f"card.csv, line 4: {NO_UNIT}"


def test_thousands_are_not_read_as_decimals(tmp_path: Path) -> None:
    mixed = (
        "card.csv, line 4: decimal points and decimal commas are mixed from here on; write one of them,"
        " and no thousands marks"
    )
    assert sentence(tmp_path, text_of(SEMICOLONS, ";", ",").replace("7,7", "1.013")) == mixed
    assert sentence(tmp_path, text_of().replace("7.7", '"1,013"')) == mixed
    whole = f'{HEAD}\n0,8,1\n1,"1,013",1\n'
    assert sentence(tmp_path, whole) == f'card.csv, line 3: p_forward "1,013" {NO_NUMBER}'


def test_rows_too_long_for_semicolons_are_given_no_advice_on_commas(tmp_path: Path) -> None:
    said = sentence(tmp_path, text_of(SEMICOLONS, ";").replace("7.7;1.4", "7.7;1.4;3"))
    assert said == "card.csv, line 4: the row has 4 fields where the head has 3"


def test_a_card_covers_the_whole_stroke(tmp_path: Path) -> None:
    said = sentence(tmp_path, text_of().replace("\n0.0,", "\n0.03,").replace("\n1.0,", "\n0.97,"))
    assert said == "card.csv: the positions cover 0.03..0.97; they must cover 0..1, the whole stroke"


def test_forces_need_an_admission_to_be_counted_in(tmp_path: Path) -> None:
    said = sentence(tmp_path, "".join([HEAD, *(f"\n{share},-0.3,-0.7" for share in SHARES)]))
    assert said == (
        "card.csv: the greatest p_forward is -30000 Pa; it must be at least 1 Pa, for forces are counted in"
        " it; give pressures below the atmosphere as those above vacuum"
    )


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (text_of().encode("utf-16"), f"line 1: the byte 0xff {UTF_8}"),
        (
            text_of("position,p_forward [kp/cm²],p_return [bar]").encode("latin-1"),
            f"line 1: the byte 0xb2 {UTF_8}",
        ),
        (b"PK\x03\x04\x14\x00", f"line 1: the character U+0003 {NO_TEXT}"),
        (text_of(end="\r"), f"line 1: the character U+000D {NO_TEXT}"),
        (
            text_of() + "#" * 10_001,
            "line 11: the line is longer than 10000 bytes; a card has one point a line",
        ),
    ],
)
def test_what_is_no_text_is_refused(content: str | bytes, said: str, tmp_path: Path) -> None:
    assert sentence(tmp_path, content) == f"card.csv, {said}"


def test_a_closed_curve_is_named(tmp_path: Path) -> None:
    there = [f"{share},{p},1" for share, p in zip(SHARES, FORWARD, strict=True)]
    back = [f"{share},{p},1" for share, p in zip(SHARES, BACK, strict=True)]
    said = sentence(tmp_path, "\n".join([HEAD, *there, *back[-2::-1]]))
    assert said.startswith(
        "card.csv, line 11: position 0.88 comes after 1, but positions must rise; give a closed"
    )


def test_files_that_are_none_are_refused(tmp_path: Path) -> None:
    path = tmp_path / "card.csv"
    name = csv_file.shown(path)
    assert sentence_on(path) == f"cannot read the card {name}: No such file or directory"
    path.mkdir()
    assert sentence_on(path) == f"cannot read the card {name}: it is a directory; name a CSV file in it"
    assert sentence_on("a\0b") == "cannot read the card a?b: no file can have that name"
    assert sentence_on("a\n\ud800b") == "cannot read the card a??b: no file can have that name"


@pytest.mark.skipif(not Path("/dev/zero").exists(), reason="no devices here")
def test_endless_devices_and_pipes_are_not_opened(tmp_path: Path) -> None:
    told = "it is a device or a pipe; a card must be a regular file"
    assert sentence_on("/dev/zero") == f"cannot read the card /dev/zero: {told}"
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    done: list[str] = []
    reader = threading.Thread(target=lambda: done.append(sentence_on(pipe)), daemon=True)
    reader.start()
    reader.join(5)
    assert done == [f"cannot read the card {csv_file.shown(pipe)}: {told}"]


def test_a_file_of_two_gigabytes_is_refused_unread(tmp_path: Path) -> None:
    path = written(tmp_path, HEAD + "\n")
    os.truncate(path, 2 * 10**9)
    assert sentence_on(path).endswith(": it has 2000 MB; a card has at most 100 MB")


def test_reading_stops_at_the_first_line_too_many(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(csv_file, "MOST_LINES", 10)
    text = text_of()
    check_card(read_card(written(tmp_path, text)))
    said = sentence(tmp_path, text + "1.5,0,0\nnot,a,number\n")
    assert said == "card.csv has more than 10 lines; at most 9 points are read"


def test_a_long_name_is_cut_and_made_printable(tmp_path: Path) -> None:
    path = tmp_path / ("a\x1b[31m" + "x" * 100 + ".csv")
    path.write_text("")
    said = sentence_on(path)
    assert said.startswith("...x")
    assert len(said) < 160
    assert "\x1b" not in said


def test_without_pint_the_sentence_says_what_to_install(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from kurbel.engine.card import file as card_file

    units.registry.cache_clear()
    card_file._factor.cache_clear()
    monkeypatch.setitem(sys.modules, "pint", None)
    read_card(written(tmp_path, text_of()))
    with pytest.raises(MissingExtraError) as raised:
        read_card(written(tmp_path, text_of().replace("bar", "torr")))
    assert str(raised.value) == (
        f"quantities with units need pint; install it with: {how_to_install('units')}"
    )


near_cards = st.lists(
    st.sampled_from(
        [
            *"0123456789.,;\t\n\r#\"' -+%[]()/",
            "position",
            "p_forward",
            "p_return",
            "[bar]",
            "1e9",
            "kPa",
            "in",
            HEAD,
        ]
    )
).map("".join)


# Without a deadline, for pint takes a quarter of a second over its first unit.
@settings(deadline=None)
@given(st.one_of(st.binary(max_size=200), st.text(max_size=200).map(str.encode), near_cards.map(str.encode)))
def test_any_file_is_a_card_or_answered_with_one_sentence(
    tmp_path_factory: pytest.TempPathFactory, content: bytes
) -> None:
    path = tmp_path_factory.getbasetemp() / "any.csv"
    path.write_bytes(content)
    try:
        read_card(path)
    except KurbelError as error:
        assert "any.csv" in str(error)
        assert "\n" not in str(error)
        assert len(str(error)) < 400


@settings(deadline=None)
@given(st.text(st.sampled_from("barkPMpsitmcn²2/·*^ 1%µhüegCd"), max_size=12))
def test_any_unit_is_a_pressure_or_answered(unit: str) -> None:
    try:
        assert pressure_unit(unit) > 0
    except NotationError as error:
        assert 0 < len(str(error)) < 200


pressures = st.floats(-1e3, 1e3).map(lambda number: round(number, 6))


@settings(deadline=None)
@given(
    st.lists(
        st.tuples(st.integers(1, 99999), pressures, pressures),
        min_size=6,
        max_size=40,
        unique_by=lambda point: point[0],
    ),
    st.sampled_from([(";", ","), (";", "."), ("\t", ","), (",", ".")]),
    st.permutations(["position", "p_forward", "p_return"]),
)
def test_what_was_written_is_read(
    tmp_path_factory: pytest.TempPathFactory,
    points: list[tuple[int, float, float]],
    style: tuple[str, str],
    order: list[str],
) -> None:
    delimiter, mark = style
    points = [(0, 5.0, 1.0), *sorted(points), (100_000, 2.0, 1.5)]
    heads = {"position": "position [%]", "p_forward": "p_forward [kPa]", "p_return": "p_return/MPa"}
    lines = [delimiter.join(heads[name] for name in order)]
    for share, forward, back in points:
        cells = {"position": f"{share / 1000}", "p_forward": f"{forward}", "p_return": f"{back}"}
        lines.append(delimiter.join(cells[name] for name in order).replace(".", mark))
    path = tmp_path_factory.getbasetemp() / "written.csv"
    path.write_text("\n".join(lines))
    card = read_card(path)
    assert_allclose(card.positions, [point[0] / 1e5 for point in points], rtol=1e-15, atol=0)
    assert_allclose(card.forward, [point[1] * 1e3 for point in points], rtol=1e-15, atol=0)
    assert_allclose(card.back, [point[2] * 1e6 for point in points], rtol=1e-15, atol=0)


# Halving.


@pytest.mark.parametrize(("count", "kept"), [(8, [0, 2, 4, 6, 7]), (9, [0, 2, 4, 6, 8])])
def test_half_a_card_keeps_every_other_point_and_both_ends(count: int, kept: list[int]) -> None:
    shares = tuple(index / (count - 1) for index in range(count))
    forward, back = tuple(share + 3 for share in shares), tuple(share - 2 for share in shares)
    half = Card(shares, forward, back, "a", tuple(range(2, count + 2))).halves()[0]
    assert half.positions == tuple(shares[index] for index in kept)
    assert half.forward == tuple(forward[index] for index in kept)
    assert half.back == tuple(back[index] for index in kept)
    assert half.lines == tuple(index + 2 for index in kept)
    assert half.name == "a"
    assert Card(shares, forward, back).halves()[0].lines == ()
