"""How a page is printed: its layout, its columns, its language, its digits, and words of one's own."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from os import PathLike
from types import MappingProxyType
from typing import TYPE_CHECKING, TypedDict

from kurbel.commands.options import PROSE, Choice, Columns, Count, LayoutName, Option, file, word
from kurbel.commands.part import Part
from kurbel.errors import ProblemError
from kurbel.exact.numerals import MOST_DIGITS, ROUNDINGS
from kurbel.page.layouts import LANGUAGES, Layout, layout, layout_of
from kurbel.reading.given import as_names

if TYPE_CHECKING:
    from kurbel.page.table import Note
    from kurbel.reading.amounts import Units

# Units that are of the drive itself, and what has units in its text or its file.
UNITLESS = ("", "degrees", "R", "rod lengths")
MEASURED = ("areas", "area_scale", "card", "cylinder", "hole", "rod_file", "torque_file", "load_torque_file")
LISTED = "; `kurbel quantities` lists them. What tells rows apart is always among them."


def columns_option(
    usual: str, example: str, more: str = LISTED, chosen: Mapping[str, str] = MappingProxyType({})
) -> Option[Sequence[str]]:
    """Return --columns of a command, whose columns are by default those of a layout, or of another that is
    `chosen` by an option."""
    return Option(
        f"Columns and their order: {example}{more}",
        "NAMES",
        Columns(usual, chosen=chosen),
        many=True,
        default=(),
        whole=True,
        topic="page",
    )


def columns_over_angle(usual: str, example: str, **chosen: str) -> Option[Sequence[str]]:
    """Return the same of a command over the crank angle."""
    return columns_option(usual, example, f"{LISTED} Pages keep φ at the left.", chosen)


def layout_option(*subjects: str) -> Option[str | None]:
    return word("Page layout; `kurbel layouts` lists them.", kind=LayoutName(subjects), topic="page")


class Words(TypedDict, total=False):
    """The words of a page, by the fields of `kurbel.page.subject:Question`."""

    lang: str
    label: str
    caption: str | None
    note: tuple[Note, ...]
    source: str | None
    templates: str | PathLike[str] | None


class PagePrinting(Words, total=False):
    """How a question has its page printed, by the fields of `kurbel.page.subject:Question`."""

    digits: int | None
    rounding: str
    units: Units | None


class ColumnPrinting(PagePrinting):
    """The same, with the layout and the columns of the question."""

    layout: Layout
    columns: tuple[str, ...]


class Layouts(Part):
    """Which page of those that a command has."""

    topic = "page"

    layouts = file(
        "Folder with layouts of your own: DIR/<name>/layout.toml.", "DIR",
        environment="KURBEL_LAYOUTS", first=True,
    )  # fmt: skip
    layout: Option[str | None] = layout_option()

    def page(self, usual: str, *subjects: str) -> Layout:
        """Return the layout, or the usual one. Raises LayoutError for one about anything else."""
        return layout_of(self.layout or usual, subjects, self.layouts)

    @property
    def layout_subject(self) -> str:
        """What the layout is about, nothing where none is named."""
        name = self.layout
        return layout(name, self.layouts).subject if name else ""


class WordedPage(Part):
    """The words of a page, and its look."""

    topic = "page"

    lang: Option[str] = word(
        "Language of headings and captions: de or en.", kind=Choice("language", LANGUAGES),
        environment="KURBEL_LANG", default="de", last=True,
    )  # fmt: skip
    label = word(
        "Name for cross references: \\label{tab:NAME}; default: the layout's.",
        "NAME",
        PROSE,
        default="",
        last=True,
    )
    caption = word(
        "Caption of your own, formulas between dollar signs: 'Weg $x/R$'.",
        "TEXT",
        PROSE,
        last=True,
        whole=True,
    )
    note: Option[tuple[Note, ...]] = Option(
        "A note of your own below those of the page; [^a] before it is its mark, also in captions.", "TEXT",
        PROSE, many=True, default=(), last=True, whole=True,
    )  # fmt: skip
    source = word(
        "Line of your own on the source, in place of the page's; '' leaves it out.",
        "TEXT",
        PROSE,
        last=True,
        whole=True,
    )
    templates = file(
        "Folder with templates of your own: DIR/base/latex.jinja sets all pages in LaTeX,"
        " DIR/NAME/latex.jinja those of a layout.",
        "DIR", environment="KURBEL_TEMPLATES", last=True,
    )  # fmt: skip

    def worded(self) -> Words:
        """Return the words of the page, and its templates."""
        return {
            "lang": self.lang, "label": self.label, "caption": self.caption, "note": self.note,
            "source": self.source, "templates": self.templates,
        }  # fmt: skip


class PlainPrinting(WordedPage):
    """How a page is printed."""

    topic = "page"

    columns: Option[Sequence[str]] = columns_option("", "")
    digits: Option[int | None] = Option(
        f"Decimals of every column, 0 to {MOST_DIGITS}.",
        "N",
        Count("digits", 0, MOST_DIGITS, "cannot be printed"),
        last=True,
    )
    rounding = word(
        "What becomes of a tie.", kind=Choice("rounding", ROUNDINGS), default="half-away", last=True
    )

    def names(self, example: str) -> tuple[str, ...]:
        """Return the columns that are asked for."""
        return as_names(self.columns, example)

    def printed(self) -> PagePrinting:
        """Return how the page is to be printed."""
        return {**self.worded(), "digits": self.digits, "rounding": self.rounding, "units": None}

    def on_page(self, page: Layout, example: str) -> ColumnPrinting:
        """Return the same with the layout and the columns that are asked for."""
        return {"layout": page, "columns": self.names(example), **self.printed()}


class Sheet(PlainPrinting):
    """The same of one whose columns have units."""

    topic = "page"

    units: Option[Units | None] = Option(
        "Units of pages and data: metric, imperial or a list, 'cm;kN'. Default: metric; pages of what is"
        " given in imperial units alone have these.",
        "UNITS",
        PROSE,
        last=True,
    )

    def printed(self) -> PagePrinting:
        if self.values.typed("units") and not self.says(*self._measured()):
            raise ProblemError(
                "--units are those of lengths, forces and speeds, and without any the page is in units of its"
                " drive; give one, such as --stroke 600mm, or leave --units out"
            )
        return {**super().printed(), "units": self.units}

    def _measured(self) -> Iterator[str]:
        """Yield the options whose values have units."""
        for option in self.options().values():
            if option.unit not in UNITLESS or option.name in MEASURED:
                yield option.name
