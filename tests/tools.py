"""Programs that some tests need."""

from __future__ import annotations

import os
import shutil

import pytest


def require(tool: str) -> str:
    """Return the path of a program; without it skip the test, or fail it where nothing may be missing."""
    path = shutil.which(tool)
    if path:
        return path
    reason = f"{tool} is not installed"
    if os.environ.get("CI") == "true":
        pytest.fail(f"{reason}, and CI=true lets no test be skipped")
    pytest.skip(reason)
