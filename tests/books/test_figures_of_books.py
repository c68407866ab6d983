"""Figures of the books, by motion differentiated twice, by point masses and by quadrature."""

import random
from collections.abc import Iterator
from typing import Any

import pytest
from cli import printed
from mpmath import mp, mpf

import kurbel
from kurbel.exact.numerals import Number

DIGITS = 12
ROCKER = 3
# Of mpmath's differences, at 30 digits.
CLOSE = 1e-11


def drawn(name: str, **asked: Any) -> dict[str, Any]:
    """Return the drawn lengths of a construction by their letters."""
    page = kurbel.construct(name, **asked, columns="length,drawn", digits=DIGITS)
    found = ((str(letters), one) for letters, one in page.records.rows)
    return {key: mpf(one.scaled) / 10**one.decimals for key, one in found if isinstance(one, Number)}


def positions(rod: Any, offset: Any, turn: Any) -> tuple[Any, Any]:
    """Return where A and B are, as complex numbers, from the shaft; without an offset B is on a rocker."""
    pin = mp.expj(turn)
    if offset is None:
        # As far from the shaft as the rod is long, B hanging below.
        way = rod + 1j * ROCKER - pin
        along = (rod**2 - ROCKER**2 + abs(way) ** 2) / (2 * abs(way))
        return pin, pin + way / abs(way) * (along - 1j * mp.sqrt(rod**2 - along**2))
    return pin, pin.real + mp.sqrt(rod**2 - (pin.imag - offset) ** 2) + 1j * offset


def accelerations(rod: Any, offset: Any, turn: Any) -> tuple[Any, Any, Any]:
    """Return those of A and B in v²/R, and the direction from B to A."""
    one, other = (mp.diff(lambda at, end=end: positions(rod, offset, at)[end], turn, 2) for end in (0, 1))
    pin, head = positions(rod, offset, turn)
    return one, other, (pin - head) / rod


def cases() -> Iterator[tuple[dict[str, Any], Any, Any, Any]]:
    """Yield cranks of three kinds: what is asked, rod, offset and angle in radians."""
    dice = random.Random(1907)
    guides: list[tuple[dict[str, Any], Any]] = [
        ({}, mpf(0)),
        ({}, mpf(0)),
        ({"offset": "-0.3"}, mpf("-0.3")),
        ({"mechanism": "arc", "rocker": str(ROCKER)}, None),
    ]
    for guide, offset in guides:
        rod, angle = dice.randint(260, 600) / 100, dice.randint(1, 3599) / 10
        drive = {"ratio": f"1:{rod}", "angle": str(angle)} | guide
        yield drive, mpf(str(rod)), offset, mp.radians(mpf(str(angle)))


@pytest.fixture(autouse=True)
def _many_digits() -> Iterator[None]:
    with mp.workdps(30):
        yield


def test_accelerations_of_ensslins_figures_are_second_derivatives() -> None:
    for drive, rod, offset, turn in cases():
        pin, head, way = accelerations(rod, offset, turn)
        share = mpf("0.3")
        rest = (pin - head) / way
        first, second = drawn("ensslin-1", **drive), drawn("ensslin-2", **drive, point="0.3")
        fourth = drawn("ensslin-4", **drive, point="0.3")
        # On a slide p₂ has a sign.
        amount = abs(head) if offset is None else -head.real
        expected = {"$p_1$": abs(pin), "$p_2$": amount, "$p_3$": abs(rest)}
        # Square to the rod, and along it towards B.
        parts = {"$p_4$": rest.imag, "$p_5$": -rest.real}
        assert first == pytest.approx(expected | {"$p$": abs(pin + head) / 2}, abs=CLOSE)
        of_point = {"$p$": abs(head + share * rest * way), "$p_3'$": share * abs(rest)}
        assert second == pytest.approx(expected | of_point, abs=CLOSE)
        primed = {"$p_3'$": share * abs(rest), "$p_4'$": share * rest.imag, "$p_5'$": -share * rest.real}
        assert fourth == pytest.approx({"$p_3$": abs(rest)} | parts | primed, abs=CLOSE)


