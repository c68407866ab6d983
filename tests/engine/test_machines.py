"""Every drive under every load prints what its turn by quadrature gives, to the last digit."""

from __future__ import annotations

from itertools import product

import pytest
from drawn_machines import LOADS, MECHANISMS, Draw, compared


@pytest.mark.parametrize(("mechanism", "load"), [*product(MECHANISMS, LOADS)])
def test_a_machine_turns_as_quadrature_says(mechanism: str, load: str) -> None:
    draw = Draw(len(mechanism) + len(load))
    for _ in range(2):
        options = draw.machine(mechanism, load)
        assert compared(options) < 0.51, options
