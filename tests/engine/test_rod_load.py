"""The combined load of the rod, against Newton's equations on a fine grid and against mpmath."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from cli import printed, records
from drawn_machines import Draw
from figures import rows
from machines import Machine, machine
from mpmath import mp
from numpy.testing import assert_allclose
from places import CARDS

import kurbel

SHEET = ("forces", "--layout=rod-load", "--lang=en")
MASSES = ("--bore=300mm", "--pressure=8bar", "--stroke=600mm", "--speed=170/min", "--reciprocating=210kg")
COLUMNS = "thrust,pull,thrust_angle,pull_angle"
ENDS = {"slide": "crosshead_load", "crosshead": "rod_force", "crank": "crank_end_force"}


def loads(one: Machine, name: str) -> dict[str, float]:
    """Return the greatest thrust and pull, and over how many degrees there is either."""
    cells = one.turn.angles
    # Just within the ends of the cells, at which a load may leap.
    ends = (one.turn.edges[:-1, None] + 1e-7, one.turn.edges[1:, None] - 1e-7)
    angles = np.concatenate([ends[0], cells, ends[1]], axis=1)
    load = one.rod(angles)[name]
    spans = []
    for sign in (1, -1):
        before, after = sign * load[:, :-1], sign * load[:, 1:]
        part = np.clip(np.maximum(before, after) / np.maximum(abs(after - before), 1e-30), 0, 1)
        share = np.where((before > 0) & (after > 0), 1, np.where((before > 0) | (after > 0), part, 0))
        spans.append(float((share * np.diff(angles, axis=1)).sum()))
    return {"thrust": load.max(), "pull": -load.min(), "thrust_angle": spans[0], "pull_angle": spans[1]}


@pytest.mark.parametrize("load", ["steam", "compressor", "gas"])
@pytest.mark.parametrize("mechanism", ["straight", "offset"])
def test_extremes_and_reversal_are_those_of_newtons_equations_on_a_fine_grid(
    mechanism: str, load: str
) -> None:
    draw = Draw(len(load))
    for _ in range(2):
        options: dict[str, Any] = draw.machine(mechanism, load)
        options |= draw.masses(load, options)
        options.pop("cranks", None)
        one = machine(**options)
        page = kurbel.forces(**options, layout="rod-load", lang="en", digits=6, columns=COLUMNS)
        for found in rows(page):
            wanted = loads(one, ENDS[found["end"]])
            scale = max(wanted["thrust"], wanted["pull"])
            for key, near in (("thrust", 1e-5 * scale), ("pull", 1e-5 * scale)):
                assert abs(float(found[key] or 0) - max(wanted[key], 0)) < near, (options, found)
            for key in ("thrust_angle", "pull_angle"):
                assert abs(float(found[key]) - wanted[key]) < 2e-3, (options, found)


def test_many_digits_of_an_extreme_and_of_a_reversal_are_those_of_mpmath() -> None:
    found = records(*SHEET, "--eps=3", "--back=0.07", "--ratio=2:9", *MASSES, "--digits=25")
    with mp.workdps(40):
        ratio, speed = mp.mpf(2) / 9, 2 * mp.pi * mp.mpf(170) / 60
        inertia = 210 * mp.mpf("0.3") * speed**2
        whole = mp.pi / 4 * mp.mpf("0.3") ** 2 * 800_000

        def path(angle: mp.mpf) -> mp.mpf:
            return 1 - mp.cos(angle) + (1 - mp.sqrt(1 - (ratio * mp.sin(angle)) ** 2)) / ratio

        def load(angle: mp.mpf, back: bool = False) -> mp.mpf:
            share = (2 - path(angle) if back else path(angle)) / 2
            net = (mp.mpf(1) / 3 / share if 3 * share > 1 else 1) - mp.mpf("0.07")
            return whole * net * (-1 if back else 1) - inertia * mp.diff(path, angle, 2)

        # Thrust and pull are greatest at cut-off: there the masses still press more and more.
        cut_off = mp.findroot(lambda angle: path(angle) - mp.mpf(2) / 3, 1.1)
        back = mp.findroot(lambda angle: 2 - path(angle) - mp.mpf(2) / 3, 4.4)
        begin = mp.findroot(load, 0.4) if load(mp.mpf(0)) < 0 else mp.mpf(0)
        true = {
            "thrust_n": load(cut_off), "phi_thrust": mp.degrees(cut_off), "pull_n": -load(back, True),
            "phi_pull": mp.degrees(back), "thrust_angle": mp.degrees(mp.pi - begin),
        }  # fmt: skip
        for key, value in true.items():
            assert mp.almosteq(value, mp.mpf(found[0][key]), abs_eps=mp.mpf("1e-23")), key


def test_a_load_that_only_thrusts_has_no_pull_and_no_reversal() -> None:
    slide = records(*SHEET, "--eps=4", "--single-acting")[0]
    assert (slide["thrust"], slide["phi_thrust"], slide["thrust_angle"]) == ("0.7500", "0.000", "180.00")
    assert (slide["pull"], slide["phi_pull"], slide["pull_angle"]) == ("", "", "0.00")
    assert (slide["reversal_angle"], slide["reversal_share"]) == ("0.00", "0.00")


def test_a_double_zero_at_the_dead_centre_is_no_change_of_the_sign() -> None:
    # At the best back pressure the steam ends its stroke with no force and no slope.
    found = records(*SHEET, "--eps=5", "--ratio=1:3")
    assert [one["reversal_unbroken"] for one in found] == ["180.00"] * 3


def test_a_load_half_way_between_two_printed_ones_is_a_tie() -> None:
    words = (*SHEET, "--eps=4", "--back=0.35", "--digits=1", "--columns=thrust")
    assert records(*words, "--rounding=half-even")[0]["thrust"] == "0.6"
    assert records(*words)[0]["thrust"] == "0.7"


def test_the_longest_reversal_goes_on_over_the_dead_centre() -> None:
    # Masses of 1e4 Q make the load alone: it pulls about the inner dead centre, as far as p is above zero.
    heavy = ("--stroke=500mm", "--speed=300rad/s", "--bore=300mm", "--pressure=1bar", "--reciprocating=5t")
    found = records(*SHEET, "--eps=4", "--ratio=0.3", *heavy, "--digits=6")[0]
    pull, unbroken = float(found["pull_angle"]), float(found["reversal_unbroken"])

    def place(angle: float) -> mp.mpf:
        return mp.cos(angle) + mp.sqrt(1 / mp.mpf("0.09") - mp.sin(angle) ** 2)

    zero = mp.findroot(lambda angle: mp.diff(place, angle, 2), 1.3)
    assert_allclose([pull, unbroken], [2 * math.degrees(zero)] * 2, rtol=0, atol=0.02)


def test_a_card_has_the_load_of_the_ideal_steam_that_it_was_drawn_from() -> None:
    card = ("--card", str(CARDS / "ideal-2.csv"), "--bore=300mm", *MASSES[2:])
    drawn, ideal = (printed(*SHEET, *words, "-f", "csv").records() for words in (card, ("--eps=2", *MASSES)))
    for one, other in zip(drawn, ideal, strict=True):
        for key in ("thrust_n", "pull_n", "thrust_angle", "reversal_share"):
            error = float(one[f"{key}_error"])
            assert abs(float(one[key]) - float(other[key])) <= error + 10.0 ** -len(one[key].split(".")[1])
        # The load is flat where it is greatest, and its place known the less.
        assert 1e-5 < float(one["phi_thrust_error"]) < 1e-3
