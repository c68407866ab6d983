"""Names that must be one of a few: the nearest is named and all are listed."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from kurbel.errors import ChoiceError


def choose(name: str, allowed: Iterable[str], what: str) -> str:
    """Return the name if it is allowed, else raise ChoiceError with the nearest name and the list."""
    names = list(allowed)
    if not isinstance(name, str):
        raise ChoiceError(f"{what} is {name!r}; choose from {', '.join(names)}")
    if name in names:
        return name
    raise ChoiceError(
        f'there is no {what} "{name[:60]}"{did_you_mean(name, names)}; choose from {", ".join(names)}'
    )


def did_you_mean(name: str, names: Sequence[str]) -> str:
    """Return a question with the nearest of the names, or nothing if none is near."""
    from difflib import get_close_matches

    near = get_close_matches(name[:60].lower(), names, n=1, cutoff=0.5)
    return f" (did you mean {near[0]}?)" if near else ""
