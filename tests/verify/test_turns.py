"""What kurbel prints of turns under loads, at the door, against forces and works enclosed."""

from __future__ import annotations

import math
import random
from fractions import Fraction
from typing import Any

import pytest
from cli import records
from drawn_machines import LOADS, MECHANISMS, Draw
from machines import machine
from verified import verified, words

from kurbel import KurbelError, verify
from kurbel.verify import CONFIRMED, WRONG, enclose
from kurbel.verify.numbers import number, spread

TURN = ("mean_force", "delta", "alpha_min", "v_min", "alpha_max", "v_max")
AT = ("tangential", "tangential_excess", "energy")


def confirm(options: dict[str, Any], digits: int = 12) -> None:
    """Confirm δ, its extremes and their angles, and three rows of the turn."""
    turn, asked = verified(**options), [*words(options), f"--digits={digits}"]
    (row,) = records("delta", *asked, f"--columns={','.join(TURN)}")
    for key in TURN:
        assert turn.value(key).confirms(row[key]) == CONFIRMED, (options, key, row[key])
    rough = machine(**options).turn
    assert [rough.mean, rough.delta] == pytest.approx([float(row[key]) for key in TURN[:2]], rel=1e-9)
    chance = random.Random(str(options))
    angles = ";".join(f"{chance.uniform(0, 360):.2f}" for _ in range(3))
    for row in records("turning", *asked, f"--angle={angles}", f"--columns=phi,{','.join(AT)}"):
        for key in AT:
            assert turn.value(key, row["phi"]).confirms(row[key]) == CONFIRMED, (options, key, row)


def drawn(mechanism: str, load: str) -> dict[str, Any]:
    return Draw(MECHANISMS.index(mechanism) + 10 * LOADS.index(load)).machine(mechanism, load)


# Every drive and every load once; the others are slow.
FAST = {("arc", "steam"), ("beam", "compressor"), ("offset", "pump"), ("straight", "gas")}
PAIRS = [(mechanism, load) for load in LOADS for mechanism in MECHANISMS]


@pytest.mark.parametrize(
    ("mechanism", "load"),
    [pytest.param(*pair, marks=[] if pair in FAST else [pytest.mark.slow]) for pair in PAIRS],
)
def test_turns_of_random_machines(mechanism: str, load: str) -> None:
    confirm(drawn(mechanism, load))


CHOSEN: list[dict[str, Any]] = [
    {"eps": "4", "ratio": "1:4", "method": "series", "cranks": "0;77.5"},
    {"eps": "2.5", "ratio": "1:∞", "single_acting": True, "exponent": "3/2", "clearance": "5%"},
    {"eps": "3", "back": "0.1", "bore": "300mm", "pressure": "8bar", "piston_rod": "60mm", "tail_rod": "4cm"},
    {"eps": "1", "back": "0.2", "offset": "0.5"},
    {"pump": "single"},
    {"compression": "6", "heat": "10"},
    {"compression": "15", "cycle": "diesel", "cut_off": "2", "expansion_exponent": "1.3"},
    {"compression": "14", "cycle": "dual", "peak_pressure": "55", "heat": "11", "two_stroke": True},
    {
        "eps": "3", "ratio": "1:4", "bore": "300mm", "pressure": "8bar", "stroke": "600mm", "speed": "9rad/s",
        "reciprocating": "90kg", "rod_mass": "40kg", "centre": "0.6", "gyration": "0.3", "slope": "90",
    },
]  # fmt: skip


@pytest.mark.parametrize("options", CHOSEN, ids=lambda one: " ".join(words(one)))
def test_turns_of_chosen_machines(options: dict[str, Any]) -> None:
    confirm(options, 16)


@pytest.mark.parametrize("drive", [{"offset": "-0.7"}, {"mechanism": "arc", "rocker": "5", "offset": "0.3"}])
def test_strokes_of_their_own(drive: dict[str, Any]) -> None:
    options = {"ratio": "1:4", "eps": "3.5", "back": "0.08", "clearance": "4%", **drive}
    turn, rows = verified(**options), records("delta", "--detail", *words(options), "--digits=12")
    for row in rows[:2]:
        for key in ("alpha_cutoff", *TURN[2:]):
            shown = row[key]
            assert turn.value(key, stroke=row["stroke"]).confirms(shown) == CONFIRMED, (row, key)


