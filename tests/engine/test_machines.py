"""Every drive under every load prints what its turn in small steps gives, to the last digit."""

from __future__ import annotations

from itertools import product

import pytest
from machines import LOADS, MECHANISMS, Draw, compared

# Simpson's rule is off by 10^-7 where a force has a corner.
SAMPLES, MACHINES = 30_000, 2


@pytest.mark.parametrize(("mechanism", "load"), [*product(MECHANISMS, LOADS)])
def test_a_machine_turns_as_the_sum_over_small_steps_says(mechanism: str, load: str) -> None:
    draw = Draw(len(mechanism) + len(load))
    for _ in range(MACHINES):
        machine = draw.machine(mechanism, load)
        assert compared(machine, SAMPLES) < 0.51, machine.options
