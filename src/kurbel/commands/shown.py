"""What the functions return: a table and a drawing that show themselves, and can be saved; and how pages and
mechanisms become drawings, which may move with their printed numbers beside them."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from fractions import Fraction
from functools import partial
from typing import TYPE_CHECKING, Any, NamedTuple

from kurbel.commands import frames
from kurbel.commands.part import Origin, Values
from kurbel.commands.parts.drawing import DrawingOptions
from kurbel.drive.crank import Crank
from kurbel.drive.moved import Drive
from kurbel.errors import ChoiceError, ProblemError
from kurbel.exact.numerals import DECIMAL_OF_LANGUAGE, DECIMALS, Label
from kurbel.formats.registry import DEFAULT, DRAWINGS, BytesFormat, for_suffix
from kurbel.formats.render import in_notebook, render, whole_file
from kurbel.page import labels
from kurbel.page.build import shown_at
from kurbel.page.quantity import letter
from kurbel.page.steps import MOST_COLUMNS
from kurbel.page.subject import Question
from kurbel.page.table import Table as Page
from kurbel.reading.given import choose, found_at
from kurbel.reading.names import checks_keywords, spelling_keywords, unknown

if TYPE_CHECKING:
    from kurbel.page.quantity import Column
    from kurbel.page.steps import Scene
    from kurbel.page.table import Value
    from kurbel.plot.animated import FilmSettings, Staged
    from kurbel.plot.drawings import Drawing as Drawn
    from kurbel.plot.film import Film


@checks_keywords
def typeset(
    page: Page,
    format: str = DEFAULT,
    *,
    decimal: str | None = None,
    standalone: bool = False,
    longtable: bool = False,
    siunitx: bool = False,
    plain: bool = False,
    excel: bool = False,
) -> str:
    """Return the page in a format: text, markdown, latex, html, typst, csv, dat or json; no PDF or workbook.

    `decimal` is "comma" or "point", by default the mark of the page's language (point in CSV and JSON);
    `standalone` gives a whole document (LaTeX, HTML, Typst), `longtable` a LaTeX longtable, `siunitx` leaves
    the numbers to that package and `plain` is what an author would type, in LaTeX, and `excel` gives CSV as
    Excel opens it. Raises KurbelError.

    >>> from kurbel import table
    >>> print(typeset(table("1:4", layout="blau-kolbenwege", angle=90), "markdown").splitlines()[-3])
    |     90 |         1,125 |             0,563 |
    """
    if not isinstance(page, Page):
        raise ProblemError(f"a {type(page).__name__} cannot be set; make a page, such as kurbel.table()")
    if format in DRAWINGS:
        raise ChoiceError(
            f'{format} is a drawing; write page.plot().image("{format}"), or page.save with a file'
        )
    return render(
        page,
        format,
        decimal=decimal,
        standalone=standalone,
        longtable=longtable,
        siunitx=siunitx,
        plain=plain,
        excel=excel,
    )


@dataclass(frozen=True, slots=True, repr=False)
class Table(Page):
    """A table with its certified digits.

    `print` shows it as text and a notebook as HTML; `save` writes it in any format. It has as many rows as
    records, named tuples of floats and text, and `page["x"]` is the array of a column; pandas and polars make
    a DataFrame of it. With `exact` their numbers are Decimal, as printed. Crank ratios are text. `plot` draws
    its columns over their axis.
    """

    asked: Question | None = None
    typeset = typeset
    to_numpy = frames.to_numpy
    to_pandas = frames.to_pandas
    to_polars = frames.to_polars
    __len__ = frames.count
    __iter__ = frames.rows
    __getitem__ = frames.column

    @classmethod
    def of(cls, page: Page, asked: Question | None = None) -> Table:
        return cls(**{field.name: getattr(page, field.name) for field in fields(page)}, asked=asked)

    @checks_keywords
    def plot(self, *, decimal: str | None = None, **options: object) -> Drawing:
        """Return the page as a drawing: a panel a unit, both strokes as one turn.

        Options are width and height in mm, polar, over_path, infinite, animate and seconds, as the command
        line has them. Raises KurbelError for what cannot be drawn.
        """
        if self.asked is None:
            raise ProblemError("this page was not made by a command of kurbel, so it has nothing to draw")
        return plotted(self.asked, options, decimal)

    def __str__(self) -> str:
        return self.typeset()

    def __repr__(self) -> str:
        return f"<kurbel.Table {self.key}: {labels.plain(self.caption)}>"

    @checks_keywords
    def save(
        self,
        path: str | os.PathLike[str],
        *,
        decimal: str | None = None,
        standalone: bool = False,
        longtable: bool = False,
        siunitx: bool = False,
        plain: bool = False,
        excel: bool = False,
    ) -> None:
        """Write the page into a file, whole or not at all, in the format of its suffix.

        An interactive one is a whole document; .svg, .png and .pgf are its drawing. Raises KurbelError.
        """
        if os.path.splitext(os.fspath(path))[1].lower()[1:] in DRAWINGS:
            self.plot(decimal=decimal).save(path)
            return
        standalone = standalone or self.steps is not None
        form = for_suffix(os.fspath(path))
        if isinstance(form, BytesFormat):
            content = form.content(self, decimal)
        else:
            content = self.typeset(
                form.name,
                decimal=decimal,
                standalone=standalone,
                longtable=longtable,
                siunitx=siunitx,
                plain=plain,
                excel=excel,
            ).encode()
        with whole_file(os.fspath(path)) as stream:
            stream.write(content)

    @property
    def columns(self) -> list[str]:
        """The keys of the columns, as those of a DataFrame."""
        return [field.key for field in self.records.fields]

    def __bool__(self) -> bool:
        return True

    def _repr_html_(self) -> str:
        # A notebook runs no script of a page.
        return in_notebook(replace(self, steps=None))

    def _repr_latex_(self) -> str:
        return self.typeset("latex")

    def _repr_markdown_(self) -> str:
        return self.typeset("markdown")

    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object:
        """Hand the records to any library that takes Arrow; needs the extra `arrow`."""
        return frames.to_arrow(self).__arrow_c_stream__(requested_schema)


@dataclass(frozen=True, slots=True, repr=False)
class Drawing:
    """A drawing: matplotlib's figure and a title. A notebook shows it, `save` writes SVG, PNG, PDF or PGF.

    Of one that has steps or moves `page` makes an HTML page, of its SVG file. One that moves has a film, and
    is saved as GIF as well.
    """

    figure: Any
    title: Label
    lang: str
    mark: str
    about: Label = ""
    page: Callable[[str], str] | None = None
    film: Film | None = None

    @classmethod
    def of(cls, drawn: Drawn, lang: str, mark: str, page: Callable[[str], str] | None = None) -> Drawing:
        return cls(drawn.figure, drawn.title, lang, mark, drawn.about, page, drawn.film)

    def __repr__(self) -> str:
        return f"<kurbel.Drawing: {self.plain_title}>"

    @property
    def plain_title(self) -> str:
        """The title without formulas' marks, for readers that do not see the drawing."""
        return labels.plain(self.title, self.mark)

    def image(self, format: str = "svg", *, text: bool = False) -> bytes:
        """Return the drawing as a file of the format svg, png, pdf or pgf; of SVG with `text` letters stay
        text. A construction in steps has html, too.

        One that moves has html and gif; it stands still in png, pdf and pgf. Raises KurbelError.
        """
        if self.page and format == "html" and (self.film or not text):
            return self.page(self.image(text=text).decode()).encode()
        about = labels.plain(self.about, self.mark)
        if self.film is None:
            from kurbel.plot.style import image

            return image(self.figure, format, self.plain_title, about, text)
        return self._moving_image(format, about, text)

    def _moving_image(self, name: str, about: str, text: bool) -> bytes:
        """Return a drawing that moves as a file; in PNG, PDF and PGF it stands still."""
        from kurbel.plot.film import as_it_stands, moving
        from kurbel.plot.style import FORMATS, MOVING, image, style

        assert self.film is not None
        choose(name, dict.fromkeys((*MOVING, *FORMATS)), "drawing format")
        if name == "gif":
            if text:
                raise ChoiceError(
                    "--text is for SVG, whose letters are outlines without it; leave it out for gif"
                )
            from kurbel.plot.film import gif

            with style():
                return gif(self.figure, self.film)
        if name != "svg":
            with as_it_stands(self.film):
                return image(self.figure, name, self.plain_title, about, text)
        still = image(self.figure, "svg", self.plain_title, about, text).decode()
        return moving(still, self.film, self.figure).encode()

    @checks_keywords
    def save(self, path: str | os.PathLike[str], *, text: bool = False) -> None:
        """Write the drawing into a file, whole or not at all, in the format of its suffix.

        With `text` the letters of SVG stay text, which can be searched and edited. Raises KurbelError.
        """
        from kurbel.plot.style import format_of

        name = os.fspath(path)
        is_page = self.page and name.lower().endswith((".html", ".htm"))
        form = "html" if is_page else format_of(name, moves=self.film is not None)
        content = self.image(form, text=text)
        with whole_file(os.fspath(path)) as stream:
            stream.write(content)

    def _repr_svg_(self) -> str:
        return self.image().decode()


