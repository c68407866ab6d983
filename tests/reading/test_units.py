"""Lengths, speeds and powers with their units, exact."""

from __future__ import annotations

import sys
from fractions import Fraction

import pytest
from cli import sentence_of
from hypothesis import given
from hypothesis import strategies as st

import kurbel
from kurbel.reading import units
from kurbel.reading.amounts import FACTORS, known_unit, plain_unit
from kurbel.reading.environment import how_to_install

SPEED_HELP = "a speed of rotation such as 120/min, 120rpm or 12.5rad/s"


def length(text: str) -> Fraction:
    return units.length(text, "stroke")


@pytest.mark.parametrize(
    ("text", "metres"),
    [
        ("600mm", Fraction(3, 5)),
        ("0,6 m", Fraction(3, 5)),
        (" 60.0 cm ", Fraction(3, 5)),
        # The inch is 25.4 mm and the foot 12 inches, by definition.
        ("23.5 inch", Fraction("23.5") * Fraction("0.0254")),
        ("2ft", 24 * Fraction("0.0254")),
        ("3/8 in", Fraction("0.0254") * 3 / 8),
        ("1 1/2 in", Fraction("0.0381")),
        ("7µm", Fraction(7, 10**6)),
        ("3 m/s*s", Fraction(3)),
    ],
)
def test_lengths_are_exact_metres(text: str, metres: Fraction) -> None:
    assert length(text) == metres


def test_a_displacement_may_be_zero_or_negative() -> None:
    assert units.displacement("-20mm", "offset") == Fraction(-1, 50)
    assert units.displacement("0mm", "offset") == 0


@pytest.mark.parametrize(
    ("text", "turns_per_second"),
    [
        ("120/min", 2),
        ("1000/3 1/min", Fraction(1000, 180)),
        ("1000/3/min", Fraction(1000, 180)),
        ("10 1/2/s", Fraction(21, 2)),
        ("120U/min", 2),
        ("120 Upm", 2),
        ("2U/s", 2),
        ("2/s", 2),
        ("7200/h", 2),
        ("2 turn/s", 2),
        ("120 revolution/min", 2),
        ("720 deg/s", 2),
        ("1,5/s", Fraction(3, 2)),
    ],
)
def test_turns_are_exact(text: str, turns_per_second: Fraction) -> None:
    speed = units.speed(text)
    assert (speed.value, speed.turns) == (turns_per_second, True)


@pytest.mark.parametrize(
    ("text", "value"), [("12.5rad/s", Fraction(25, 2)), ("750 rad/min", Fraction(25, 2))]
)
def test_radians_are_exact_and_no_turns(text: str, value: Fraction) -> None:
    speed = units.speed(text)
    assert (speed.value, speed.turns) == (value, False)


@pytest.mark.parametrize(
    ("text", "watts"),
    [
        ("50kW", Fraction(50_000)),
        # A Pferdestärke lifts 75 kg by a metre a second; pint's PS are petasiemens.
        ("68PS", 68 * 75 * Fraction("9.80665")),
        ("120 J/s", Fraction(120)),
    ],
)
def test_powers_are_exact_watts(text: str, watts: Fraction) -> None:
    assert units.power(text) == watts


@pytest.mark.parametrize("text", ["3m*m", "0A*A", "3rad*rad/s", "3 m**2"])
def test_units_with_squares_are_refused_with_a_sentence(text: str) -> None:
    # How pint names a square depends on the version of Python.
    for read, example in (
        (length, "a length such as 600mm"),
        (units.speed, SPEED_HELP),
        (units.power, "a power such as 50kW or 68PS"),
    ):
        sentence = sentence_of(read, text)
        assert f'"{text}" is in ' in sentence
        assert sentence.endswith(f"; it must be {example}")


