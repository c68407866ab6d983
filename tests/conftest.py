"""What tests share that takes long to start, or must be ended."""

from __future__ import annotations

import os
from collections.abc import Iterator

import pytest
from browser import Viewer, launched
from hypothesis import HealthCheck, settings
from programs import Programs

# How long an example takes says how busy the machine is.
settings.register_profile("kurbel", deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.load_profile("kurbel")


def pytest_configure() -> None:
    if os.environ.get("KURBEL_PROMOTE") == "1" and os.environ.get("CI", "").lower() not in ("", "0", "false"):
        raise pytest.UsageError(
            "KURBEL_PROMOTE=1 writes what is printed as what is expected, so that no test fails; in CI (the"
            " variable CI is set) it is refused: write golden files on a machine of your own, and read them"
        )


@pytest.fixture(scope="session")
def viewer() -> Iterator[Viewer]:
    """One browser for all tests of a session."""
    with launched() as viewer:
        yield viewer


@pytest.fixture
def programs() -> Iterator[Programs]:
    """Starts programs, and ends those that a test leaves running."""
    with Programs() as programs:
        yield programs
