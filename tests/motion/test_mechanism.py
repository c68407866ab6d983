"""The mechanisms that are registered: what each says of itself fits its pages, and the others."""

from __future__ import annotations

import pytest
from cli import printed

from kurbel.drive.crank import Described
from kurbel.drive.load import LOADS
from kurbel.drive.mechanisms import MECHANISMS
from kurbel.motion.mechanism import mechanism, uncomputed
from kurbel.page.layouts import layout
from kurbel.page.subject import subject

each = pytest.mark.parametrize("name", MECHANISMS)


@each
def test_the_layouts_of_a_mechanism_are_about_it(name: str) -> None:
    one = mechanism(name)
    assert one.name == name
    assert {layout(key).subject for key in (one.layout, one.forces_layout)} == {one.subject}


@each
def test_what_is_drawn_of_a_mechanism_stands_in_its_tables(name: str) -> None:
    one = mechanism(name)
    known = subject(one.subject).quantities()
    assert {key for pair in one.motion for key in pair} <= set(known)
    assert any(share in known for share, _ in one.forces)


@each
def test_a_mechanism_is_described_by_options_that_there_are(name: str) -> None:
    assert set(mechanism(name).takes) <= set(Described._fields)
    assert name in printed("table", "--help").out.replace("\n", " ")


@each
def test_no_two_quantities_of_a_mechanism_have_one_name_in_conditions(name: str) -> None:
    names = [said for one in mechanism(name).conditions().values() for said in one.names]
    assert len(names) == len(set(names))


@pytest.mark.parametrize("load", LOADS)
def test_every_load_is_computed_of_a_mechanism_and_refused_of_the_others(load: str) -> None:
    sentences = {name: uncomputed(mechanism(name), load) for name in MECHANISMS}
    takers = [mechanism(name).title for name, sentence in sentences.items() if not sentence]
    assert takers
    for name, sentence in sentences.items():
        if sentence:
            assert sentence.startswith(f"{mechanism(name).title} under {LOADS[load].title} is not computed;")
            assert f"can act on {' or '.join(takers)}" in sentence
