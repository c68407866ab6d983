"""Indicator cards of one turn from their files."""

from __future__ import annotations

from pathlib import Path

from kurbel.engine.card.card import Card
from kurbel.engine.card.file import read_card as read_any


def read_card(path: Path | str) -> Card:
    """Return the card in a file that has positions, p_forward and p_return."""
    card = read_any(path)
    assert isinstance(card, Card)
    return card