def test_forces_of_ensslins_figures_are_those_of_two_point_masses() -> None:
    centre, gyration = mpf("0.58"), mpf("0.27")
    given = {"centre": "0.58", "gyration": "0.27"}
    masses = [(mpf("0.5"), centre + side * gyration) for side in (1, -1)]
    for drive, rod, offset, turn in cases():
        pin, head, way = accelerations(rod, offset, turn)
        rest = (pin - head) / way

        def held(accelerated: Any) -> tuple[Any, Any]:
            """Return the forces in A and in B, by moments, of an acceleration by the distance from B."""
            forces = [(mass * accelerated(at), at) for mass, at in masses]
            in_pin = sum(force * at for force, at in forces)
            return in_pin, sum(force for force, _ in forces) - in_pin

        amount = abs(head) if offset is None else -head.real
        common, turning = held(lambda _, amount=amount: amount), held(lambda at, rest=rest: rest.imag * at)
        fifth, sixth = drawn("ensslin-5", **drive, **given), drawn("ensslin-6", **drive, **given)
        seventh = drawn("ensslin-7", **drive, **given)
        assert [fifth["$overline(H K)$"], fifth["$overline(S H)$"]] == pytest.approx(common, abs=CLOSE)
        assert [sixth["$overline(T H)$"], sixth["$overline(H G)$"]] == pytest.approx(turning, abs=CLOSE)
        assert sixth["$overline(T G)$"] == pytest.approx(sum(turning), abs=CLOSE)
        reach = sum(mass * at**2 for mass, at in masses) / sum(mass * at for mass, at in masses)
        assert sixth["$overline(S T)$"] == pytest.approx((reach - centre) * rod, abs=CLOSE)
        # In M v²/L.
        assert seventh["$overline(A G)$"] == pytest.approx(-rest.real * centre * rod, abs=CLOSE)


@pytest.mark.parametrize("drive", ["", "--mechanism=arc --rocker=4"], ids=["slide", "rocker"])
def test_forces_of_the_common_acceleration_have_the_formulas_of_the_centre_of_mass(drive: str) -> None:
    words = ("construct", "ensslin-5", *drive.split(), "--centre=0.4", "--angle=50", "--table", "-f", "csv")
    rows = {row["length"]: row for row in printed(*words).records()}
    whole = float(rows["SK"]["true"])
    for length, formula, share in (("HK", "M p₂ a/l", 0.4), ("SH", "M p₂ b/l", 0.6)):
        assert rows[length]["formula"] == formula
        assert float(rows[length]["true"]) == pytest.approx(share * whole, abs=1e-5)
    # Along the slide p₂ is that of the piston; on an arc no line holds it.
    assert rows["SK"]["formula"] == ("M p₂" if drive else "M (cos φ − sin φ tan ψ + (λ cos² φ)/cos³ ψ)")


def test_tangential_pressure_has_the_power_of_the_piston_and_its_mean_the_work() -> None:
    rod, ratio, back = mpf("3.7"), mpf("2.6"), mpf("0.15")

    def pressure(turn: Any) -> Any:
        way = rod + 1 - positions(rod, 0, turn)[1].real
        share = (way if turn < mp.pi else 2 - way) / 2
        return min(mpf(1), 1 / (ratio * share)) - back

    def tangential(turn: Any) -> Any:
        return pressure(turn) * abs(mp.diff(lambda at: positions(rod, 0, at)[1].real, turn))

    given = {"ratio": "1:3.7", "eps": "2.6", "back": "0.15"}
    for angle in ("33", "104.5", "196", "301.7"):
        turn = mp.radians(mpf(angle))
        found = drawn("radinger", angle=angle, **given)
        assert found["$overline(I J)$"] == pytest.approx(pressure(turn), abs=CLOSE)
        assert found["$overline(O E)$"] == pytest.approx(tangential(turn), abs=CLOSE)
        assert found["$overline(G H)$"] == pytest.approx(tangential(turn), abs=CLOSE)
    steps = 360
    mean = sum(tangential((step + mpf("0.5")) * 2 * mp.pi / steps) for step in range(steps)) / steps
    assert found["$overline(M N)$"] == pytest.approx(mean, abs=1e-4)


def test_leans_of_weisbachs_beam_are_those_that_he_prints() -> None:
    # His engine is drawn where none is described.
    found = drawn("weisbach-149")
    # μ = 1/72 and ν = 1/48, 0°48' and 1°12'.
    assert mp.radians(found["$C_1 A O$"]) == pytest.approx(mpf(1) / 72, abs=CLOSE)
    assert mp.radians(found["$C_3 A O$"]) == pytest.approx(mpf(1) / 48, abs=CLOSE)
    assert [round(60 * found[one]) for one in ("$C_1 A O$", "$C_3 A O$")] == [48, 72]
    assert found["$overline(F C_0)$"] == pytest.approx(mpf(1) / 6, abs=CLOSE)
