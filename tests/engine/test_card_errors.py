"""The digits and errors of indicator cards: what is printed is true to its last place, or nearly so.

The cards are those of ideal engines, measured at random places to a few figures or with noise; what they
ought to show is the closed form, which the page of the ideal engine prints and other tests prove.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Sequence
from functools import cache, partial
from itertools import product
from math import cos, exp, radians, sin, sqrt
from pathlib import Path
from random import Random
from typing import NamedTuple

import pytest
from cli import printed, records
from places import CARDS

HEAD = "position,p_forward [bar],p_return [bar]\n"
ROUNDED, NOISY = "written to 0.1 or 0.01 bar", "with noise"


class Steam(NamedTuple):
    """An ideal engine: its options and the pressure over the share of the stroke, in that of admission."""

    expansion: float
    back: float
    exponent: float = 1.0
    clearance: float = 0.0

    @property
    def words(self) -> tuple[str, ...]:
        return tuple(f"--{name}={value}" for name, value in zip(
            ("eps", "back", "exponent", "clearance"), self, strict=True
        ))  # fmt: skip

    def pressure(self, share: float) -> float:
        cut_off = 1 / self.expansion
        volume = max(share, cut_off) + self.clearance
        return float(((cut_off + self.clearance) / volume) ** self.exponent)


class Measured(NamedTuple):
    """A number from a card, None where it is not printed, its error and the truth."""

    number: str
    error: str
    truth: float

    @property
    def off(self) -> float:
        return abs(float(self.number) - self.truth)

    @property
    def unit(self) -> float:
        """Return a unit of the last place that is printed."""
        return float(10.0 ** -len(self.number.partition(".")[2]))


def measured(seed: int, kind: str, folder: Path) -> Iterator[Measured]:
    """Yield all numbers of the page of a random card."""
    random = Random(seed)
    steam = Steam(
        random.randint(120, 800) / 100,
        random.randint(2, 12) / 100,
        random.choice([1.0, random.choice([*range(90, 100), *range(101, 141)]) / 100]),
        random.randint(0, 12) / 100,
    )
    admission, decimals, noise = random.uniform(3, 12), 5, 10 ** random.uniform(-4, -2)
    if kind == ROUNDED:
        decimals, noise = random.choice([1, 2]), 0.0
    greatest, lines = 0.0, []
    count, apart = random.randint(12, 200), random.choice([0, 0.4])
    inner = [(place + apart * random.uniform(-1, 1)) / (count - 1) for place in range(1, count - 1)]
    for share in (0.0, *inner, 1.0):
        there, behind = (
            round(admission * (pressure + random.gauss(0, noise)), decimals)
            for pressure in (steam.pressure(share), steam.back)
        )
        greatest = max(greatest, there)
        lines.append(f"{share:.6f},{there:.{decimals}f},{behind:.{decimals}f}")
    path = folder / f"card-{kind[:4]}-{seed}.csv"
    path.write_text(HEAD + "\n".join(lines))
    engine = ("delta", "--detail", f"--ratio=1:{random.randint(3, 8)}")
    ideal = records(*engine, *steam.words, "--digits=12")
    for row, true in zip(records(*engine, f"--card={path}"), ideal, strict=True):
        for key, error in row.items():
            if key.endswith("_error") and error:
                own = key.removesuffix("_error")
                # Q is the greatest pressure of the card, noise and all; δ and angles do not depend on it.
                unit = admission / greatest if own in ("mean_force", "v_min", "v_max") else 1.0
                yield Measured(row[own], error, float(true[own]) * unit)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("cards")


@cache
def numbers(kind: str, folder: Path) -> list[Measured]:
    """Return all numbers of fifteen cards."""
    return [one for seed in range(15) for one in measured(seed, kind, folder)]


@pytest.mark.parametrize("kind", [ROUNDED, NOISY])
def test_numbers_of_random_cards_are_true_and_their_errors_neither_too_small_nor_too_large(
    kind: str, folder: Path
) -> None:
    found = numbers(kind, folder)
    there = [one for one in found if one.number]
    assert len(found) > 100
    assert len(there) > len(found) / 2
    assert max(one.off / one.unit for one in there) <= 3
    assert sum(one.off > one.unit for one in there) <= 0.05 * len(there)
    assert sum(one.off <= float(one.error) + one.unit / 2 for one in there) >= 0.95 * len(there)
    # An error so large that it covers everything would tell nothing.
    shares_of_error = sorted(one.off / float(one.error) for one in there)
    assert shares_of_error[len(shares_of_error) * 3 // 4] > 0.05


def card_of(
    path: Path, steam: Steam, count: int, change: Callable[[float], float], decimals: int, zeros: int = 0
) -> tuple[str, ...]:
    """Write a card of as many pressures in bar, rounded to so many decimals, and return the words for it."""
    places = [place / (count - 1) for place in range(count)]
    path.write_text(
        HEAD
        + "\n".join(
            f"{at:.6f},{steam.pressure(at) + change(at):.{decimals}f}{'0' * zeros},"
            f"{steam.back:.{decimals}f}{'0' * zeros}"
            for at in places
        )
    )
    return ("delta", f"--card={path}")


def unchanged(share: float) -> float:
    return 0.0


def test_pressures_written_to_fewer_places_have_greater_errors(folder: Path) -> None:
    errors = []
    for decimals in (5, 4, 3, 2):
        words = card_of(folder / f"written-{decimals}.csv", Steam(2.5, 0.1), 61, unchanged, decimals)
        *_, record = records(*words, "--columns=mean_force")
        errors.append(float(record["mean_force_error"]))
        # Half a unit of the last place is an error of each pressure.
        assert errors[-1] > 0.5 * 10**-decimals / 3
    assert errors == sorted(errors)


@pytest.mark.parametrize("expansion", [1.5, 2, 2.7, 4, 6])
def test_cards_of_200_points_have_the_irregularity_of_the_engine(expansion: float, folder: Path) -> None:
    steam = Steam(expansion, round(1 / expansion, 9))
    words = card_of(folder / f"ideal-{expansion}.csv", steam, 201, unchanged, 9)
    *_, row = records(*words, "--columns=delta", "--digits=9")
    (ideal,) = records("delta", *steam.words, "--columns=delta", "--digits=9")
    assert float(row["delta"]) == pytest.approx(float(ideal["delta"]), abs=1e-6)


# How far the work of a stroke reaches.

AMOUNT, REACH = 1e-3, 0.06


def changes(shares: Sequence[float]) -> Iterator[Callable[[float], float]]:
    """Yield pressures that change the work at these shares by AMOUNT up or down, in all combinations."""

    def change(share: float, signs: Sequence[int]) -> float:
        return sum(
            -2 * AMOUNT * sign * (share - at) / REACH**2 * exp(-(((share - at) / REACH) ** 2))
            for sign, at in zip(signs, shares, strict=True)
        )

    for signs in product((-1, 0, 1), repeat=len(shares)):
        if any(signs):
            yield partial(change, signs=signs)


def share_at(degrees: float) -> float:
    """Return the share of its stroke that the piston has travelled, for R:L = 1:5."""
    ratio, angle = 0.2 if degrees < 180 else -0.2, radians(degrees % 180)
    return (1 - cos(angle) + (1 - sqrt(1 - (ratio * sin(angle)) ** 2)) / ratio) / 2


def test_errors_of_work_reach_each_quantity_as_far_as_is_stated(folder: Path) -> None:
    """Of the mean force three times as much is stated as the work alone makes; noise needs that."""
    least = {"mean_force": 0.3, "v_min": 0.5, "v_max": 0.7, "delta": 0.8}
    steam, path = Steam(2.5, 0.1), folder / "work.csv"
    columns = f"--columns={','.join(least)},alpha_min,alpha_max"

    def turn(change: Callable[[float], float], decimals: int = 9, zeros: int = 0) -> dict[str, float]:
        *_, row = records(*card_of(path, steam, 241, change, decimals, zeros), columns, "--digits=8")
        # Forces and energies are counted in the greatest pressure, which the change may raise.
        greatest = max(steam.pressure(place / 240) + change(place / 240) for place in range(241))
        return {key: float(row[key]) * (1 if key == "delta" else greatest) for key in least} | {
            key: float(value) for key, value in row.items() if key not in (*least, "stroke")
        }

    # The same pressures, written to a unit of 0.001 Q and to a finer one, are off by half of it or by
    # nothing, and so is the work of a stroke.
    coarse, fine = turn(unchanged, 3), turn(unchanged, 3, zeros=6)
    own, reached = turn(unchanged), dict.fromkeys(least, 0.0)
    for change in changes([share_at(own[key]) for key in ("alpha_min", "alpha_max")] + [1.0]):
        row, works = turn(change), [0.0]
        for place in range(1000):
            works.append(works[-1] + change((place + 0.5) / 1000) / 1000)
        for key in least:
            reached[key] = max(reached[key], abs(row[key] - own[key]) / max(map(abs, works)))
    for key, low in least.items():
        stated = (coarse[f"{key}_error"] - fine[f"{key}_error"]) / 0.5e-3
        assert low < reached[key] / stated < 1.3, key


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
    words = ("--card", str(CARDS / "condenser.csv"))
    picked = records("delta", *words, "--columns", "delta,card,mean_force")
    assert list(picked[2]) == ["stroke", "delta", "delta_error", "card", "mean_force", "mean_force_error"]
    assert list(records("turning", *words, "--columns", "phi,energy")[0]) == ["phi", "energy", "energy_error"]
    wheel = ("flywheel", "--power", "50kW", "--speed", "120/min", "--delta", "1%")
    (record,) = records(*wheel, *words, "--columns", "target,power,inertia")
    assert list(record) == ["target", "power", "power_error", "inertia", "inertia_error"]
    assert (record["target"], record["power"], record["power_error"]) == ("0.01", "50000", "0")
    assert 0 < float(record["inertia_error"]) < float(record["inertia"]) / 20


def test_a_card_of_a_driven_machine_has_a_negative_mean_force(tmp_path: Path) -> None:
    # From 2 to 1 bar against 3: 1.5 bar is lost over the stroke of 2 R, and π R are run through.
    path = tmp_path / "driven.csv"
    path.write_text(HEAD + "\n".join(f"{at / 10},{2 - at / 10:.6f},3.000000" for at in range(11)))
    *_, row = records("delta", f"--card={path}", "--columns=mean_force", "--digits=5")
    assert row["mean_force"] == "-0.47746"
