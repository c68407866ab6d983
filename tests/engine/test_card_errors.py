"""The digits and errors of indicator cards: what is printed is true to its last place, or nearly so.

The cards are those of ideal engines, measured at random places to a few figures or with noise; what they
ought to show is the closed form, which test_turn.py compares with the quadrature.
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from functools import cache, partial
from itertools import product
from math import exp
from pathlib import Path
from random import Random
from typing import NamedTuple

import flint
import pytest
from cards import read_card
from cli import printed, refusal
from places import CARDS

from kurbel.drive.crank import Crank
from kurbel.engine.card.card import Card
from kurbel.engine.card.turn import CardTurn
from kurbel.engine.digits import Asked, estimate, estimated
from kurbel.engine.engine import Diagram, Engine, Steam
from kurbel.engine.quantities import OUTSTROKE, RETURN_STROKE, WHOLE, Where, applies
from kurbel.engine.quantities import value as value_of
from kurbel.engine.request import EngineRequest
from kurbel.engine.turn import turn_of
from kurbel.errors import CardError
from kurbel.exact.numerals import Number
from kurbel.kernel.circle import circle
from kurbel.page.layouts import layout
from kurbel.page.quantity import Column

HEAD = "position,p_forward [bar],p_return [bar]\n"
BAR = 1e5
ROUNDED, NOISY = "written to 0.1 or 0.01 bar", "with noise"


class Measured(NamedTuple):
    """A number from a card and its error beside the truth; `number` is None where it is not printed."""

    value: float
    error: float
    number: Number | None
    truth: float

    @property
    def covered(self) -> bool:
        return abs(self.value - self.truth) <= self.error

    @property
    def places_off(self) -> float:
        """How many units of its last place the printed number is away from the truth."""
        assert self.number is not None
        return abs(self.number.scaled - self.truth * 10.0**self.number.decimals)


class Drawn(NamedTuple):
    """An ideal engine with its admission pressure in bar, and its card as it was measured."""

    steam: Steam
    admission: float
    crank: Crank
    card: Card


def drawn(seed: int, kind: str, folder: Path) -> Drawn:
    random = Random(seed)
    steam = Steam(
        Fraction(random.randint(120, 800), 100),
        Fraction(random.randint(2, 12), 100),
        random.choice([Fraction(1), Fraction(random.choice([*range(90, 100), *range(101, 141)]), 100)]),
        Fraction(random.randint(0, 12), 100),
    )
    admission, decimals, noise = random.uniform(3, 12), 5, 10 ** random.uniform(-4, -2)
    if kind == ROUNDED:
        decimals, noise = random.choice([1, 2]), 0.0

    def line(share: float) -> str:
        texts = (
            f"{admission * (pressure + random.gauss(0, noise)):.{decimals}f}"
            for pressure in (pressure_at(steam, share), float(steam.back or 0))
        )
        return ",".join([f"{share:.6f}", *texts])

    path = folder / f"card-{seed}.csv"
    path.write_text(HEAD + "\n".join(map(line, shares(random))))
    return Drawn(steam, admission, Crank(Fraction(1, random.randint(3, 8))), read_card(path))


def shares(random: Random) -> list[float]:
    """Return 12 to 200 shares of the stroke, evenly or unevenly apart."""
    count, apart = random.randint(12, 200), random.choice([0, 0.4])
    inner = [(place + apart * random.uniform(-1, 1)) / (count - 1) for place in range(1, count - 1)]
    return [0.0, *inner, 1.0]


def pressure_at(steam: Steam, share: float) -> float:
    cut_off, clearance = 1 / float(steam.expansion), float(steam.clearance)
    volume = max(share, cut_off) + clearance
    return float(((cut_off + clearance) / volume) ** float(steam.exponent))


def measured(seed: int, kind: str, folder: Path) -> Iterator[tuple[Column, Measured]]:
    """Yield all numbers of the card's page."""
    steam, admission, crank, card = drawn(seed, kind, folder)
    request = EngineRequest(layout=layout("delta-detail"), steams=[Diagram(card)], drives=[crank])
    turn, ideal = turn_of(request.first, "exact"), turn_of(Engine(crank, steam), "exact")
    for column in request.page_columns:
        # Q is the greatest pressure of the card, noise and all; δ and angles do not depend on it.
        free = column.quantity.minutes or column.key == "delta"
        unit = 1.0 if free else admission * BAR / card.admission
        for stroke in (WHOLE, OUTSTROKE, RETURN_STROKE):
            where = Where(stroke)
            if applies(column.quantity, where):
                with flint.ctx.workprec(80):
                    true = value_of(column.quantity, ideal, where)
                value, error = estimate(Asked(column, [turn], where))
                number = estimated(Asked(column, [turn], where), "half-away")
                yield column, Measured(float(value), error, number, float(true) * unit)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("cards")