def mark_of(lang: str, decimal: str | None) -> str:
    """Return the decimal mark of that name, by default that of the language."""
    return DECIMALS[choose(decimal or DECIMAL_OF_LANGUAGE[lang], DECIMALS, "decimal mark")]


class SpokenQuantity(NamedTuple):
    """A quantity beside a drawing: its name, symbol and unit, and its printed numbers, degree by degree."""

    name: Label
    symbol: Label
    unit: Label
    values: tuple[Value, ...]


def drawing_of(question: Question, options: DrawingOptions, decimal: str | None = None) -> Drawing:
    """Return what is asked for as a drawing: the columns of its page over their axis. Raises KurbelError."""
    from kurbel.plot.drawings import drawn, picture

    mark, turn, wish = mark_of(question.lang, decimal), options.turn, options.wish
    found = picture(question, wish)
    shot = None if turn is None else shot_of(turn, found.question)
    made = drawn(found, mark, options.size, shot)
    page = None if shot is None else paged(made, question.lang, mark, spoken(found.question, found.columns))
    return Drawing.of(made, question.lang, mark, page)


def plotted(question: Question, options: Mapping[str, object], decimal: str | None) -> Drawing:
    """Return the same by options in the words of Python. Raises KurbelError."""
    known = DrawingOptions.options()
    for name in options:
        if name not in known:
            raise unknown("Table.plot", name, known, "kurbel forces --help drawing lists them")
    with spelling_keywords(dict):
        given = {name: known[name].taken(value) for name, value in options.items() if value is not None}
        values = {name: one.default for name, one in known.items()} | given
        return drawing_of(
            question, DrawingOptions(Values(values, dict.fromkeys(given, Origin.TYPED))), decimal
        )


