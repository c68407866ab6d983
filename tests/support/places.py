"""Where the tests find files."""

from __future__ import annotations

from pathlib import Path

TESTS = Path(__file__).parents[1]
ROOT = TESTS.parent
CARDS = TESTS / "cards"
GOLDEN = TESTS / "golden"
TRANSCRIPTS = TESTS / "transcripts"
SOURCES = TESTS / "sources"
SUPPORT = TESTS / "support"
