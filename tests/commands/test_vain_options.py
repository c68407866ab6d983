"""Options that would change nothing are refused, with what helps."""

import pytest
from cli import printed, refusal

POWER = "power --mean-pressure 5bar --working-strokes 2"
STEAM = "power --eps 3 --pressure 8bar"
RATIO = "solve --unknown ratio --angle 80 --where c=max"
TORQUE = "solve --eps 4 --where torque=max"
AREAS = "turning --areas +52;-124;+72 --area-scale 10J"
WHEEL = "flywheel --swing 5kJ --speed 300/min --delta 1%"
BALANCE = "balance --reciprocating 2kg --stroke 90mm --speed 3000/min"
ROD = "inertia --centre 0.65 --gyration 0.35"
MASSES = f"{ROD} --layout rod-masses"
EPS = "delta --eps 4"
INERTIA = f"{EPS} --inertia 3600kgm2 --power 50kW --speed 120/min"
ENGINE = "flywheel --eps 4 --power 50kW --speed 120/min --delta 1:100"
MOVED = "pressures --reciprocating 300kg --stroke 600mm --bore 300mm --speed 120/min"
PRESSED = "pressures --eps 4 --bore 300mm --pressure 8bar"
HARMONICS = "harmonics --quantity torque --eps 4"
UNKNOWN = "solve --unknown speed --angle 0 --stroke 600mm --where p=50m/s2"
ROCKER = f"{ROD} --mechanism arc --rocker 6"
RATIOS = (
    *(EPS, f"{EPS} --detail", f"{EPS} --flywheel 50", INERTIA, "turning --eps 4", ENGINE, PRESSED),
    *("forces --eps 4", TORQUE, "harmonics", HARMONICS, "construct klein --table"),
)


@pytest.mark.parametrize(
    ("command", "option", "why"),
    [
        *((POWER, option, "that itself; leave it out") for option in ("--pressure 8bar", "--heat 10")),
        *((POWER, option, "by --working-strokes") for option in ("--single-acting", "--two-stroke")),
        *((STEAM, option, "add --bore") for option in ("--cylinders 2", "--cranks 0;90")),
        *(
            (RATIO, option, "is of forces")
            for option in ("--bore 300mm", "--back 1bar", "--friction 0.1", "--head-pressure 2bar",
                           "--vertical", "--pendulum 1.3s", "--two-stroke", "--cranks 0;90")
        ),
        *((RATIO, option, "the condition has none") for option in ("--stroke 1m", "--crank 1m")),
        *((TORQUE, option, "with --bore") for option in ("--crank 1m", "--true-stroke 1m")),
        (AREAS, "--turns 2", "over the crank angle"),
        (WHEEL, "--turns 2", "add --torque"),
        (WHEEL, "--efficiency 80%", "add --power"),
        (BALANCE, "--balance-radius 300mm", "add --share 0.5"),
        (ROD, "--gravity 9.81", "add --pendulum"),
        *((MASSES, option, "add --stroke") for option in ("--ratio 1:5",)),
        *((MASSES, option, "add --ratio") for option in ("--stroke 1m", "--crank 1m")),
        (f"{MASSES} --rod 1m", "--ratio 1:5", "--rod gives"),
        *((command, "--rod 1750mm", "gives the ratio with --stroke") for command in RATIOS),
        *(
            (f"plot {drawing} --eps 4 -f svg", option, why)
            for drawing in ("--turning", "--forces", "--polar")
            for option, why in (
                ("--rod 1m", "the ratio with --stroke"),
                ("--stroke 1m", "only with --bore"),
                ("--speed 120/min", "for moving masses"),
            )
        ),
        ("construct klein --table", "--stroke 1m", "gives the ratio with --rod"),
        (HARMONICS, "--stroke 1m", "only with --bore"),
        (HARMONICS, "--speed 120/min", "for moving masses"),
        (PRESSED, "--stroke 1m", "gives the ratio with --rod"),
        (INERTIA, "--stroke 1m", "for moving masses"),
        *((ENGINE, option, "--power gives") for option in ("--stroke 1m", "--bore 1m", "--pressure 8bar")),
        *(
            (f"{command} {load}", option, "only with --bore")
            for command in ("delta", "turning", "forces", "solve --where torque=max")
            for load, option in (
                ("--pressure-ratio 3", "--suction-pressure 0.9bar"),
                ("--compression 6 --heat 10", "--suction-pressure 0.9bar"),
                ("--pump", "--suction-pressure 0.9bar"),
                ("--pump", "--delivery-pressure 6bar"),
                ("--pump differential", "--delivery-pressure 6bar"),
            )
        ),
        *((MOVED, option, "of an engine") for option in ("--back 0.2", "--clearance 6%", "--pressure 7bar")),
        *((MOVED, option, "gas engine; add") for option in ("--heat 11", "--two-stroke", "--cycle otto")),
        *(
            (UNKNOWN, option, "condition is on the motion")
            for option in ("--force 1kN", "--bore 1m", "--back 0.2", "--friction 1N", "--vertical")
        ),
        (RATIO, "--method infinite", "a rod without a ratio"),
        (TORQUE, "--order 3", "series of the motion"),
        (ROCKER, "--method series", "no formulas for the arc crank"),
        ("power --eps 3", "--specific-volume 0.24m3/kg", "add --pressure"),
        ("power --pump", "--suction-pressure 0.9bar", "add --delivery-pressure"),
        ("flywheel --swing 5kJ --speed 300/min --delta 1%", "--rim-section 2:1", "add --rim-diameter"),
    ],
)  # fmt: skip
def test_an_option_that_changes_nothing_is_refused(command: str, option: str, why: str) -> None:
    said = refusal(*command.split(), *option.split(maxsplit=1))
    assert option.split()[0].removeprefix("--") in said and why in said


@pytest.mark.parametrize(
    ("given", "same"),
    [
        ("harmonics --stroke 600mm --rod 1m", "harmonics --ratio 3:10"),
        ("delta --eps 4 --stroke 600mm --offset 60mm", "delta --eps 4 --offset 0.2"),
        ("flywheel --eps 4 --power 9kW --speed 90/min --delta 1:50 --stroke 600mm --rod 1m",
         "flywheel --eps 4 --power 9kW --speed 90/min --delta 1:50 --ratio 3:10"),
    ],
)  # fmt: skip
def test_lengths_that_are_compared_with_each_other_count(given: str, same: str) -> None:
    assert printed(*given.split()).out == printed(*same.split()).out


@pytest.mark.parametrize(
    "command", ["turning", "turning --back 0.1", "delta --detail", "harmonics --quantity torque"]
)
def test_a_page_that_does_not_run_over_the_load_asks_for_it(command: str) -> None:
    said = refusal(*command.split())
    assert said.startswith("what acts on the piston is not known; add") and "--eps 4" in said
