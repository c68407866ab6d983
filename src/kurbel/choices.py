"""Names that must be one of a few: the nearest is named and all are listed."""

from __future__ import annotations

from collections.abc import Iterable

from kurbel.errors import ChoiceError


def choose(name: str, allowed: Iterable[str], what: str) -> str:
    """Return the name if it is allowed, else raise ChoiceError with the nearest name and the list."""
    names = list(allowed)
    if name in names:
        return name
    from difflib import get_close_matches

    near = get_close_matches(name.lower(), names, n=1)
    hint = f", did you mean {near[0]}?" if near else ";"
    raise ChoiceError(f'there is no {what} "{name[:60]}"{hint} There are: {", ".join(names)}')