@cache
def numbers(kind: str, folder: Path) -> list[Measured]:
    """Return all numbers of fifteen cards."""
    return [one for seed in range(15) for _, one in measured(seed, kind, folder)]


each_kind = pytest.mark.parametrize("kind", [ROUNDED, NOISY])


@each_kind
def test_printed_numbers_of_random_cards_are_true_to_their_last_place(kind: str, folder: Path) -> None:
    shown = [one for one in numbers(kind, folder) if one.number is not None]
    assert len(shown) > len(numbers(kind, folder)) / 2
    off = [one.places_off for one in shown]
    assert max(off) <= 3
    assert sum(places > 1 for places in off) <= 0.05 * len(shown)


@each_kind
def test_stated_errors_of_random_cards_cover_the_true_ones(kind: str, folder: Path) -> None:
    found = numbers(kind, folder)
    assert sum(one.covered for one in found) >= 0.95 * len(found)


@each_kind
def test_stated_errors_of_random_cards_are_not_much_too_large(kind: str, folder: Path) -> None:
    # An error so large that it covers everything would tell nothing.
    shares_of_error = sorted(abs(one.value - one.truth) / one.error for one in numbers(kind, folder))
    assert shares_of_error[len(shares_of_error) * 3 // 4] > 0.05


def test_pressures_written_to_fewer_places_have_greater_errors(folder: Path) -> None:
    steam = Steam(Fraction(5, 2), Fraction(1, 10))
    errors = []
    for decimals in (5, 3, 2, 1):
        path = folder / f"written-{decimals}.csv"
        places = [place / 60 for place in range(61)]
        lines = (f"{at:.6f},{7.3 * pressure_at(steam, at):.{decimals}f},{0.73:.{decimals}f}" for at in places)
        path.write_text(HEAD + "\n".join(lines))
        (record,) = printed("delta", "--card", str(path), "--columns", "mean_force", "-f", "csv").records()[
            2:
        ]
        errors.append(float(record["mean_force_error"]))
        # Half a unit of the last place, in the greatest pressure, is an error of each pressure.
        assert errors[-1] > 0.5 * 10**-decimals / 7.3 / 3
    assert errors == sorted(errors)


# What pages and records say of them.


def test_each_value_of_a_card_is_followed_by_its_error() -> None:
    words = ("delta", "--detail", "--card", str(CARDS / "condenser.csv"))
    heads = printed(*words, "-f", "csv").out.splitlines()[0].split(",")
    assert heads == [
        "card", "ratio", "stroke", "mean_force", "mean_force_error", "alpha_min", "alpha_min_error",
        "v_min", "v_min_error", "alpha_max", "alpha_max_error", "v_max", "v_max_error", "delta",
        "delta_error",
    ]  # fmt: skip
    table = json.loads(printed(*words, "-f", "json", "--lang", "en").out)
    assert [column["key"] for column in table["columns"]] == heads
    assert all(list(row) == heads for row in table["rows"])
    fields = {column["key"]: column for column in table["columns"]}
    for key in heads[3::2]:
        own, error = fields[key], fields[f"{key}_error"]
        assert error["name"] == f"estimated error: {own['name']}"
        assert (error["unit"], error["decimals"]) == (own["unit"], None)
    whole = table["rows"][2]
    for key in ("mean_force", "v_min", "v_max", "delta"):
        assert 0 < whole[f"{key}_error"] < abs(whole[key])
    assert [(row["delta"], row["delta_error"]) for row in table["rows"][:2]] == [(None, None)] * 2


def test_errors_stand_beside_the_columns_that_were_picked() -> None:
    words = ("--card", str(CARDS / "condenser.csv"), "-f", "csv")
    picked = printed("delta", *words, "--columns", "delta,card,mean_force").records()
    assert list(picked[2]) == ["stroke", "delta", "delta_error", "card", "mean_force", "mean_force_error"]
    assert list(printed("turning", *words, "--columns", "phi,energy").records()[0]) == [
        "phi", "energy", "energy_error",
    ]  # fmt: skip
    wheel = ("flywheel", "--power", "50kW", "--speed", "120/min", "--delta", "1%")
    (record,) = printed(*wheel, *words, "--columns", "target,power,inertia").records()
    assert list(record) == ["target", "power", "power_error", "inertia", "inertia_error"]
    assert (record["target"], record["power"], record["power_error"]) == ("0.01", "50000", "0")
    assert 0 < float(record["inertia_error"]) < float(record["inertia"]) / 20


def test_an_ideal_engine_has_no_errors() -> None:
    for words in (("delta", "--eps=2", "--detail"), ("turning", "--eps=4")):
        assert "error" not in printed(*words, "-f", "csv").out
        assert "Fehler" not in printed(*words).out


def test_the_page_names_the_card_without_its_folder_and_states_the_errors() -> None:
    words = ("delta", "--card", str(CARDS / "condenser.csv"), "--ratio", "1:4;1:5")
    page = " ".join(printed(*words, "--lang", "en").out.split())
    assert "condenser.csv" in page
    assert str(CARDS) not in page
    records = printed(*words, "--detail", "-f", "csv").records()[2::3]
    for record in records:
        note = (
            f"estimated error for r:l = {record['ratio']}: P {record['mean_force_error']} Q,"
            f" v_min/v₁ − 1 {record['v_min_error']} Q r/(m₁ v₁²),"
        )
        assert note.replace("v_min", "vₘᵢₙ") in page
    german = " ".join(printed(*words).out.split())
    assert "geschätzter Fehler für r:l = 1:4: P 0," in german


# Cards that tell nothing.

SHARES = [place / 10 for place in range(11)]


def written(path: Path, forward: list[float], back: list[float]) -> str:
    rows = zip(SHARES, forward, back, strict=True)
    path.write_text(HEAD + "\n".join(f"{share},{there:.2f},{behind:.2f}" for share, there, behind in rows))
    return str(path)


@pytest.mark.parametrize("command", ["delta", "turning"])
def test_a_card_that_does_no_work_is_refused(command: str, folder: Path) -> None:
    path = written(folder / "nothing.csv", [2.0 - share for share in SHARES], [1.5] * 11)
    assert refusal(command, "--card", path, code=1) == (
        f"{read_card(path).name} does no work: the mean tangential force is 0 Q, and it must be above 0,"
        " or below where the shaft drives the piston; p_forward drives it, p_return resists it"
    )


def test_a_card_of_a_driven_machine_has_a_negative_mean_force(folder: Path) -> None:
    path = written(folder / "driven.csv", [2.0 - share for share in SHARES], [3.0] * 11)
    # From 2 to 1 bar against 3: 1.5 bar is lost over the stroke of 2 R, and π R are run through.
    turn = turn_of(Engine(Crank(Fraction(1, 5)), Diagram(read_card(path))), "exact")
    assert turn.mean_force() == pytest.approx(-1.5 / 2 * 2 / math.pi)


@pytest.mark.parametrize("command", ["delta", "turning"])
def test_a_card_that_scatters_too_much_for_one_figure_is_refused(command: str, folder: Path) -> None:
    path = written(folder / "scatter.csv", [8.0, 0.5] * 5 + [8.0], [4.0, 3.0] * 5 + [4.0])
    assert refusal(command, "--card", path, code=1) == (
        f"{read_card(path).name}: the points are too few or scatter too much for one figure of the mean"
        " force; give a smoother card, or look for a mistyped pressure"
    )


def test_half_a_card_may_do_no_work_where_the_whole_does(folder: Path) -> None:
    # Every second point lies at the back pressure; the card is refused for its scatter, not for its half.
    path = written(folder / "half.csv", [3.0, 8.0] * 5 + [3.0], [3.0] * 11)
    with pytest.raises(CardError, match="does no work"):
        turn_of(Engine(Crank(Fraction(1, 5)), Diagram(read_card(path).halves()[0])), "exact")
    assert "scatter too much" in refusal("delta", "--card", path, code=1)


# How far the work of a stroke reaches.

EVEN = [place / 240 for place in range(241)]
AMOUNT = 1e-3


def unchanged(share: float) -> float:
    return 0.0


def card_turn(change: Callable[[float], float] = unchanged, resolution: float = 0.0) -> CardTurn:
    """Return the turn of an ideal engine whose card has so much more pressure, in Q, the admission."""
    steam = Steam(Fraction(5, 2), Fraction(1, 10))
    forward = tuple(BAR * (pressure_at(steam, share) + change(share)) for share in EVEN)
    card = Card(tuple(EVEN), forward, (BAR / 10,) * len(EVEN), resolution=resolution * BAR)
    return CardTurn(Engine(Crank(Fraction(1, 5)), Diagram(card, unit=BAR)), "exact")


def changes(shares: Sequence[float]) -> Iterator[Callable[[float], float]]:
    """Yield pressures that change the work at these shares by AMOUNT up or down, in all combinations."""
    for signs in product((-1, 0, 1), repeat=len(shares)):

        def work(share: float, signs: tuple[int, ...] = signs) -> float:
            waves = (
                sign * exp(-(((share - at) / 0.06) ** 2)) for sign, at in zip(signs, shares, strict=True)
            )
            return AMOUNT * sum(waves)

        if any(signs):
            yield partial(slope, work)


def slope(work: Callable[[float], float], share: float) -> float:
    return (work(share + 1e-4) - work(share - 1e-4)) / 2e-4


def share_at(turn: CardTurn, place: float) -> float:
    """Return the share of its stroke that the piston has travelled, so many half turns into the turn."""
    stroke = int(place >= 1)
    return float(turn.cylinder.share(stroke, circle(180.0 * (place % 1))))


@pytest.mark.parametrize(
    ("key", "least"), [("mean_force", 0.3), ("v_min", 0.5), ("v_max", 0.7), ("delta", 0.8)]
)
def test_errors_of_work_reach_a_quantity_as_far_as_is_stated(key: str, least: float) -> None:
    """Of the mean force three times as much is stated as the work alone makes; noise needs that."""
    own, whole = card_turn(), Where(WHOLE)
    request = EngineRequest(layout=layout("delta-detail"), steams=[own.diagram], drives=[own.engine.crank])
    column = next(column for column in request.page_columns if column.key == key)
    # Pressures written to a unit of 2 Q are off by Q, and the work of a stroke so by 1.
    coarse, fine = (estimate(Asked(column, [card_turn(resolution=unit)], whole)).error for unit in (2.0, 0.0))
    shares = [share_at(own, own.extreme(greatest).place) for greatest in (False, True)]
    reached = []
    for change in changes([*shares, 1.0]):
        turn = card_turn(change)
        apart = max(
            abs(own.cylinder.strokes[0].work(share) - turn.cylinder.strokes[0].work(share)) for share in EVEN
        )
        reached.append(
            abs(value_of(column.quantity, turn, whole) - value_of(column.quantity, own, whole)) / apart
        )
    assert least < max(reached) / (coarse - fine) < 1.3
