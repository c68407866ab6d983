"""Indicator cards: however their files are written, the pressures are those of two straight lines.

What is refused, and in which words, stands in tests/transcripts/refused/delta.txt; here is what no text
file can be.
"""

from __future__ import annotations

import os
import sys
import threading
from collections.abc import Callable
from pathlib import Path

import pytest
from cli import kurbel, printed, records, refusal
from hypothesis import given, settings
from hypothesis import strategies as st
from places import CARDS

from kurbel import KurbelError, delta
from kurbel.reading import csv_file, units
from kurbel.reading.environment import how_to_install

SHARES = (0.0, 0.04, 0.1, 0.22, 0.36, 0.5, 0.61, 0.74, 0.88, 0.95, 1.0)
NAMES = ("position", "p_forward", "p_return")
HEADS = ("position", "p_forward [bar]", "p_return [bar]")
OTHER = 0.9


def forward(share: float) -> float:
    """Return the pressure on the outstroke in bar."""
    return 8.1 - 5.8 * share


def back(share: float) -> float:
    """Return the pressure on the return stroke, by the position of the outstroke."""
    return 2.7 - 1.4 * share


def text_of(
    heads: tuple[str, ...] = HEADS,
    delimiter: str = ",",
    mark: str = ".",
    end: str = "\n",
    unit: str = "",
    place: Callable[[float], str] = lambda share: f"{share:.2f}",
) -> str:
    rows = [
        delimiter.join([place(share), f"{forward(share):.9f}{unit}", f"{back(share):.9f}{unit}"]).replace(
            ".", mark
        )
        for share in SHARES
    ]
    return end.join([delimiter.join(heads), *rows, ""])


def written(folder: Path, text: str | bytes) -> str:
    path = folder / "card.csv"
    path.write_bytes(text.encode() if isinstance(text, str) else text)
    return str(path)


def check_card(path: str, pascals: float = 1e5) -> None:
    """Compare both strokes of a single-acting piston with the two lines, in so many pascals."""
    words = (f"--card={path}", "--single-acting", f"--other-side={OTHER}bar", "--shares=0;0.36;0.7;1")
    rows = records("pressures", *words, "--columns=stroke,share,gas_pressure", "--digits=8")
    assert len(rows) == 8
    for row in rows:
        share, unit = float(row["share"]), pascals / 1e5
        true = unit * forward(share) - OTHER if row["stroke"] == "1" else OTHER - unit * back(1 - share)
        assert len(row["gas_pressure"].partition(".")[2]) >= 3
        assert float(row["gas_pressure"]) == pytest.approx(true, rel=2e-8, abs=2e-8)


PERCENT = text_of(("position [%]", *HEADS[1:]), place=lambda share: f"{share * 100:.0f}")
AMONG_OTHERS = "\n".join(
    ["p_return [bar];remark;position [%];;p_forward [bar]"]
    + [f"{back(share):.9f};note, with comma;{share * 100:.0f};;{forward(share):.9f}" for share in SHARES]
)


@pytest.mark.parametrize(
    "text",
    [
        text_of(),
        text_of(end="\r\n"),
        "\ufeff" + text_of(),
        "\ufeff# scanned 1907\n\n" + text_of().replace("\n0.5", "\n\n  # cut-off\n0.5") + ",,\n\n",
        text_of(("position", "p_forward (bar)", "p_return/bar")),
        text_of(("Position [-]", "P_FORWARD in bar", " p_return bar ")),
        text_of(("position/1", "p_forward/(bar)", "p_return[bar]")),
        text_of(NAMES, unit=" bar"),
        text_of(NAMES, ";", ",", unit=" bar").replace("7,868000000 bar", "786,8kPa").replace(
            "7,520000000 bar", "7520 hPa"
        ).replace("6,824000000 bar", "0,6824 MPa").replace("5,200000000 bar", "5200mbar").replace(
            "6,012000000 bar", "0,6012 N/mm²"
        ).replace("8,100000000 bar", "81e4Pa"),
        text_of().replace("8.1", ' "8.1').replace("00,2.70", '00",2.70').replace("position,", '"position", '),
        text_of().replace("\n1.00,", "\n1.0000000000000002,"),
        PERCENT,
        AMONG_OTHERS,
    ],
)  # fmt: skip
def test_a_card_is_read_however_it_is_written(text: str, tmp_path: Path) -> None:
    check_card(written(tmp_path, text))


