"""Integrals in balls end as everything else does where a signal ends the command."""

from __future__ import annotations

from typing import Any

import pytest
from flint import acb, arb

from kurbel.exact.continued import integrated


@pytest.mark.parametrize("end", [KeyboardInterrupt(), SystemExit(143)], ids=["Ctrl-C", "SIGTERM"])
def test_what_ends_the_command_passes_through_an_integral(end: BaseException) -> None:
    def ended(place: Any, analytic: bool) -> Any:
        raise end

    with pytest.raises(type(end)) as raised:
        integrated(ended, arb(0), arb(1))
    assert raised.value is end


def test_the_integral_of_a_power_is_enclosed() -> None:
    found = integrated(lambda place, analytic: place * place, arb(0), arb(3))
    assert found.real.contains(9)
    assert found.real.rad() < 1e-10
    assert isinstance(found, acb)
