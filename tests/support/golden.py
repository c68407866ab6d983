"""Golden files: rendered pages that were read by eye, compared character by character."""

from __future__ import annotations

import os

from places import GOLDEN


def assert_golden(name: str, text: str) -> None:
    """Compare a text with the golden file of that name; with KURBEL_PROMOTE=1 write the file anew."""
    path = GOLDEN / name
    if os.environ.get("KURBEL_PROMOTE") == "1":
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text.encode())
    assert path.exists(), f"{path} is missing; look at the page, then promote it with KURBEL_PROMOTE=1"
    assert text == path.read_bytes().decode(), f"{name} differs; look at it, then promote it"
