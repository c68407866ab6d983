"""What books print, against what it should be: their tables, and their worked examples."""

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Annotated, Any

from kurbel.books.verdict import ONLY
from kurbel.commands import parameters as option
from kurbel.commands.options import FILE, Choice, Columns, Kind, Option
from kurbel.commands.subject import makes_table
from kurbel.errors import ProblemError
from kurbel.page.layouts import layout_of
from kurbel.reading import notation
from kurbel.reading.given import (
    Exact,
    as_angles,
    as_expansions,
    as_force,
    as_fraction,
    as_names,
    as_numbers,
    as_ratios,
    as_share,
)

if TYPE_CHECKING:
    from kurbel.books.collate_page import CollateRequest
    from kurbel.books.examples.page import ExampleRequest
    from kurbel.books.formulas.page import FormulaRequest


class Source(Kind):
    """The key of a source; the page itself refuses a wrong one."""

    def known(self, typed: Mapping[str, Any]) -> Iterable[str]:
        from kurbel.books.examples.source import source_keys

        return source_keys()


class ExampleNumber(Kind):
    """The number of an example; which there are depends on the source."""

    def known(self, typed: Mapping[str, Any]) -> Iterable[str]:
        from kurbel.books.examples.source import numbers_of, source_keys

        return numbers_of(typed["book"]) if typed.get("book") in source_keys() else ()


@makes_table()
def collation_table(
    table: Annotated[
        str | None, Option("A table of a book, as `kurbel sources` lists it.", positional=True)
    ] = None,
    *,
    csv: Annotated[
        option.Path | None,
        Option("Your own transcription: phi, epsilon or arm, and printed values.", "FILE", FILE),
    ] = None,
    quantity: Annotated[
        str | None, Option("With --csv: what is printed, such as x, c, p or delta.", "KEY")
    ] = None,
    ratio: Annotated[
        Exact | None, Option("With --csv: crank ratio, such as 1:4,5.", "R:L", short="-r")
    ] = None,
    method: Annotated[
        str | None,
        Option("With --csv: exact (default), series, infinite, weisbach, approximate.", "METHOD"),
    ] = None,
    only: Annotated[
        str, Option("all, or deviations: what is not right.", kind=Choice("choice", ONLY))
    ] = "all",
    columns: Annotated[
        option.Names,
        Option(
            "Keys of CSV and JSON and their order: place,printed,recomputed,verdict.",
            "NAMES",
            Columns("collation"),
            many=True,
        ),
    ] = (),
    sources: Annotated[
        option.Path | None, Option("A folder with books of your own, a folder each.", "DIR", FILE)
    ] = None,
    layouts: option.Layouts = None,
    layout: Annotated[str, option.layout_option("collation")] = "collation",
    lang: option.Lang = "de",
    label: option.Label = "",
    caption: option.Caption = None,
    note: option.Notes = (),
    source: option.SourceLine = None,
    templates: Annotated[option.Path | None, option.TEMPLATES] = None,
) -> "CollateRequest | FormulaRequest":
    """Print a table of a book, or your own transcription, with the values that it should have.

    Of formulas it prints whether each follows from the one before.

    \b
    kurbel collate roetscher-112
    kurbel collate weisbach-150 --only deviations --lang en
    kurbel collate blau-equations
    kurbel collate --csv scan.csv --quantity p --ratio 1:4 --method series --strict
    \f
    >>> import kurbel
    >>> page = kurbel.collation_table(
    ...     "blau-32", only="deviations", columns="place,printed,recomputed,verdict"
    ... )
    >>> print(kurbel.typeset(page, "csv"), end="")
    place,printed,recomputed,verdict
    x_45,"0,356","0,355",last_place
    """
    from kurbel.books.collate_page import CollateRequest
    from kurbel.books.formulas.table import FormulaTable
    from kurbel.books.transcription import collated_table

    if csv is not None and table is not None:
        raise ProblemError("--csv is a table of your own, and one of a book is named too; leave one out")
    text = ratio if ratio is None or isinstance(ratio, str) else notation.ratio_text(as_fraction(ratio))
    found, collated = collated_table(table, csv, quantity, text, method, sources)
    asked: Mapping[str, Any] = {
        "table": found,
        "collated": collated,
        "only": only,
        "columns": as_names(columns, "place,printed,recomputed"),
        "lang": lang,
        "label": label,
        "caption": caption,
        "note": note,
        "source": source,
        "templates": templates,
    }
    if not isinstance(found, FormulaTable):
        return CollateRequest(layout=layout_of(layout, ("collation",), layouts), **asked)
    from kurbel.books.formulas.page import FormulaRequest

    own = "formulas" if layout == "collation" else layout
    return FormulaRequest(layout=layout_of(own, ("formulas",), layouts), **asked)


@makes_table(build="kurbel.books.examples.page:build_example")
def example_table(
    book: Annotated[
        str | None, Option("The book, as `kurbel example` lists it.", kind=Source(), positional=True)
    ] = None,
    number: Annotated[
        str | int | None, Option("The number of the example.", kind=ExampleNumber(), positional=True)
    ] = None,
    *,
    ratio: option.Ratios = None,
    angle: Annotated[
        option.Given | None,
        option.ANGLE._replace(
            help="Crank angles in degrees, where the example starts from them: 60, lists '30;60'."
        ),
    ] = None,
    beam: Annotated[
        option.Given | None, Option("Arm of the beam in crank radii: 3; lists '3;4'.", "A:R", many=True)
    ] = None,
    eps: Annotated[
        option.Given | None,
        option.EPS._replace(help="Expansion ratio ε: 4; lists '2;4', ranges 2..6."),
    ] = None,
    back: Annotated[
        Exact | None,
        option.BACK._replace(help="Back pressure R/Q: 0.1, 10%; default: the best, 1/ε."),
    ] = None,
    force: Annotated[Exact | None, option.FORCE._replace(help="Piston force, for newtons: 10kN.")] = None,
    lang: option.Lang = "de",
    label: option.Label = "",
    caption: option.Caption = None,
    note: option.Notes = (),
    source: option.SourceLine = None,
    templates: Annotated[option.Path | None, option.TEMPLATES] = None,
) -> "ExampleRequest":
    """Print a worked example of a book in its steps: each figure as printed, and what it should be.

    With numbers of one's own the same steps are worked with these. Without NUMBER the examples are listed.

    \b
    kurbel example
    kurbel example blau 33
    kurbel example blau 33 --ratio 1:4,5
    \f
    >>> import kurbel
    >>> print(kurbel.typeset(kurbel.example_table("blau", 35), "csv").splitlines()[-1])
    ,"cos α = −5/2, unbrauchbar",other,cos α,−5/2,−5/2,
    """
    from kurbel.books.examples.page import ExampleRequest

    if book is None or number is None:
        raise ProblemError("name an example by its book and its number, as kurbel example lists them")
    own: dict[str, Sequence[Fraction]] = {}
    if ratio is not None:
        own["ratio"] = as_ratios(ratio)
    if angle is not None:
        own["angle"] = as_angles(angle)
    if beam is not None:
        own["beam"] = as_numbers(beam, "beam arm")
    if eps is not None:
        own["eps"] = as_expansions(eps)
    if back is not None:
        own["back"] = (as_share(back, "back pressure"),)
    if force is not None:
        own["force"] = (as_force(force),)
    words: Mapping[str, Any] = {"caption": caption, "note": note, "source": source, "templates": templates}
    return ExampleRequest(
        book=book,
        number=str(number),
        own=own,
        lang=lang,
        label=label,
        **words,
    )
