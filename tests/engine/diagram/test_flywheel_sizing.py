"""Flywheels without an engine: every figure by arithmetic of its own, in mpmath, and what is refused."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from cli import printed
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath import mp, mpf

import kurbel
from kurbel.engine.diagram.relations import DISC_RULES, RULES
from kurbel.engine.diagram.sizing import Known, completed
from kurbel.exact.real import Product

F = Fraction
DIGITS = 18


@pytest.fixture(autouse=True)
def precise() -> Any:
    with mp.workdps(50):
        yield


def figures(words: str, *more: str) -> dict[str, Any]:
    """The one record of a flywheel, to many digits."""
    (record,) = printed("flywheel", *words.split(), *more, "--digits", str(DIGITS), "-f", "csv").records()
    return {key: mpf(value) for key, value in record.items() if ":" not in value}


def agree(found: dict[str, Any], **expected: Any) -> None:
    for key, value in expected.items():
        assert abs(found[key] - value) <= mpf(10) ** -DIGITS / 2, key


def rate(turns_a_minute: int) -> Any:
    return 2 * mp.pi * turns_a_minute / 60


def test_a_flywheel_has_the_angular_acceleration_at_an_angle_of_its_diagram() -> None:
    found = figures("--speed 180/min --inertia 700kgm2 --angle 25", "--torque", "900 + 95sin(2φ) - 57cos(2φ)")
    agree(found, angular_acceleration=(95 * mp.sin(5 * mp.pi / 18) - 57 * mp.cos(5 * mp.pi / 18)) / 700)


@pytest.mark.parametrize(("turns", "words"), [(1, ""), (2, "--turns 2")])
def test_power_and_the_coefficient_of_fluctuation_give_the_swing(turns: int, words: str) -> None:
    found = figures(f"--power 300kW --speed 90/min --energy-fluctuation 0.1 --delta 1% --radius 2m {words}")
    work = mpf(300_000) * turns / (mpf(90) / 60)
    mass = work / 10 / (mpf("0.01") * rate(90) ** 2) / 4
    agree(found, work=work, swing=work / 10, mass=mass, mean_torque=300_000 / rate(90))


def test_a_press_between_two_speeds_gives_motor_and_flywheel() -> None:
    found = figures("--work 10kJ --strokes 30/min --share 1/4 --speed 200..225/min")
    agree(found, power=mpf(5000), swing=mpf(7500), delta=mpf(25) / mpf("212.5"))
    assert figures("--work 10kJ --strokes 30/min --share 25% --speed 225/min..200/min") == found
    agree(found, inertia=2 * 7500 / (rate(225) ** 2 - rate(200) ** 2))
    agree(figures("--power 3kW --work 9kJ --share 0"), strokes=mpf(20))


def test_a_stroke_that_takes_its_time_leaves_the_flywheel_what_the_motor_does_not_give() -> None:
    found = figures(
        "--power 3kW --work 10kJ --duration 1s --greatest-speed 300/min --mass 150kg --radius 0.6m"
    )
    # In that second the motor gives 3 kJ; 10 kJ take it 10/3 s.
    low = mp.sqrt(rate(300) ** 2 - 2 * mpf(7000) / 54)
    agree(found, strokes=mpf(18), swing=mpf(7000), least_speed=low * 30 / mp.pi)
    both = figures("--work 10kJ --share 1/4 --duration 1.5s --speed 200..225/min")
    agree(both, strokes=mpf(10), power=mpf(10_000) / 6, swing=mpf(7500))


def test_a_hole_has_the_work_of_its_sheared_area() -> None:
    press = "--strokes 6/min --duration 1.5s --speed 200..225/min"
    found = figures(f"--shear-energy 7J/mm² {press} --efficiency 80%", "--hole", "38mm x 32mm")
    work = mp.pi * 38 * 32 * 7
    agree(found, work=work, power=work / 10, motor_power=work / 8, swing=work * mpf("0.85"))
    # The force falls from π d t τ to 0 as the punch goes through.
    found = figures(f"--shear-strength 300MPa {press}", "--hole", "25mm × 18mm")
    agree(found, work=mp.pi * 25 * 18 * 300 * mpf("0.018") / 2)
    slow = figures(
        "--shear-energy 7J/mm² --power 2kW --duration 1.5s --speed 200..225/min", "--hole", "38mm x 32mm"
    )
    work = mp.pi * 38 * 32 * 7
    agree(slow, strokes=60 * 2000 / work, swing=work - 3000)


def test_sizes_of_a_rim_and_of_a_disc_give_their_masses() -> None:
    rim = figures("--rim-diameter 2.1m --density 7200kg/m3", "--rim-section", "300mm x 150mm")
    mass = 7200 * mpf("0.3") * mpf("0.15") * mp.pi * mpf("2.1")
    agree(rim, rim_mass=mass, inertia=mass * mpf("1.05") ** 2)
    sides = figures("--rim-diameter 2.1m --density 7200kg/m3", "--rim-section", "300 x 150 mm")
    assert rim == sides
    area = figures("--rim-diameter 2.1m --density 7200kg/m3 --rim-section 450cm2")
    agree(area, rim_mass=rim["rim_mass"])
    disc = figures(
        "--swing 1kJ --speed 300/min --disc-diameter 0.6m --disc-thickness 80mm --density 7.85t/m3"
    )
    mass = 7850 * mp.pi * mpf("0.09") * mpf("0.08")
    agree(disc, mass=mass, inertia=mass * mpf("0.09") / 2, radius=mp.sqrt(mpf("0.045")))
    agree(disc, delta=1000 / (mass * mpf("0.045") * rate(300) ** 2))


def test_the_flywheel_of_an_engine_has_a_rim(tmp_path: Path) -> None:
    engine = "--eps 3 --ratio 1:4 --power 50kW --speed 120/min --delta 1:100"
    own = figures(engine)
    found = figures(engine, "--rim-diameter", "3m", "--density", "7200kg/m3", "--rim-section", "2:1")
    agree(found, **{key: own[key] for key in ("power", "mean_torque", "swing", "inertia")})
    assert abs(found["rim_mass"] - own["inertia"] / mpf("2.25")) < mpf("1e-15")
    # A machine's file says the same, and gives way to what is typed.
    path = tmp_path / "machine.toml"
    rim = 'rim_diameter = "3m"\ndensity = "7200kg/m3"\nrim_section = "2:1"\ndelta = "1:50"\n'
    crank = '[crank]\nratio = "1:4"\nspeed = "120/min"\n'
    path.write_text(f"{crank}[flywheel]\n{rim}", encoding="utf-8")
    assert figures("--eps 3 --power 50kW --delta 1:100", "--machine", str(path)) == found
    alone = figures("--swing 5kJ --inertia 100kgm2", "--machine", str(path))
    agree(alone, delta=5000 / (100 * rate(120) ** 2), rim_mass=100 / mpf("2.25"))


def test_areas_and_a_torque_give_their_swings() -> None:
    # +52, -124, ...: at most 52 after the first, at least 52 - 124 + 92 - 140 = -120 after the fourth.
    scale = ("--areas", "+52;-124;+92;-140;+85;-72;+107", "--area-scale", "500 N m; 6°")
    found = figures("--speed 600/min --delta ±1.5%", *scale)
    agree(found, swing=172 * 500 * 6 * mp.pi / 180)
    # 1500 sin 3φ has the energy 500 (1 - cos 3φ), its mean 5000 N m the work 10 kJ π.
    found = figures("--speed 300/min --inertia 200kgm2", "--torque", "5000 + 1500 sin(3φ)")
    agree(found, swing=mpf(1000), mean_torque=mpf(5000), energy_fluctuation=1 / (10 * mp.pi))
    agree(found, power=5000 * rate(300), delta=1000 / (200 * rate(300) ** 2))
    text = printed(
        "flywheel", "--speed", "300/min", "--inertia", "200kgm2", "--torque", "5000 + 1500 sin(3φ)"
    )
    assert "φ = 60°, 180°, 300°" in " ".join(text.out.split())


@pytest.mark.parametrize(("waves", "more"), [(8, ""), (9, ", ...")])
def test_of_many_places_of_one_speed_the_first_eight_are_named(waves: int, more: str) -> None:
    torque = ("--torque", f"5000 + 1500 sin({waves}φ)", "--lang=en")
    text = printed("flywheel", "--speed=300/min", "--inertia=200kgm2", *torque).out
    greatest, least = (
        ", ".join(f"{180 * (2 * place + first) / waves:g}°" for place in range(8)) for first in (1, 0)
    )
    assert f"greatest at φ = {greatest}{more}, least at φ = {least}{more}" in " ".join(text.split())


positive = st.fractions(F(1, 50), 100, max_denominator=50)


@settings(deadline=None, max_examples=10)
@given(st.data())
def test_every_figure_follows_from_the_others_as_it_was(data: st.DataObject) -> None:
    energies, wheel = ("efficiency", "swing", "work", "cycles"), ("omega", "delta", "radius")
    names = (*energies, *wheel, "run_up_time", "density", "rim_diameter", "rim_share", "proportion")
    one = {name: Product.of(data.draw(positive), data.draw(st.integers(-1, 1))) for name in names}
    one["delta"] = Product.of(data.draw(st.fractions(F(1, 1000), F(3, 2), max_denominator=1000)))
    all_known = completed({name: Known(value, ()) for name, value in one.items()})
    rules = [rule for rule in RULES if all_known.keys() >= {rule.of, *rule.needs}]
    # But for the disc nothing is left out.
    assert len(rules) == len(RULES)
    rule = data.draw(st.sampled_from(rules))
    value = rule.value({name: all_known[name].value for name in rule.needs})
    assert value.equals(all_known[rule.of].value), rule.of
    disc = {f"disc_{name}" for name in ("diameter", "thickness", "share", "stress", "bulge")}
    assert {rule.of for rule in DISC_RULES} == {"inertia", "mass", "density", "omega", *disc}


@pytest.mark.parametrize(
    ("words", "speed", "share"),
    [
        ("--rim-speed 25m/s --delta 3%", 25, F(3, 100)),
        ("--rim-speed 28..26m/s", 27, F(2, 27)),
        ("--hoop-stress 4.5MPa --density 7200kg/m3 --delta 3%", 25, F(3, 100)),
    ],
)
def test_the_mass_of_a_rim_follows_from_its_speed(words: str, speed: int, share: F) -> None:
    # Holes of 38 mm in 32 mm, 7 J for a mm², of which the motor gives 32/200 while one is punched.
    swing = 7 * mp.pi * 38 * 32 * mpf("0.84")
    page = "--hole 38mmx32mm --shear-energy 7J/mm2 --strokes 6/min --punch-stroke 100mm"
    found, delta = figures(f"{page} {words}"), mpf(share.numerator) / share.denominator
    agree(found, swing=swing, rim_speed=mpf(speed), delta=delta, rim_mass=swing / (speed**2 * delta))
    assert "speed" not in found
    # The energies at both speeds differ by the swing; with a speed of rotation the same follows.
    high, low = speed * (1 + delta / 2), speed * (1 - delta / 2)
    assert abs(found["rim_mass"] * (high**2 - low**2) / 2 - swing) < mpf("1e-10")
    turning = figures(f"{page} {words} --speed 100/min --rim-share 0.9")
    agree(turning, rim_mass=swing * mpf("0.9") / (speed**2 * delta), speed=mpf(100))


@pytest.mark.parametrize("cranks", [(), ("--cranks=0;360",)])
def test_power_and_speed_give_the_scale_of_triangles(cranks: tuple[str, ...]) -> None:
    # 20 kW at 300/min are 8 kJ in two turns, 12 kJ of the expansion; its triangle, of the height h, stands
    # out above the mean h/12. Two such cylinders have half of it each: twice above it, by (1 - 1/6)² of 6 kJ.
    page = "--triangles 0;-1;3;0 --turns 2 --power 20kW --speed 300/min --delta 4%"
    swing = F(12000) * F(11, 12) ** 2 if not cranks else F(6000) * F(5, 6) ** 2
    found = figures(page, *cranks)
    agree(found, work=mpf(8000), swing=mpf(swing.numerator) / swing.denominator)
    agree(found, inertia=found["swing"] / (rate(300) ** 2 * mpf("0.04")))


def test_several_irregularities_are_kept_by_as_many_flywheels() -> None:
    page = kurbel.flywheel(swing=5000, speed=5, delta="1:50;±2%", columns="target,inertia", digits=6)
    inertias = [5000 / (delta * rate(300) ** 2) for delta in (mpf("0.02"), mpf("0.04"))]
    rows = [f"{target},{float(one):.6f}" for target, one in zip(("0.02", "0.04"), inertias, strict=True)]
    assert kurbel.typeset(page, "csv").splitlines() == ["target,inertia", *rows]
