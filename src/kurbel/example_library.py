"""The function of `import kurbel` about worked examples."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction

from kurbel import notation
from kurbel.given import Exact, as_angle, as_ratio, read_values
from kurbel.table import Table


def make_example_table(
    source: str,
    number: str | int,
    *,
    ratios: Exact | Iterable[Exact] | None = None,
    angles: Exact | Iterable[Exact] | None = None,
    lang: str = "de",
    label: str = "",
) -> Table:
    """Return a worked example of a book, or the same with other numbers: `kurbel example`.

    Which of the numbers an example takes, `kurbel example` lists. Raises KurbelError.

    >>> from kurbel import typeset
    >>> print(typeset(make_example_table("blau", 35), "csv").splitlines()[-1])
    ,"cos α = −5/2, unbrauchbar",other,cos α,−5/2,−5/2,
    """
    from kurbel.example_page import ExampleRequest, build_example

    own: dict[str, Sequence[Fraction]] = {}
    if ratios is not None:
        own["ratio"] = read_values(ratios, notation.ratios, as_ratio)
    if angles is not None:
        own["angle"] = read_values(angles, notation.angles, as_angle)
    return build_example(ExampleRequest(source=source, number=str(number), own=own, lang=lang, label=label))
