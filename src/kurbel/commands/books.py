"""What books print, against what it should be: their tables, and their worked examples."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from kurbel.books.collate_page import CollateRequest
from kurbel.books.example import numbers_of, source_keys
from kurbel.books.example_page import ExampleRequest
from kurbel.books.formula_page import FormulaRequest
from kurbel.books.printed_value import ONLY
from kurbel.books.source import FormulaTable
from kurbel.books.transcription import collated_table
from kurbel.commands.options import Choice, Columns, Kind, Option, alone, file, measure, word
from kurbel.commands.part import CommandOptions
from kurbel.commands.parts.angles import Angles
from kurbel.commands.parts.drive import Linked
from kurbel.commands.parts.sheet import Layouts, WordedPage, layout_option
from kurbel.commands.subject import function
from kurbel.errors import ProblemError
from kurbel.page.layouts import layout_of
from kurbel.reading import notation
from kurbel.reading.given import (
    as_angles,
    as_expansions,
    as_force,
    as_fraction,
    as_names,
    as_numbers,
    as_ratios,
    as_share,
)


class Source(Kind):
    """The key of a source; the page itself refuses a wrong one."""

    def known(self, typed: Mapping[str, object]) -> Iterable[str]:
        return source_keys()


class ExampleNumber(Kind):
    """The number of an example; which there are depends on the source."""

    def known(self, typed: Mapping[str, object]) -> Iterable[str]:
        return numbers_of(typed["book"]) if typed.get("book") in source_keys() else ()


def as_ratio_text(given: object, what: str) -> str:
    """Return a crank ratio as it is written. Raises KurbelError."""
    return given if isinstance(given, str) else notation.ratio_text(as_fraction(given))


class CollateOptions(Layouts, WordedPage, CommandOptions):
    """Print a table of a book, or your own transcription, with the values that it should have.

    Of formulas it prints whether each follows from the one before.

    \b
    kurbel collate roetscher-112  # a table of a book
    kurbel collate weisbach-150 --only deviations  # what is not right there
    kurbel collate --csv scan.csv --quantity p --ratio 1:4 --method series  # your own transcription
    kurbel collate blau-equations
    \f
    >>> import kurbel
    >>> page = kurbel.collate(
    ...     "blau-32", only="deviations", columns="place,printed,recomputed,verdict"
    ... )
    >>> print(kurbel.typeset(page, "csv"), end="")
    place,printed,recomputed,verdict
    x_45,"0,356","0,355",last_place
    """

    topic = "question"

    unnamed = "table"
    sequence = "csv quantity ratio method only columns sources"
    in_short = "quantity csv ratio method only strict sources columns"

    table = word("A table of a book, as `kurbel sources` lists it.", positional=True)
    csv = file("Your own transcription: phi, epsilon or arm, and printed values.")
    quantity = word("With --csv: what is printed, such as x, c, p or delta.", "KEY")
    ratio = measure(
        as_ratio_text, "With --csv: crank ratio, such as 1:4,5.", "R:L", short="-r", topic="crank"
    )
    method = word(
        "With --csv: exact (default), series, infinite, weisbach, approximate.", "METHOD", topic="crank"
    )
    only = word("all, or deviations: what is not right.", kind=Choice("choice", ONLY), default="all")
    columns: Option[Sequence[str]] = Option(
        "Keys of CSV and JSON and their order: place,printed,recomputed,verdict.", "NAMES",
        Columns("collation"), many=True, default=(), topic="page",
    )  # fmt: skip
    sources = file("A folder with books of your own, a folder each.", "DIR")
    layout = layout_option("collation")

    def question(self) -> CollateRequest | FormulaRequest:
        if self.says("csv") and self.says("table"):
            raise ProblemError("--csv is a table of your own, and one of a book is named too; leave one out")
        found, collated = collated_table(
            self.table, self.csv, self.quantity, self.ratio, self.method, self.sources
        )
        columns, words = as_names(self.columns, "place,printed,recomputed"), self.worded()
        name = self.layout or "collation"
        if not isinstance(found, FormulaTable):
            page = self.page(name, "collation")
            return CollateRequest(
                layout=page, columns=columns, table=found, collated=collated, only=self.only, **words
            )
        page = layout_of("formulas" if name == "collation" else name, ("formulas",), self.layouts)
        return FormulaRequest(
            layout=page, columns=columns, table=found, collated=collated, only=self.only, **words
        )


collate = function(CollateOptions, "collate")


class ExampleOptions(WordedPage, CommandOptions):
    """Print a worked example of a book in its steps: each figure as printed, and what it should be.

    With numbers of one's own the same steps are worked with these. Without NUMBER the examples are listed.

    \b
    kurbel example  # all there are
    kurbel example blau 33  # one of them
    kurbel example blau 33 --ratio 1:4,5  # your own number
    \f
    >>> import kurbel
    >>> print(kurbel.typeset(kurbel.example("blau", 35), "csv").splitlines()[-1])
    ,"cos α = −5/2, unbrauchbar",other,cos α,−5/2,−5/2,
    """

    topic = "question"

    builder = "kurbel.books.example_page:build_example"
    unnamed = "book number"
    sequence = "ratio angle beam eps back force"
    in_short = "ratio angle force eps back"

    book = word("The book, as `kurbel example` lists it.", kind=Source(), positional=True)
    number = word("The number of the example.", kind=ExampleNumber(), positional=True)
    ratio = Linked.ratio.read_as(alone(as_ratios))
    angle = Angles.angle.read_as(
        alone(as_angles),
        help="Crank angles in degrees, where the example starts from them: 60, lists '30;60'.",
    )
    beam = measure(
        as_numbers,
        "Arm of the beam in crank radii: 3; lists '3;4'.",
        "A:R",
        many=True,
        what="beam arm",
        topic="linkage",
    )
    eps = measure(
        alone(as_expansions), "Expansion ratio ε: 4; lists '2;4', ranges 2..6.", "ε", many=True, topic="steam"
    )
    back = measure(
        as_share,
        "Back pressure R/Q: 0.1, 10%; default: the best, 1/ε.",
        "B",
        what="back pressure",
        topic="steam",
    )
    force = measure(alone(as_force), "Piston force, for newtons: 10kN.", "FORCE", unit="N", topic="piston")

    def question(self) -> ExampleRequest:
        book, number = self.book, self.number
        if book is None or number is None:
            raise ProblemError("name an example by its book and its number, as kurbel example lists them")
        own = {
            "ratio": self.ratio,
            "angle": self.angle,
            "beam": self.beam,
            "eps": self.eps,
            "back": None if self.back is None else (self.back,),
            "force": None if self.force is None else (self.force,),
        }
        return ExampleRequest(
            book=book,
            number=str(number),
            own={name: values for name, values in own.items() if values is not None},
            **self.worded(),
        )


example = function(ExampleOptions, "example")
