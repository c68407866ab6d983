"""The function of `import kurbel` about worked examples."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction

from kurbel.page.table import Table
from kurbel.reading import notation
from kurbel.reading.given import Exact, as_angle, as_fraction, as_ratio, as_share, read_values


def make_example_table(
    source: str,
    number: str | int,
    *,
    ratios: Exact | Iterable[Exact] | None = None,
    angles: Exact | Iterable[Exact] | None = None,
    beam_arms: Exact | Iterable[Exact] | None = None,
    force: Exact | None = None,
    expansions: Exact | Iterable[Exact] | None = None,
    back: Exact | None = None,
    lang: str = "de",
    label: str = "",
) -> Table:
    """Return a worked example of a book, or the same with other numbers: `kurbel example`.

    `beam_arms` are a/r, `force` is the piston force in newtons, `expansions` are ε, `back` is R/Q. Which of
    these an example takes, `kurbel example` lists. Raises KurbelError.

    >>> from kurbel import typeset
    >>> print(typeset(make_example_table("blau", 35), "csv").splitlines()[-1])
    ,"cos α = −5/2, unbrauchbar",other,cos α,−5/2,−5/2,
    """
    from kurbel.examples.page import build_example
    from kurbel.examples.request import ExampleRequest

    own: dict[str, Sequence[Fraction]] = {}
    if ratios is not None:
        own["ratio"] = read_values(ratios, notation.ratios, as_ratio)
    if angles is not None:
        own["angle"] = read_values(angles, notation.angles, as_angle)
    if beam_arms is not None:
        own["beam"] = read_values(beam_arms, lambda texts: notation.numbers(texts, "beam arm"), as_fraction)
    if expansions is not None:
        own["eps"] = read_values(expansions, lambda texts: notation.numbers(texts, "expansion"), as_fraction)
    if back is not None:
        own["back"] = (as_share(back),)
    if force is not None:
        own["force"] = (as_fraction(force),)
    return build_example(ExampleRequest(source=source, number=str(number), own=own, lang=lang, label=label))
