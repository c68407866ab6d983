"""Units as people write them, in one spelling: kg*m*m of kg m^2, /min of min⁻¹, N/mm/mm of N·mm⁻²."""

from __future__ import annotations

import re
from collections.abc import Iterator

_SUPERSCRIPTS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻−", "0123456789+--")
_FACTOR = (
    r"\s*(?P<name>[A-Za-zµμ_]+)"
    r"(?:\s*(?:\^|\*\*)\s*(?P<power>\(\s*[+-]?[1-9]\s*\)|[+-]?[1-9])(?!\d)|(?P<behind>[+-]?[1-9])(?!\d))?"
)
_SIGN = r"\s*([*·×⋅/]|-(?=[A-Za-z])|)\s*"
_OVER = frozenset(("/", "per", "je", "pro"))
# Two units written as one, of which only the last has the power.
_JOINED = r"([kMm]?N|kg)(m)|(lbf?)(ft)"
# Umdrehungen and Pferdestärken, as German data sheets write them: pint's U is the unit of enzymes, and its PS
# are petasiemens.
_NAMES = {
    "μm": "µm", "U": "turn", "Umdr": "turn", "rev": "turn", "PS": "metric_horsepower", "Zoll": "in",
    "sec": "s", "sek": "s", "Sek": "s", "Upm": "rpm", "UPM": "rpm", "RPM": "rpm", "r": "turn",
}  # fmt: skip
_WHOLE = {"turn/min": "rpm", "turn/s": "/s"}
# Longer ones are not written; their powers are multiplied out.
_MOST = 12


def plain_unit(text: str) -> str | None:
    """Return a unit as factors without powers, N/mm/mm, or None for what is no product of units.

    A stroke is over the next factor only.
    """
    above: list[str] = []
    below: list[str] = []
    try:
        for name, power in _factors(text.translate(_SUPERSCRIPTS).strip()):
            (above if power > 0 else below).extend([name] * abs(power))
    except ValueError:
        return None
    if not 0 < len(above) + len(below) <= _MOST:
        return None
    found = "*".join(above) + "".join(f"/{name}" for name in below)
    return _WHOLE.get(found, found)


def _factors(text: str) -> Iterator[tuple[str, int]]:
    """Yield the names and their powers; raise ValueError for anything else."""
    rest, sign = re.sub(r"^1\s*(?=/)", "", text), 1
    if rest.startswith("/"):
        rest, sign = rest[1:], -1
    while rest:
        match = re.match(_FACTOR, rest)
        if match is None:
            raise ValueError(text)
        name, rest = match["name"], rest[match.end() :]
        if name in _OVER:
            sign = -1
            continue
        power = sign * int((match["power"] or match["behind"] or "1").strip("() "))
        joined = re.fullmatch(_JOINED, name)
        first, last = [one for one in joined.groups() if one] if joined else ("", name)
        if first:
            yield first, sign
        yield _NAMES.get(last, last), power
        between = re.match(_SIGN, rest)
        assert between is not None
        sign, rest = -1 if between[1] in _OVER else 1, rest[between.end() :]
        if between[1] and not rest:
            raise ValueError(text)