@pytest.mark.parametrize(
    ("written", "base", "by_pint"),
    [
        ("min^-1", "1/s", "1/min"), ("min-1", "1/s", "1/min"), ("min**(-1)", "1/s", "1/min"),
        ("RPM", "turn/s", "rpm"), ("rev/min", "turn/s", "rpm"),
        ("m s^-1", "m/s", "m/s"), ("m·s⁻²", "m/s**2", "m/s**2"), ("mm s-2", "m/s**2", "mm/s**2"),
        ("kg m^2", "kg*m**2", "kg*m**2"), ("kg·m²", "kg*m**2", "kg*m**2"), ("kgm2", "kg*m**2", "kg*m**2"),
        ("lb-ft²", "kg*m**2", "lb*ft**2"), ("N/mm^2", "Pa", "N/mm**2"), ("kN cm^-2", "Pa", "kN/cm**2"),
        ("N mm⁻²", "Pa", "N/mm**2"), ("g/cm^3", "kg/m**3", "g/cm**3"), ("kg dm^-3", "kg/m**3", "kg/dm**3"),
        ("kNm", "N*m", "kN*m"), ("N·m", "N*m", "N*m"), ("lbf-ft", "N*m", "lbf*ft"), ("Zoll", "m", "inch"),
    ],
)  # fmt: skip
def test_powers_and_products_are_read_as_the_field_writes_them(written: str, base: str, by_pint: str) -> None:
    plain = plain_unit(written)
    assert plain is not None
    registry = units.registry()
    expected = registry.Quantity(Fraction(1), by_pint).to(base).magnitude
    factors = plain if plain[0] != "/" else f"1{plain}"
    assert registry.Quantity(Fraction(1), factors).to(base).magnitude == expected
    assert units.is_measure(f"7 {written}")


@pytest.mark.parametrize(
    "text", ["", "m^", "m^0", "m^22", "m/", "m//s", "m+s", "(m)", "1", "2m", "m^99s", "9**9"]
)
def test_what_is_no_product_of_units_is_none(text: str) -> None:
    assert plain_unit(text) is None


def test_speeds_of_rotation_are_read_in_any_spelling() -> None:
    for text in ("120 min^-1", "120min-1", "120 1/min", "120 rpm", "120 RPM", "120 rev/min", "2 s⁻¹", "2 Hz"):
        assert units.speed(text) == units.Speed(Fraction(2))
    assert units.speed("12,5 rad s^-1") == units.Speed(Fraction(25, 2), turns=False)


letters = st.text(st.sampled_from("mMkKsSrRaAdDegGnNiIhHzZcCµ/*·1 ^-²⁻"), max_size=8)


@given(
    st.one_of(
        st.text(max_size=100), st.builds("{}{}".format, st.sampled_from(["3", "-2,5", "1e-5", "²"]), letters)
    )
)
def test_any_text_is_read_or_answered_with_one_sentence(text: str) -> None:
    units.is_measure(text)
    for read in (length, units.speed, units.power):
        try:
            read(text)
        except kurbel.KurbelError as error:
            assert 0 < len(str(error)) < 300


def test_text_with_a_unit_is_told_from_a_number() -> None:
    assert units.is_measure("5 mm")
    assert not units.is_measure("0,25")
    assert not units.is_measure("abc")
    assert not units.is_measure(" " * 100_000 + "!")


@pytest.mark.parametrize("unit", [*FACTORS, "lb/(hp h)", "kg/kWh", "ft lbf/lb", "kN cm^-2", "l min^-1"])
def test_units_that_are_known_are_those_of_pint(unit: str) -> None:
    known, plain = known_unit(unit), plain_unit(unit)
    assert known and plain
    base = "*".join(f"{one}**({power})" for one, power in zip(("m", "kg", "s"), known.powers, strict=True))
    assert units.registry().Quantity(Fraction(1), plain).to(base).magnitude == known.size
    assert units.unit_in(unit, "m") == (known.size if known.powers == (1, 0, 0) else None)


@pytest.mark.parametrize("unit", units.TURNS)
def test_turns_that_are_known_are_those_of_pint(unit: str) -> None:
    known, written = units.speed(f"90 {unit}"), "1" + unit if unit.startswith("/") else unit
    assert known == units.Speed(90 * units.TURNS[unit])
    turns = units.registry().Quantity(Fraction(90), written).to("turn/s" if unit == "rpm" else "1/s")
    assert turns.magnitude == known.value


def test_units_of_everyday_need_no_pint(monkeypatch: pytest.MonkeyPatch) -> None:
    units.registry.cache_clear()
    monkeypatch.setitem(sys.modules, "pint", None)
    assert length("600mm") == Fraction(3, 5)
    assert units.speed("120/min") == units.Speed(Fraction(2))
    assert units.pressure("8bar") == 800_000


def test_without_pint_the_sentence_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    units.registry.cache_clear()
    monkeypatch.setitem(sys.modules, "pint", None)
    with pytest.raises(kurbel.KurbelError) as raised:
        length("6 yard")
    assert str(raised.value) == (
        f"quantities with units need pint; install it with: {how_to_install('units')}"
    )