@pytest.mark.parametrize(
    "options",
    [
        {"eps": "3", "ratio": "1:4", "cranks": "0;77.5", "clearance": "5%"},
        pytest.param({"compression": "6", "heat": "10", "cranks": "0;360"}, marks=pytest.mark.slow),
        {"pressure_ratio": "4", "clearance": "4%", "offset": "0.9", "exponent": "1.3"},
    ],
    ids=str,
)
def test_no_place_at_which_the_force_is_its_mean_is_missed(options: dict[str, Any]) -> None:
    shown = [one["phi"] for one in records("solve", *words(options), "--where=tangential_excess=0")]
    turn = verified(**options)
    period, places = float(turn.known.period), [float(one) for one in turn.stationary()]
    assert len(shown) == len(places) * round(180 * len(turn.load()) / period) > 1
    for angle in shown:
        assert any(abs(math.remainder(one - float(angle), period)) < 1e-4 for one in places)
    assert len(turn.stationary(rising=True)) == len(turn.stationary(rising=False))


def test_a_digit_changed_by_hand_is_found_wrong() -> None:
    options = {"eps": "3", "ratio": "1:4"}
    turn = verified(**options)
    (row,) = records("delta", *words(options), f"--columns={','.join(TURN)}", "--digits=9")
    for key in TURN:
        shown = row[key]
        for place in (place for place, sign in enumerate(shown) if sign.isdigit()):
            changed = shown[:place] + str((int(shown[place]) + 1) % 10) + shown[place + 1 :]
            assert turn.value(key).confirms(changed) == WRONG, (key, changed)


@pytest.mark.parametrize("load", LOADS)
def test_works_are_integrals_and_slopes_are_slopes(load: str) -> None:
    """By differences of the fourth order, of which the closed forms know nothing."""
    turn = verified(**drawn("straight", load))
    step, share = Fraction(1, 10**4), Fraction(61, 100)
    with enclose.working(100):
        for stroke in turn.load():
            for work, force in ((stroke.work, stroke.force), (stroke.force, stroke.slope)):
                near = [work(number(share + by * step)) for by in (-2, -1, 1, 2)]
                slope = (near[0] - 8 * near[1] + 8 * near[2] - near[3]) / (12 * step)
                assert float(slope) == pytest.approx(float(force(number(share))), rel=1e-12, abs=1e-12)


def test_rods_without_a_bore_are_in_diameters_of_the_piston() -> None:
    (_, back) = verify.steam("3", piston_rod="1/2")()
    assert back.force(number(0)).rational == Fraction(3, 4) - Fraction(1, 3)


def test_an_interval_over_a_corner_holds_what_lies_in_it() -> None:
    (stroke, _) = verify.steam("2", back="0.1", exponent="1.3", clearance="0.05")()
    wide = spread(Fraction(45, 100), Fraction(55, 100))
    for share in (Fraction(45, 100), Fraction(1, 2), Fraction(53, 100), Fraction(55, 100)):
        for of in (stroke.force, stroke.work, stroke.slope):
            inside, around = of(number(share)), of(wide)
            assert around.low <= inside.low
            assert inside.high <= around.high


def test_what_cannot_be_verified_is_said() -> None:
    drive, steam = verify.drive("1:5"), verify.steam(3)
    turn = verify.turn(drive, steam, method="exact")
    opposite = verify.turn(drive, steam, cranks=(0, 180), method="exact")
    for ask in (
        lambda: turn.value("x"),
        lambda: turn.value("v_min", stroke="third"),
        lambda: verify.turn(drive, steam, method="guess"),
        lambda: opposite.value("v_min", stroke="return").digits(3),
        lambda: verify.pump("triple"),
    ):
        with pytest.raises(KurbelError):
            ask()


def test_an_angle_that_is_not_given_is_that_of_the_dead_centre() -> None:
    turn = verified(eps="3")
    assert turn.value("energy").digits(12) == "0.000000000000"
    turn = verified(eps="3", offset="0.3")
    assert turn.value("tangential").digits(12) == turn.value("tangential", 360).digits(12)
    assert turn.value("tangential").digits(12) != turn.value("tangential", 2).digits(12)
