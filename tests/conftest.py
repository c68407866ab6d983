"""What tests share that takes long to start."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from browser import Viewer, launched


@pytest.fixture(scope="session")
def viewer() -> Iterator[Viewer]:
    """One browser for all tests of a session."""
    with launched() as viewer:
        yield viewer