@pytest.mark.parametrize(
    ("unit", "pascals"),
    [
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
def test_units_of_pressure_are_what_they_are_defined_as(unit: str, pascals: float, tmp_path: Path) -> None:
    check_card(written(tmp_path, text_of(("position", f"p_forward [{unit}]", f"p_return [{unit}]"))), pascals)


@settings(deadline=None, max_examples=25)
@given(
    st.sampled_from([(";", ","), (";", "."), ("\t", ","), (",", ".")]),
    st.permutations([("position [%]", 2, 100), ("p_forward [kPa]", 0, 100), ("p_return/MPa", 1, 0.1)]),
)
def test_columns_stand_in_any_order_and_each_has_its_unit(
    tmp_path_factory: pytest.TempPathFactory, style: tuple[str, str], columns: list[tuple[str, int, float]]
) -> None:
    delimiter, mark = style
    lines = [delimiter.join(head for head, _, _ in columns)]
    for share in SHARES:
        values = (forward(share), back(share), share)
        cells = [f"{values[which] * unit:.8f}" for _, which, unit in columns]
        lines.append(delimiter.join(cells).replace(".", mark))
    check_card(written(tmp_path_factory.getbasetemp(), "\n".join(lines)))


def test_a_card_of_a_german_spreadsheet_is_read_with_pressures_below_the_atmosphere(tmp_path: Path) -> None:
    """At its ends 6,20 and 3,66 kp/cm² on the way out, -0,24 and -0,86 on the way back."""
    card = (CARDS / "condenser.csv").read_text(encoding="utf-8")
    for text in (card, card.replace("-0", "−0")):
        words = ("--single-acting", "--other-side=0bar", "--shares=0;0.5;1", "--columns=gas_pressure")
        rows = records("pressures", f"--card={written(tmp_path, text)}", *words)
        found = [float(row["gas_pressure"]) for row in rows]
        at_ends = [found[place] / 0.980665 for place in (0, 1, 4, 5)]
        assert at_ends == pytest.approx([6.20, 3.66, 0.86, 0.24], abs=0.06)


UTF_8 = "is not UTF-8; save the card as CSV in UTF-8"
NO_TEXT = "is in no text file; a card is a CSV file, with lines that end in LF or CRLF"


@pytest.mark.parametrize(
    ("content", "sentence"),
    [
        (text_of().encode("utf-16"), f"line 1: the byte 0xff {UTF_8}"),
        (b"position,p_forward [kp/cm\xb2],p_return [bar]\n", f"line 1: the byte 0xb2 {UTF_8}"),
        (b"PK\x03\x04\x14\x00", f"line 1: the character U+0003 {NO_TEXT}"),
        (text_of(end="\r"), f"line 1: the character U+000D {NO_TEXT}"),
        (
            text_of() + "#" * 10_001,
            "line 13: the line is longer than 10000 bytes; a card has one point a line",
        ),
    ],
)
def test_what_is_no_text_is_refused(content: str | bytes, sentence: str, tmp_path: Path) -> None:
    assert refusal("delta", "--card", written(tmp_path, content), code=1).endswith(f"card.csv, {sentence}")


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no pipes here")
def test_a_pipe_is_not_opened(tmp_path: Path) -> None:
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    done: list[str] = []

    def read() -> None:
        with pytest.raises(KurbelError) as raised:
            delta(card=str(pipe))
        done.append(str(raised.value))

    reader = threading.Thread(target=read, daemon=True)
    reader.start()
    reader.join(5)
    assert [one.partition("pipe: ")[2] for one in done] == [
        "it is a device or a pipe; a card must be a regular file"
    ]


def test_a_file_of_two_gigabytes_is_refused_unread(tmp_path: Path) -> None:
    path = written(tmp_path, "position\n")
    os.truncate(path, 2 * 10**9)
    sentence = refusal("delta", "--card", path, code=1)
    assert sentence.endswith(": it has 2000 MB; a card has at most 100 MB")


def test_reading_stops_at_the_first_line_too_many(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(csv_file, "MOST_LINES", 12)
    check_card(written(tmp_path, text_of()))
    path = written(tmp_path, text_of() + "1.5,0,0\nnot,a,number\n")
    sentence = refusal("delta", "--card", path, code=1)
    assert sentence.endswith("card.csv has more than 12 lines; at most 11 points are read")


def test_a_long_name_is_cut_and_made_printable(tmp_path: Path) -> None:
    path = tmp_path / ("a\x1b[31m" + "x" * 100 + ".csv")
    path.write_text("")
    sentence = refusal("delta", "--card", str(path), code=1)
    assert sentence.startswith("...x")
    assert len(sentence) < 160


def test_without_pint_the_sentence_says_what_to_install(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    units.registry.cache_clear()
    monkeypatch.setitem(sys.modules, "pint", None)
    check_card(written(tmp_path, text_of()))
    # No other test has asked for the factor of this unit.
    path = written(tmp_path, text_of().replace("bar", "cmHg"))
    assert refusal("delta", "--card", path, code=1) == (
        f"quantities with units need pint; install it with: {how_to_install('units')}"
    )


NEAR_UNITS = st.text(st.sampled_from("barkPMpsitmcn²2/·*^ 1%µhüegCd"), max_size=12)
NEAR_CARDS = st.lists(
    st.sampled_from(
        [*"0123456789.,;\t\n\r#\"' -+%[]()/", *NAMES, "[bar]", "1e9", "kPa", "in", f"{','.join(HEADS)}\n"]
    )
).map("".join)


@settings(deadline=None, max_examples=120)
@given(
    st.one_of(
        st.binary(max_size=200),
        st.text(max_size=200).map(str.encode),
        NEAR_CARDS.map(str.encode),
        NEAR_UNITS.map(lambda unit: text_of(("position", f"p_forward [{unit}]", "p_return [bar]")).encode()),
    )
)
def test_any_file_is_a_card_or_answered_with_one_sentence(
    tmp_path_factory: pytest.TempPathFactory, content: bytes
) -> None:
    path = written(tmp_path_factory.getbasetemp(), content)
    result = kurbel("pressures", "--card", path, "--shares=0.5")
    assert result.code in (0, 1)
    if result.code:
        assert result.out == ""
        assert "card.csv" in result.err
        assert result.err.count("\n") == 1
        assert len(result.err) < 400


def test_the_mean_pressure_is_the_area_between_the_lines(tmp_path: Path) -> None:
    words = ("--bore=300mm", "--stroke=450mm", "--speed=200/min", "--columns=mean_pressure", "--digits=6")
    (row,) = printed("power", f"--card={written(tmp_path, text_of())}", *words, "-f", "csv").records()
    assert float(row["mean_pressure"]) == pytest.approx(forward(0.5) - back(0.5), abs=1e-6)