def shot_of(seconds: float, question: Question) -> FilmSettings:
    """Return how the drawing of a question is to move, with the mechanism of a single drive."""
    from kurbel.plot.animated import FilmSettings

    angles = getattr(question, "angles", ())
    if not angles:
        raise ProblemError(
            "a drawing that moves runs through crank angles, and this page stands over something else; leave"
            " --animate out"
        )
    span = float(angles[-1] - angles[0])
    seconds *= max(1.0, span / 360)
    # A diagram of torques has no drive, and of several cranks none is that of the drawing.
    moving, first = question.moving, getattr(question, "first", None)
    several = (getattr(question, "ratios", ()), getattr(question, "cranks", ()), getattr(first, "parts", ()))
    alone = all(len(one) < 2 for one in several)
    if moving is None or not alone:
        return FilmSettings(seconds)
    return FilmSettings(seconds, partial(carrying, question, staged(moving[0], moving[1])))


def staged(name: str, drive: Drive) -> Staged:
    """Return what a mechanism of this name looks like at crank angles."""
    from kurbel.motion.mechanism import mechanism

    # What acts on a drive is nothing to its way.
    bare = drive.of(Crank(drive.crank.ratio, drive.crank.offset))
    return partial(found_at(mechanism(name).moving), bare)


def carrying(question: Question, show: Staged, *angles: Sequence[float]) -> Scene | None:
    """Return what moves with what a question shows of it besides."""
    return question.carrying(show(*angles), show)


def spoken(question: Any, columns: Sequence[Column] = ()) -> tuple[SpokenQuantity, ...]:
    """Return the printed numbers of a question at whole degrees of its run; none of several drives. Their
    names and units may be those of other columns, one for each of its own."""
    if any(axis.size > 1 for name, axis in question.axes.items() if name not in ("angle", "column")):
        return ()
    first, last = question.angles[0], question.angles[-1]
    angles = tuple(Fraction(angle) for angle in range(int(first), int(last) + 1))
    asked = replace(question, angles=angles)
    none = dict.fromkeys(asked.axes, 0)
    found = []
    for number, column in enumerate(asked.page_columns[:MOST_COLUMNS]):
        one = columns[number].quantity if columns else column.quantity
        places = ({**none, "angle": place, "column": number} for place in range(len(angles)))
        values = tuple(shown_at(asked, column, place) for place in places)
        said = letter(one, asked.lang)
        found.append(SpokenQuantity(said.name, said.symbol, one.unit_beside(asked.lang), values))
    return tuple(found)


def paged(drawn: Drawn, lang: str, mark: str, numbers: tuple[SpokenQuantity, ...]) -> Callable[[str], str]:
    """Return what makes an HTML page of the SVG file of a drawing that moves, with numbers beside it."""

    def page(svg: str) -> str:
        from kurbel.formats.html.live import film_page

        return film_page(svg, drawn.title, lang, mark, numbers)

    return page
