"""Options that would change nothing are refused, with what helps."""

import pytest
from cli import refusal

POWER = "power --mean-pressure 5bar --working-strokes 2"
STEAM = "power --eps 3 --pressure 8bar"
RATIO = "solve --unknown ratio --angle 80 --where c=max"
TORQUE = "solve --eps 4 --where torque=max"
AREAS = "turning --areas +52;-124;+72 --area-scale 10J"
WHEEL = "flywheel --swing 5kJ --speed 300/min --delta 1%"
BALANCE = "balance --reciprocating 2kg --stroke 90mm --speed 3000/min"
ROD = "inertia --centre 0.65 --gyration 0.35"
MASSES = f"{ROD} --layout rod-masses"


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
    ],
)  # fmt: skip
def test_an_option_that_changes_nothing_is_refused(command: str, option: str, why: str) -> None:
    said = refusal(*command.split(), *option.split())
    assert option.split()[0] in said and why in said
