"""What tests share that takes long to start, or must be ended; at the end, what was skipped and why."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import pytest
from _pytest.terminal import TerminalReporter
from browser import Viewer, launched
from hypothesis import HealthCheck, settings
from manifests import SAMPLE, built
from programs import Programs
from tools import require_library

# How long an example takes says how busy the machine is.
settings.register_profile("kurbel", deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.load_profile("kurbel")


def pytest_configure() -> None:
    if os.environ.get("KURBEL_PROMOTE") == "1" and os.environ.get("CI", "").lower() not in ("", "0", "false"):
        raise pytest.UsageError(
            "KURBEL_PROMOTE=1 writes what is printed as what is expected, so that no test fails; in CI (the"
            " variable CI is set) it is refused: write golden files on a machine of your own, and read them"
        )


@pytest.hookimpl(trylast=True)
def pytest_terminal_summary(terminalreporter: TerminalReporter) -> None:
    skipped = Counter(one.longrepr[2] for one in terminalreporter.stats.get("skipped", ()))
    reasons = (f"{count} {why.removeprefix('Skipped: ')}" for why, count in skipped.most_common())
    if skipped:
        terminalreporter.write_line(f"skipped {skipped.total()}: {', '.join(reasons)}")


@pytest.fixture(scope="session")
def viewer() -> Iterator[Viewer]:
    """One browser for all tests of a session."""
    with launched() as viewer:
        yield viewer


@pytest.fixture(scope="session")
def sample(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The pages of a handbook with every kind of item, in every format and as a PDF."""
    for name in ("typst", "matplotlib"):
        require_library(name)
    return built(tmp_path_factory.mktemp("sample"), SAMPLE)


@pytest.fixture
def programs() -> Iterator[Programs]:
    """Starts programs, and ends those that a test leaves running."""
    with Programs() as programs:
        yield programs
