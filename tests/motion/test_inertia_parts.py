"""Pages of the parts of the rod's inertia: against point masses under each part, and against `inertia`."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

import flint
import numpy as np
import pytest
from bodies import Body, Drive, Mass, Real, energy, few, fields, moment, pulled, spread
from cli import printed, refusal
from hypothesis import given
from hypothesis import strategies as st
from mpmath import mp

import kurbel
from kurbel.drive.crank import Crank
from kurbel.drive.rod import Rod
from kurbel.motion.bulk import columns_in_floats, float_bound
from kurbel.motion.evaluation import certified, columns_in_balls, is_known
from kurbel.motion.inertia import inertia_registry
from kurbel.page.quantity import bare
from kurbel.reading.notation import Progression
from kurbel.reading.units import Speed

PARTS = ("common", "turning", "stretching")
KEYS = [key for key in inertia_registry() if "mollier" in key or any(part in key for part in PARTS)]
for name in ("pin", "replaced", "common"):
    KEYS += [f"{name}_acceleration{end}{unit}" for end in ("", "_along", "_across") for unit in ("", "_mps2")]
KEYS = list(dict.fromkeys(KEYS))
for end in "ab":
    KEYS += [f"inertia_{end}{mark}{unit}" for mark in ("", "_x", "_y") for unit in ("", "_n")]


@pytest.fixture(autouse=True)
def digits() -> Iterator[None]:
    before = flint.ctx.prec
    flint.ctx.prec = 200
    with mp.workdps(60):
        yield
    flint.ctx.prec = before


def records(*words: str) -> list[dict[str, Real]]:
    found = printed("inertia", *words, "-f", "csv").records()
    return [{key: mp.mpf(value) for key, value in record.items()} for record in found]


def typed(ratio: Fraction, offset: Fraction, centre: Fraction, gyration: Fraction) -> tuple[str, ...]:
    return (f"--ratio={ratio}", f"--offset={offset}", f"--centre={centre}", f"--gyration={gyration}")


hundredths = st.integers(1, 99).map(lambda number: Fraction(number, 100))


@few
@given(
    ratio=st.integers(2, 70).map(lambda number: Fraction(number, 100)),
    share=st.integers(-9, 9).map(lambda number: Fraction(number, 10)),
    centre=hundredths,
    gyration=st.integers(2, 49).map(lambda number: Fraction(number, 100)),
    angle=st.integers(-3600, 7200).map(lambda number: Fraction(number, 10)),
)
def test_the_parts_add_up_to_the_forces_of_the_rod(
    ratio: Fraction, share: Fraction, centre: Fraction, gyration: Fraction, angle: Fraction
) -> None:
    rod = typed(ratio, share * (1 / ratio - 1), centre, gyration)
    forces = ("guide", "pin_x", "pin_y", "torque", "a_x", "a_y", "b_x", "b_y")
    keys = [f"inertia_{force}" for force in forces]
    of_parts = [f"{key}_{part}" for key in keys[:4] for part in PARTS]
    of_ends = ["inertia_a_common", *(f"inertia_a_{part}_{mark}" for part in PARTS[1:] for mark in "xy")]
    of_ends += ["inertia_b_common", "inertia_b_turning_x", "inertia_b_turning_y"]
    words = (*rod, f"--angle={float(angle)}", "--digits=40")
    (found,) = records(*words, "--columns=phi,psi," + ",".join([*keys, *of_parts, *of_ends]))
    last = mp.mpf("3e-40")
    for key in keys[:4]:
        assert abs(sum(found[f"{key}_{part}"] for part in PARTS) - found[key]) <= last, key
    in_a = found["inertia_a_common"], *(found[f"inertia_a_{part}_x"] for part in PARTS[1:])
    assert abs(sum(in_a) - found["inertia_a_x"]) <= last
    in_a_across = sum(found[f"inertia_a_{part}_y"] for part in PARTS[1:])
    assert abs(in_a_across - found["inertia_a_y"]) <= last
    assert abs(found["inertia_b_common"] + found["inertia_b_turning_x"] - found["inertia_b_x"]) <= last
    assert abs(found["inertia_b_turning_y"] - found["inertia_b_y"]) <= last
    # Both ends together hold the rod as pin and guide do, and what B has along the slide goes to A.
    assert abs(found["inertia_a_x"] + found["inertia_b_x"] - found["inertia_pin_x"]) <= last
    whole = found["inertia_pin_y"] + found["inertia_guide"]
    assert abs(found["inertia_a_y"] + found["inertia_b_y"] - whole) <= last
    carried = found["inertia_b_x"] * mp.tan(found["psi"] * mp.pi / 180)
    assert abs(found["inertia_b_y"] + carried - found["inertia_guide"]) <= 100 * last


def ends_of(drive: Drive, body: Body, time: Real, part: str) -> tuple[Real, Real, Real]:
    """The direction of a part, and the forces in A and in B that hold the body under it.

    Moments about B say what there is in A in that direction; all along the rod is in A.
    """
    arm, field = drive.rod(time), fields(drive, time)[part]
    unit = arm * drive.ratio
    way = {"common": [1, 0], "turning": [-unit[1], unit[0]], "stretching": [unit[0], unit[1]]}[part]
    line = mp.matrix(way)
    force, about_b = pulled(body, drive, time, field)
    in_a = force if part == "stretching" else line * (about_b / moment(-arm, line))
    return line, in_a, force - in_a


def true_forces(drive: Drive, body: Body, time: Real) -> dict[str, Real]:
    unit, found = drive.rod(time) * drive.ratio, {}
    ends = {"a": mp.matrix([0, 0]), "b": mp.matrix([0, 0])}
    for part in PARTS:
        way, *held = ends_of(drive, body, time, part)
        for end, own in zip("ab", held, strict=True):
            found[f"inertia_{end}_{part}"] = (own.T * way)[0]
            found |= {f"inertia_{end}_{part}_{mark}": own[i] for i, mark in enumerate("xy")}
            ends[end] += own
        in_a, in_b = held
        guide = in_b[1] - in_b[0] * unit[1] / unit[0]
        pin = in_a + in_b - mp.matrix([0, guide])
        found |= {f"inertia_guide_{part}": guide, f"inertia_torque_{part}": -moment(drive.pin(time), pin)}
        found |= {f"inertia_pin_{mark}_{part}": pin[i] for i, mark in enumerate("xy")}
    for end, own in ends.items():
        found |= {f"inertia_{end}_x": own[0], f"inertia_{end}_y": own[1], f"inertia_{end}": mp.norm(own)}
    return found


def true_accelerations(drive: Drive, time: Real) -> dict[str, Real]:
    of_a, of_b = (drive.acceleration(time, share) for share in (0, 1))
    unit = drive.rod(time) * drive.ratio
    square, replaced = mp.matrix([-unit[1], unit[0]]), of_a - of_b
    found = {
        "common_acceleration": -of_b[0],
        "turning_acceleration": -(replaced.T * square)[0],
        "stretching_acceleration": (replaced.T * unit)[0],
    }
    for name, own in (("pin", of_a), ("replaced", replaced), ("common", of_b)):
        found.setdefault(f"{name}_acceleration", mp.norm(own))
        found |= {f"{name}_acceleration_along": -own[0], f"{name}_acceleration_across": -own[1]}
    return found


def true_moving_forces(drive: Drive, body: Body, time: Real) -> dict[str, Real]:
    """What the kinetic energy of each model gains over the path of the crosshead."""
    velocity = -mp.diff(lambda at: drive.place(at, 1)[0], time)
    models = {"": body, "_two_mass": pair(mp.mpf("0.35")), "_railway": pair(mp.mpf("0.4"))}
    return {
        f"inertia_mollier{model}": mp.diff(lambda at, own=own: energy(drive, own, at), time) / velocity
        for model, own in models.items()
    }


def pair(crosshead: Real) -> Body:
    return [Mass(mp.mpf(0), 1 - crosshead), Mass(mp.mpf(1), crosshead)]


@pytest.mark.parametrize(("ratio", "offset"), [("0.2", "0"), ("0.28", "0.4"), ("0.55", "-0.3")])
def test_every_cell_is_the_force_that_holds_point_masses_under_a_part(ratio: str, offset: str) -> None:
    drive, body = Drive(mp.mpf(ratio), mp.mpf(offset)), spread(mp.mpf("0.35"), mp.mpf("0.35") ** 2)
    words = (f"--ratio={ratio}", f"--offset={offset}", "--centre=0.65", "--gyration=0.35")
    shown = [key for key in KEYS if not key.endswith(("_n", "_nm", "_mps2"))]
    assert len(shown) == 22 + 12 + 3 + 11
    for found in records(*words, "--angle=37;151;262.5", "--columns=phi," + ",".join(shown)):
        time = found["phi"] * mp.pi / 180
        true = true_forces(drive, body, time) | true_accelerations(drive, time)
        true |= true_moving_forces(drive, body, time)
        for key in shown:
            assert abs(found[key] - true[key]) <= mp.mpf("0.00005001"), (key, found["phi"])


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
    crank = Crank(Fraction(1, 4), rod=Rod.from_crosshead(Fraction(13, 20), Fraction(7, 20)))
    scaled = Fraction(exact) * 10**decimals
    assert scaled.denominator == 2
    away = int(abs(scaled) + Fraction(1, 2)) * (1 if scaled > 0 else -1)
    found = certified(inertia_registry()[key], "exact", crank, Fraction(0), decimals)
    even = certified(inertia_registry()[key], "exact", crank, Fraction(0), decimals, "half-even")
    assert (found, even) == (away, away - away % 2 if away > 0 else away + away % 2)


@pytest.mark.parametrize(("ratio", "offset"), [("1/5", "0"), ("0.97", "0"), ("0", "0"), ("1/5", "0.3")])
def test_long_columns_have_the_digits_of_balls(ratio: str, offset: str) -> None:
    rod = Rod.from_crosshead(Fraction(37, 60), Fraction(1, 3), Fraction(80))
    speed = Speed(Fraction(2))
    crank = Crank(Fraction(ratio), Fraction(offset), radius=Fraction(3, 10), speed=speed, rod=rod)
    columns = [
        bare(one, "exact", one.decimals) for key in KEYS if is_known(one := inertia_registry()[key], crank)
    ]
    assert len(columns) == len(KEYS)
    angles = Progression(Fraction(0), Fraction(53, 4), 28)
    floats = columns_in_floats(columns, crank, angles, "half-away")
    balls = columns_in_balls(columns, crank, angles, "half-away")
    for column, found, true in zip(columns, floats, balls, strict=True):
        assert np.array_equal(np.asarray(found), np.asarray(true)), column.key


MACHINE = ("--stroke=600mm", "--speed=120/min")


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (
            ("--ratio=1:5", "--offset=2", "--layout=mollier", "--step=30"),
            "at 210° this offset crank stands at a dead centre, where no force at the crosshead moves the"
            " rod; leave the angle out, or the column inertia_mollier",
        ),
        (
            ("--ratio=1:5", *MACHINE, "--acceleration=50rad/s2", "--columns=inertia_mollier"),
            "column inertia_mollier is in M R ω² and needs --centre and --gyration and a crank that turns"
            " evenly",
        ),
        (
            ("--layout=ensslin-forces", "--method=series"),
            'method "series" has no formula for inertia_a_common; use exact',
        ),
        (
            ("--columns=inertia_a_n",),
            "column inertia_a_n is in N and needs --rod-mass and --stroke and --speed",
        ),
        (
            ("--layout=ensslin-masses", "--ratio=1:5"),
            "layout ensslin-masses is of the rod by itself, whose length --stroke and --ratio give together;"
            " add --stroke, or leave --ratio out",
        ),
        (
            ("--layout=ensslin-parts", "--mechanism=arc", "--rocker=6"),
            "layout ensslin-parts is about something else; choose from ensslin-forces-rocker, ",
        ),
        (
            ("--columns=phi,inertia_mollier", "--mechanism=arc", "--rocker=6"),
            "column inertia_mollier is a force along a slide, and the arc crank has none; leave it out",
        ),
    ],
)
def test_what_has_no_answer_gets_a_sentence(words: tuple[str, ...], said: str) -> None:
    assert refusal("inertia", "--centre=0.65", "--gyration=0.35", *words).startswith(said)


def test_two_masses_move_past_the_dead_centre_of_an_offset_crank() -> None:
    # At φ = 210° the rod stands in line with the crank: e = 2 R, L = 5 R.
    rod = ("--ratio=1:5", "--offset=2", "--centre=0.65", "--gyration=0.35", "--angle=210")
    (found,) = records(*rod, "--columns=common_acceleration,inertia_mollier_two_mass,inertia_mollier_railway")
    p = found["common_acceleration"]
    assert abs(found["inertia_mollier_two_mass"] - mp.mpf("0.35") * p) < mp.mpf("0.0001")
    assert abs(found["inertia_mollier_railway"] - mp.mpf("0.4") * p) < mp.mpf("0.0001")


def speeding_up(drive: Drive, begin: Real, share: Real) -> Real:
    """The acceleration of a point of the rod in R ω² where the crank has α = 0.3 ω²."""

    def place(time: Real, i: int) -> Real:
        return drive.place(begin + time + mp.mpf("0.15") * time * time, share)[i]

    return mp.matrix([mp.diff(lambda time, i=i: place(time, i), 0, 2) for i in (0, 1)])


def test_an_accelerated_crank_adds_its_own_to_every_part() -> None:
    # ω = 10/s and α = 30/s², so α/ω² = 0.3.
    rod = ("--ratio=1:4", "--centre=0.65", "--gyration=0.35", "--stroke=600mm", "--speed=10rad/s")
    keys = [f"{name}_acceleration_{way}" for name in ("pin", "replaced") for way in ("along", "across")]
    forces = [f"inertia_{force}" for force in ("guide", "pin_x", "pin_y", "torque")]
    of_parts = [f"{force}_{part}" for force in forces for part in PARTS]
    words = (*rod, "--acceleration=30rad/s2", "--angle=37;220", "--digits=30")
    drive = Drive(mp.mpf("0.25"), mp.mpf(0))
    for found in records(*words, "--columns=" + ",".join(["phi", *keys, *forces, *of_parts])):
        begin = found["phi"] * mp.pi / 180
        of_a, of_b = (speeding_up(drive, begin, share) for share in (0, 1))
        true = [-of_a[0], -of_a[1], of_b[0] - of_a[0], of_b[1] - of_a[1]]
        assert mp.norm(mp.matrix([found[key] for key in keys]) - mp.matrix(true)) < 1e-15
        for force in forces:
            assert abs(sum(found[f"{force}_{part}"] for part in PARTS) - found[force]) < mp.mpf("3e-30")


@pytest.mark.parametrize("drive", [("arc", "--rocker=5", "--pivot=4.2;-5.1"), ("beam", "--beam=3")])
def test_the_parts_add_up_where_the_rod_moves_a_rocker(drive: tuple[str, ...]) -> None:
    forces = ("guide", "pin_x", "pin_y", "torque")
    keys = [f"inertia_{force}" for force in forces]
    keys += [f"inertia_{force}_{part}" for force in forces for part in PARTS]
    ends = [f"{end}_{mark}" for end in "ab" for mark in "xy"]
    keys += [f"inertia_{end}" for end in ends]
    keys += [f"inertia_{end[0]}_{part}_{end[2]}" for end in ends for part in PARTS[:2]]
    keys += ["inertia_a_stretching_x", "inertia_a_stretching_y"]
    motion = [f"{name}_acceleration" for name in ("common", "replaced", "pin")]
    keys += [f"{name}_{way}" for name in motion for way in ("along", "across")]
    words = ("--ratio=3:10", "--centre=0.65", "--gyration=0.35", "--mechanism", *drive, "--digits=30")
    for found in records(*words, "--angle=37;250", "--columns=" + ",".join(keys)):
        last = mp.mpf("3e-30")
        for force in forces:
            whole = sum(found[f"inertia_{force}_{part}"] for part in PARTS)
            assert abs(whole - found[f"inertia_{force}"]) <= last, force
        for end in ends:
            of_parts = [f"inertia_{end[0]}_{part}_{end[2]}" for part in PARTS]
            assert abs(sum(found.get(key, 0) for key in of_parts) - found[f"inertia_{end}"]) <= last, end
        for way in ("along", "across"):
            common, replaced, pin = (found[f"{name}_{way}"] for name in motion)
            assert abs(common + replaced - pin) <= last
        # What both ends bear is what accelerates the centre of mass, a = 0.65 L from B.
        for mark, way in (("x", "along"), ("y", "across")):
            centre = found[f"common_acceleration_{way}"] + found[f"replaced_acceleration_{way}"] * mp.mpf(
                "0.65"
            )
            assert abs(found[f"inertia_a_{mark}"] + found[f"inertia_b_{mark}"] + centre) <= last


@pytest.mark.parametrize("drive", ["--mechanism=arc --rocker=6", "--mechanism=beam --beam=4"])
def test_the_end_on_a_rocker_is_no_b_and_has_no_direction_of_the_common_acceleration(drive: str) -> None:
    words = ("inertia", "--ratio=1:5", "--centre=0.6", "--gyration=0.3", "--angle=30", "--lang=en")
    for more, letter in (("", "B"), (drive, "G")):
        page = printed(
            *words, *more.split(), "--columns=inertia_b,inertia_b_turning,inertia_b_stretching"
        ).out
        assert [f"Force in {one}" in page for one in "BG"] == [letter == "B", letter == "G"]
        assert f"{letter}₄/(M R ω²)" in page
    printed(*words, "--columns=inertia_b_common")
    assert 'no column "inertia_b_common"' in refusal(*words, *drive.split(), "--columns=inertia_b_common")


def test_beside_a_dead_centre_of_an_offset_crank_no_float_is_trusted() -> None:
    rod = Rod.from_crosshead(Fraction(3, 5), Fraction(7, 20))
    crank, column = Crank(Fraction(1, 5), Fraction(2), rod=rod), inertia_registry()["inertia_mollier"]
    columns, angles = [bare(column, "exact", 9)], Progression(Fraction(209999, 1000), Fraction(1, 1500), 4)
    assert float_bound(columns[0], crank, 360) == float("inf")
    (floats,) = columns_in_floats(columns, crank, angles, "half-away")
    (balls,) = columns_in_balls(columns, crank, angles, "half-away")
    assert floats.tolist() == list(balls)
    assert min(map(abs, balls)) > 1000 * 10**9
    at_rest = kurbel.compute([210], "1:5", "inertia_mollier", offset=2, centre=0.6, gyration=0.35)
    assert np.isinf(at_rest["inertia_mollier"]).all()
