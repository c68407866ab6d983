"""Programs and libraries that some tests need."""

from __future__ import annotations

import importlib.util
import os
import shutil
from typing import NoReturn

import pytest


def require(tool: str) -> str:
    """Return the path of a program; without it skip the test, or fail it where nothing may be missing."""
    return shutil.which(tool) or missing(tool)


def require_library(name: str) -> None:
    """Skip a test without a library of Python, or fail it where nothing may be missing."""
    if importlib.util.find_spec(name) is None:
        missing(name)


def missing(name: str) -> NoReturn:
    """Skip the test for want of a tool, or fail it where nothing may be missing."""
    if os.environ.get("CI") == "true":
        pytest.fail(f"{name} is not installed, and CI=true lets no test be skipped")
    # As it stands at the end behind a number of tests.
    pytest.skip(f"need {name.removesuffix(' (make tools)')} (make tools)")
