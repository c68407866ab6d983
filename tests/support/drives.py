"""Drives as they are typed, each with its geometry enclosed, and pages held against it cell by cell."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from typing import Any, NamedTuple

from kurbel import verify


class Drive(NamedTuple):
    """The words of a drive on a command line, and the same of `kurbel.verify`."""

    words: tuple[str, ...]
    true: verify.Drive

    @property
    def options(self) -> dict[str, Any]:
        """The words as Python takes them."""
        return dict(word.removeprefix("--").split("=", 1) for word in self.words)

    def __str__(self) -> str:
        return " ".join(self.words)


def typed(options: dict[str, Any]) -> tuple[str, ...]:
    return tuple(f"--{key.replace('_', '-')}={one}" for key, one in options.items())


def slide(ratio: str | Fraction, offset: str | Fraction = "0", **size: Any) -> Drive:
    words = typed({"ratio": ratio} | ({"offset": offset} if Fraction(offset) else {}))
    return Drive(words, verify.drive(ratio, offset, **size))


def arc(rod: str, rocker: str, pivot: str = "", circuit: int = 1, offset: str = "0", **size: Any) -> Drive:
    options = {"ratio": f"1:{rod}", "rocker": rocker, "pivot": pivot, "circuit": circuit}
    options |= {"offset": offset} if offset != "0" else {}
    words = typed({"mechanism": "arc"} | {key: one for key, one in options.items() if one})
    place = tuple(pivot.split(";")) if pivot else None
    true = verify.drive(1 / Fraction(rod), offset, rocker=rocker, pivot=place, circuit=circuit, **size)
    return Drive(words, true)


def beam(arm: str, rod: str, **size: Any) -> Drive:
    words = typed({"mechanism": "beam", "ratio": f"1:{rod}", "beam": arm})
    return Drive(words, verify.drive(1 / Fraction(rod), beam=arm, **size))


# A rocker in place of a slide, with an offset, on either side; shaft and pivot in a line with φ = 0, in both
# circuits; a rocker shorter than the rod and a rod shorter than the rocker, each swinging far; a pivot
# below, assembled both ways; links nearly in line.
ARCS = [
    arc("5", "6"),
    arc("4.5", "7", offset="0.7"),
    arc("3.5", "9", "3.7;-9.2"),
    arc("3", "2.5", "4;0"),
    arc("3", "2.5", "4;0", -1),
    arc("6.1", "1.3", "6.2;0.3"),
    arc("1.4", "5.2", "2.1;4.9", -1),
    arc("2.3", "3.1", "0.6;-2.7"),
    arc("2.3", "3.1", "0.6;-2.7", -1),
    arc("4", "3", "0.1;5.99"),
]
BEAMS = [beam("3", "5"), beam("1.7", "3.5"), beam("6.3", "9")]


def of_size(drive: Drive, radius: str, speed: str, force: str = "1") -> Drive:
    """The same drive with R in m, ω in rad/s and a force in N."""
    size = {"radius": Fraction(radius), "speed": Fraction(speed), "force": Fraction(force)}
    return drive._replace(true=type(drive.true)(**{**drive.true.__dict__, **size}))


def confirm(
    of: verify.Drive | verify.Bodies, rows: Iterable[dict[str, str]], keys: Iterable[str], **how: Any
) -> None:
    """Confirm each cell of these columns; an angle may be printed in another turn."""
    keys = list(keys)
    for row in rows:
        for key in keys:
            value = of.value(key, row["phi"], **how)
            shown = row[key]
            assert value.confirms(shown) == verify.CONFIRMED, (key, row["phi"], shown, float(value))
