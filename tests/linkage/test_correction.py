"""The couple that two masses in place of the rod of a rocker lack."""

from __future__ import annotations

import pytest
from cli import records


@pytest.mark.parametrize("drive", ["arc --rocker 6 --pivot 5;-5", "beam --beam 3"])
def test_two_masses_and_their_correction_have_the_couple_of_the_rod(drive: str) -> None:
    words = f"inertia --centre 0.6 --gyration 0.3 --mechanism {drive} --angle 0..360:30 --digits 12"
    keys = ("inertia_couple", "inertia_couple_two_mass", "inertia_correction")
    for row in records(*words.split(), f"--columns={','.join(keys)}"):
        whole, masses, correction = (float(row[key]) for key in keys)
        assert whole == pytest.approx(masses + correction, abs=2e-12)
        assert correction
