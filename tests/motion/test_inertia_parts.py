"""Pages of the parts of the rod's inertia: every cell against two point masses moved by each part alone."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
import pytest
from cli import records as records_of
from drives import ARCS, BEAMS, Drive, slide
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from mpmath import mp

import kurbel
from kurbel import verify
from kurbel.verify.enclose import working

# mpmath has no types.
Real = Any
Points = list[tuple[Real, Real]]
PARTS = ("common", "turning", "stretching")
PLAIN = [row for row in records_of("quantities") if "mechanism" not in row["command"]]
KEYS = [row["key"] for row in PLAIN if "mollier" in row["key"] or any(part in row["key"] for part in PARTS)]
for name in ("pin", "replaced", "common"):
    KEYS += [f"{name}_acceleration{end}{unit}" for end in ("", "_along", "_across") for unit in ("", "_mps2")]
KEYS = list(dict.fromkeys(KEYS))
for end in "ab":
    KEYS += [f"inertia_{end}{mark}{unit}" for mark in ("", "_x", "_y") for unit in ("", "_n")]
SHARES = [key for key in KEYS if not key.endswith(("_n", "_nm", "_mps2"))]
WHOLE = [f"inertia_{force}" for force in ("guide", "pin_x", "pin_y", "torque")]
# What has a direction of its own at a crosshead only.
ALONG = ("common_acceleration", "inertia_a_common", "inertia_b_common")


@pytest.fixture(autouse=True)
def digits() -> Iterator[None]:
    with mp.workdps(50):
        yield


def records(*words: str) -> list[dict[str, Real]]:
    found = records_of("inertia", *words)
    return [{key: mp.mpf(value) for key, value in record.items()} for record in found]


def number(one: verify.Number) -> Real:
    middle = (one.low + one.high) / 2
    return mp.mpf(middle.numerator) / middle.denominator


def complex_number(arrow: Any) -> Real:
    return mp.mpc(number(arrow.x), number(arrow.y))


def dot(one: Real, other: Real) -> Real:
    return (mp.conj(one) * other).real


def cross(one: Real, other: Real) -> Real:
    return (mp.conj(one) * other).imag


def two(a: str, k: str) -> Points:
    """Two points beside the line of the rod, for only the centre and the gyration may matter."""
    aside = mp.mpf(k) * mp.expj(1)
    return [(mp.mpf(a) + side * aside, mp.mpf("0.5")) for side in (1, -1)]


class Rod:
    """A rod of points with the mass 1 together, at a crank angle; the crank may gain speed.

    Places are complex numbers in R; those of the points count from B in rod lengths towards A.
    """

    def __init__(self, drive: verify.Drive, degrees: str, points: Points, gain: str = "0") -> None:
        with working(200):
            pin = drive.pin(Fraction(degrees))
            end = drive.driven(pin)
            arrows = [pin.value(), end.value(), drive.way(end.value(), 1)]
            self.pin, joint, self.way = map(complex_number, arrows)
            (v_a, p_a), (v_b, p_b) = ([complex_number(at.slope(i)) for i in (1, 2)] for at in (pin, end))
        self.arm = self.pin - joint
        self.of_a, self.of_b = p_a + mp.mpf(gain) * v_a, p_b + mp.mpf(gain) * v_b
        self.velocities = v_a, v_b
        self.points = points
        turned = (self.of_a - self.of_b) / self.arm
        self.fields = {
            "common": lambda place: self.of_b,
            "turning": lambda place: 1j * turned.imag * place * self.arm,
            "stretching": lambda place: turned.real * place * self.arm,
        }

    def held(self, part: str, along: Real) -> tuple[Real, Real, Real, Real]:
        """The forces in A and in B under a part, in its direction by the moments about B, but all that
        stretches the rod in A; the force on A where the guide holds B, and that of the guide."""
        pulls = [(place, mass * self.fields[part](place)) for place, mass in self.points]
        force = mp.fsum(pull for _, pull in pulls)
        about_b = mp.fsum(cross(place * self.arm, pull) for place, pull in pulls)
        in_a = force if part == "stretching" else along * (about_b / cross(self.arm, along))
        across = -1j * self.way
        about_a = about_b - cross(self.arm, force)
        guide = about_a / cross(-self.arm, across)
        return in_a, force - in_a, force - guide * across, guide

    def figures(self) -> dict[str, Real]:
        unit = -self.arm / abs(self.arm)
        ways = {"common": mp.mpc(1), "turning": 1j * unit, "stretching": unit}
        found: dict[str, Real] = {}
        ends, whole = {"a": mp.mpc(0), "b": mp.mpc(0)}, dict.fromkeys(WHOLE, mp.mpf(0))
        for part, way in ways.items():
            in_a, in_b, pin, guide = self.held(part, self.of_b if part == "common" else way)
            for end, own in (("a", in_a), ("b", in_b)):
                found |= {f"inertia_{end}_{part}": dot(own, way), f"inertia_{end}_{part}_x": own.real}
                found[f"inertia_{end}_{part}_y"] = own.imag
                ends[end] += own
            for key, own in zip(WHOLE, (guide, pin.real, pin.imag, -cross(self.pin, pin)), strict=True):
                found[f"{key}_{part}"] = own
                whole[key] += own
        for end, own in ends.items():
            found |= {f"inertia_{end}_x": own.real, f"inertia_{end}_y": own.imag, f"inertia_{end}": abs(own)}
        return found | whole | self.accelerations(ways) | self.moving_forces()

    def accelerations(self, ways: dict[str, Real]) -> dict[str, Real]:
        replaced = self.of_a - self.of_b
        found = {
            "common_acceleration": -self.of_b.real,
            "turning_acceleration": -dot(replaced, ways["turning"]),
            "stretching_acceleration": dot(replaced, ways["stretching"]),
        }
        for name, own in (("pin", self.of_a), ("replaced", replaced), ("common", self.of_b)):
            found.setdefault(f"{name}_acceleration", abs(own))
            found |= {f"{name}_acceleration_along": -own.real, f"{name}_acceleration_across": -own.imag}
        return found

    def moving_forces(self) -> dict[str, Real]:
        """What the kinetic energy of each model gains over the path of B (Mollier)."""
        a = mp.fsum(mass * place for place, mass in self.points).real
        models = {"": self.points}
        models |= {
            f"_{name}": [(1, at), (0, 1 - at)] for name, at in (("two_mass", a), ("railway", mp.mpf("0.6")))
        }

        def gained(place: Real, mass: Real) -> Real:
            (v_a, v_b), share = self.velocities, place
            velocity, bent = v_b + share * (v_a - v_b), self.of_b + share * (self.of_a - self.of_b)
            return mass * dot(velocity, bent)

        speed = dot(self.velocities[1], self.way)
        return {
            f"inertia_mollier{model}": mp.fsum(gained(*one) for one in points) / speed
            for model, points in models.items()
        }


def assert_true(
    drive: Drive, keys: list[str], degrees: str, a: str = "0.65", k: str = "0.35", accelerated: bool = False
) -> None:
    # ω = 10/s and α = 30/s², so α/ω² = 0.3.
    size = ("--stroke=600mm", "--speed=10rad/s", "--acceleration=30rad/s2") if accelerated else ()
    asked = (f"--centre={a}", f"--gyration={k}", "--digits=30", f"--angle={degrees}", *size)
    for row, angle in zip(
        records(*drive.words, *asked, f"--columns={','.join(keys)}"), degrees.split(";"), strict=True
    ):
        true = Rod(drive.true, angle, two(a, k), "0.3" if accelerated else "0").figures()
        for key in keys:
            assert abs(row[key] - true[key]) < mp.mpf("0.51e-30"), (key, angle, row[key], true[key])


@settings(max_examples=8, deadline=None)
@given(
    ratio=st.integers(2, 70).map(lambda number: Fraction(number, 100)),
    share=st.integers(-9, 9).map(lambda number: Fraction(number, 10)),
    centre=st.integers(1, 99).map("0.{:02}".format),
    gyration=st.integers(2, 49).map("0.{:02}".format),
    angle=st.integers(-3600, 7200).filter(lambda number: number % 900).map(lambda number: f"{number / 10}"),
)
def test_every_cell_is_the_force_that_holds_point_masses_under_a_part(
    ratio: Fraction, share: Fraction, centre: str, gyration: str, angle: str
) -> None:
    assert len(SHARES) == 22 + 12 + 3 + 11
    assert_true(slide(ratio, share * (1 / ratio - 1)), [*SHARES, *WHOLE], angle, centre, gyration)


@pytest.mark.parametrize("drive", [*ARCS, *BEAMS], ids=str)
def test_every_cell_of_a_rod_that_moves_a_rocker_is_that_force(drive: Drive) -> None:
    keys = [key for key in SHARES if "mollier" not in key and key not in ALONG]
    assert_true(drive, [*keys, *WHOLE], "37;250")


@pytest.mark.parametrize("drive", [slide("1:4"), slide("1:3", "-0.6")], ids=str)
def test_an_accelerated_crank_adds_its_own_to_every_part(drive: Drive) -> None:
    keys = [key for key in SHARES if "mollier" not in key]
    assert_true(drive, [*keys, *WHOLE], "37;220", accelerated=True)


PLACES = st.lists(
    st.tuples(st.integers(-30, 130), st.integers(1, 50)), min_size=2, max_size=6, unique_by=lambda one: one[0]
)


@settings(max_examples=15, deadline=None)
@given(places=PLACES, angle=st.integers(0, 3600).map(lambda number: f"{number / 10}"))
def test_a_file_of_points_has_the_forces_of_these_points(places: list[tuple[int, int]], angle: str) -> None:
    whole = sum(mass for _, mass in places)
    assume(0 <= sum(place * mass for place, mass in places) <= 100 * whole)
    # The file counts from A.
    points = [(1 - mp.mpf(place) / 100, mp.mpf(mass) / whole) for place, mass in places]
    lines = ["position,mass", *(f"{place / 100},{mass}" for place, mass in places)]
    drive = slide("2:7", "0.3")
    with TemporaryDirectory() as folder:
        path = Path(folder, "rod.csv")
        path.write_text("\n".join(lines), encoding="utf-8")
        asked = (f"--rod-file={path}", f"--angle={angle}", "--digits=30", f"--columns={','.join(WHOLE)}")
        (row,) = records(*drive.words, *asked)
    true = Rod(drive.true, angle, points).figures()
    for key in WHOLE:
        assert abs(row[key] - true[key]) < mp.mpf("0.51e-30"), key


@settings(max_examples=20, deadline=None)
@given(share=st.integers(1, 99), angle=st.integers(0, 3600))
def test_of_two_masses_with_k_squared_a_b_the_crosshead_has_nothing_of_the_turning(
    share: int, angle: int
) -> None:
    # a = s²/(1 + s²) has k² = a b = s²/(1 + s²)².
    s = Fraction(share, 100)
    rod = ("--ratio=1:3", "--offset=0.4", f"--centre={s**2 / (1 + s**2)}", f"--gyration={s / (1 + s**2)}")
    keys = [f"inertia_b_{part}" for part in PARTS[1:]]
    (row,) = records(*rod, f"--angle={angle / 10}", f"--columns={','.join(keys)}", "--digits=30")
    assert [row[key] for key in keys] == [0, 0]


def test_units_are_those_of_mass_radius_and_speed() -> None:
    # R ω² = 0.3 m (4π/s)² and M = 80 kg.
    machine = ("--stroke=600mm", "--speed=120/min", "--rod-mass=80kg")
    rod = ("--ratio=1:4", "--centre=0.65", "--gyration=0.35", "--angle=37;151")
    pairs = [(key.rsplit("_", 1)[0], key) for key in KEYS if key.endswith(("_n", "_nm", "_mps2"))]
    assert len(pairs) == 22 + 12 + 3 + 11
    keys = [key for one in pairs for key in one]
    unit = mp.mpf("0.3") * (4 * mp.pi) ** 2
    for found in records(*rod, *machine, "--digits=9", "--columns=" + ",".join(keys)):
        for share, key in pairs:
            factor = {"mps2": 1, "n": 80, "nm": 80 * mp.mpf("0.3")}[key.rsplit("_", 1)[1]] * unit
            assert abs(found[key] - factor * found[share]) < factor * mp.mpf("1e-9"), key


@pytest.mark.parametrize(
    ("key", "exact", "decimals"),
    [
        # At the inner dead centre p₂ = 1 + λ, p₃ = p₅ = λ; a = 0.65, k² - a b = -0.105.
        ("replaced_acceleration", "0.25", 1),
        ("inertia_a_common", "-0.8125", 3),
        ("inertia_a_stretching", "0.1625", 3),
        ("inertia_a", "0.65", 1),
        ("inertia_b", "0.4375", 3),
        # H = b p₂ - (k² - a b)(1 - λ).
        ("inertia_mollier", "0.51625", 4),
    ],
)
def test_ties_at_the_dead_centre_are_proved(key: str, exact: str, decimals: int) -> None:
    scaled = Fraction(exact) * 10**decimals
    assert scaled.denominator == 2
    away = int(abs(scaled) + Fraction(1, 2)) * (1 if scaled > 0 else -1)
    even = away - away % 2 if away > 0 else away + away % 2
    rod = ("inertia", "--ratio=1:4", "--centre=0.65", "--gyration=0.35", "--angle=0", f"--digits={decimals}")
    for rounding, true in (("half-away", away), ("half-even", even)):
        (row,) = records_of(*rod, f"--columns={key}", f"--rounding={rounding}")
        assert Fraction(row[key]) * 10**decimals == true


def test_two_masses_move_past_the_dead_centre_of_an_offset_crank() -> None:
    # At φ = 210° the rod stands in line with the crank: e = 2 R, L = 5 R.
    rod = ("--ratio=1:5", "--offset=2", "--centre=0.65", "--gyration=0.35", "--angle=210")
    (found,) = records(*rod, "--columns=common_acceleration,inertia_mollier_two_mass,inertia_mollier_railway")
    p = found["common_acceleration"]
    assert abs(found["inertia_mollier_two_mass"] - mp.mpf("0.35") * p) < mp.mpf("0.0001")
    assert abs(found["inertia_mollier_railway"] - mp.mpf("0.4") * p) < mp.mpf("0.0001")


def test_beside_a_dead_centre_of_an_offset_crank_no_float_is_trusted() -> None:
    forces = [f"inertia_{key}{model}" for key in ("guide", "pin", "pin_x", "pin_y", "torque")
              for model in ("", "_two_mass", "_railway")]  # fmt: skip
    about = ("--ratio=1:5", "--offset=2", "--centre=0.6", "--gyration=0.35", "--digits=9", "--columns")
    columns = ",".join(("phi", "x", "c", "p", "inertia_mollier", *forces))
    # Some 25,000 numbers, which come from floats, go past at 5·10⁻⁷° beside the dead centre.
    long = records(*about, columns, "--from=209.9999895", "--to=210.0259895", "--step=0.00002")
    assert len(long) * 19 > 20_000
    some = [long[0], long[1], long[-1]]
    short = records(*about, columns, f"--angle={';'.join(mp.nstr(row['phi'], 12) for row in some)}")
    assert short == some
    assert min(abs(row["inertia_mollier"]) for row in some[:2]) > 1000
    at_rest = kurbel.compute([210], "1:5", "inertia_mollier", offset=2, centre=0.6, gyration=0.35)
    assert np.isinf(at_rest["inertia_mollier"]).all()
