"""The connecting rod as it is given, by its centre of mass and gyration or by a file."""

from __future__ import annotations

import os
from dataclasses import replace
from fractions import Fraction

from kurbel.drive.rod import Rod
from kurbel.drive.rod_file import read_rod
from kurbel.errors import ProblemError


def given_rod(
    centre: Fraction | None,
    gyration: Fraction | None,
    file: str | os.PathLike[str] | None,
    mass: Fraction | None,
    length: Fraction | None,
) -> Rod:
    """Return the rod: a/L from the crosshead pin and k/L, or a file; its mass in kg and length in metres."""
    if file is None:
        if centre is None or gyration is None:
            raise ProblemError(
                "the rod's masses are not known; give its centre and its gyration, such as"
                " --centre 0.6 --gyration 0.4, or --rod-file"
            )
        return Rod.from_crosshead(centre, gyration, mass)
    if centre is not None or gyration is not None:
        raise ProblemError("the rod's file has its masses; leave centre and gyration out")
    rod = read_rod(file, length)
    if mass is None:
        return rod
    if rod.mass is not None:
        raise ProblemError("the rod's file has its mass in kg; leave the mass out")
    return replace(rod, mass=mass)
